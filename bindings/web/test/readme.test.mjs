// Runs the README's examples: what stands before `// → text` gives that text.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";

const readme = readFileSync(new URL("../node_modules/terrella/README.md", import.meta.url), "utf8");
const examples = [...readme.matchAll(/```js\n(.*?)```/gs)].map(([, code]) => code);
assert.ok(examples.length > 5);

globalThis.shows = (value, text) => assert.equal(String(value), text);
examples.forEach((code, index) => {
  test(code.match(/(?<=from ").*(?=")/)[0], async () => {
    const file = new URL(`../example-${index}.mjs`, import.meta.url);
    writeFileSync(file, code.replaceAll(/^(.*); \/\/ → (.*)$/gm, (_, value, text) => `shows(${value}, ${JSON.stringify(text)});`));
    await import(file);
  });
});
