// Bundles test/page with each bundler, then opens it, and the unbundled package, in a browser: node bundlers.mjs [CHROMIUM]
// Runs in a copy of test/page in which the package and the bundlers are installed.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join } from "node:path";

const page = process.cwd();
const [chromium] = process.argv.slice(2);
const expected = "5551759.400 63758202715511 6378137 1 47e66e1000000000";
const bin = (name) => join(page, "node_modules/.bin", name);
const bundle = (name, ...given) => execFileSync(bin(name), given, { cwd: page, stdio: ["ignore", "ignore", "inherit"] });

// esbuild leaves files beside a module where they are, so it bundles the modules with the bytes inside.
const inline = readFileSync(join(page, "page.js"), "utf8").replaceAll(/"(terrella\/\w+)"/g, '"$1/inline"');
writeFileSync(join(page, "inline.js"), inline);
bundle("esbuild", "inline.js", "--bundle", "--format=esm", "--platform=node", "--outfile=esbuild/node.mjs", "--log-level=error");
assert.equal(execFileSync("node", [join(page, "esbuild/node.mjs")], { encoding: "utf8" }).trim(), expected);
console.log("esbuild, run by Node: right");
bundle("esbuild", "inline.js", "--bundle", "--format=esm", "--outfile=esbuild/page.js", "--log-level=error");
copyFileSync(join(page, "index.html"), join(page, "esbuild/index.html"));

bundle("vite", "build", "--outDir", "vite", "--base", "./", "--target", "es2022", "--logLevel", "error");

mkdirSync(join(page, "webpack"), { recursive: true });
bundle("webpack", "./page.js", "--mode", "production", "--output-path", join(page, "webpack"), "--output-filename", "page.js", "--output-public-path", "auto", "--stats", "errors-only");
copyFileSync(join(page, "index.html"), join(page, "webpack/index.html"));

// The package as it is, by an import map.
const entries = ["area", "cube", "geodesic", "position", "terrain"];
const imports = Object.fromEntries(entries.map((entry) => [`terrella/${entry}`, `./node_modules/terrella/${entry}.entry.js`]));
imports["#bytes"] = "./node_modules/terrella/bytes.js";
const map = `<script type="importmap">${JSON.stringify({ imports })}</script>`;
writeFileSync(join(page, "plain.html"), readFileSync(join(page, "index.html"), "utf8").replace("<script", `${map}\n<script`));

if (!chromium) {
  console.log("NOT CHECKED: the package in a browser, and what vite and webpack made: there is no Chromium");
  process.exit();
}
const types = { ".html": "text/html", ".js": "text/javascript", ".wasm": "application/wasm" };
const server = createServer((request, response) => {
  try {
    const path = new URL(request.url, "http://localhost").pathname;
    const bytes = readFileSync(join(page, path));
    response.writeHead(200, { "content-type": types[extname(path)] ?? "application/octet-stream" }).end(bytes);
  } catch {
    response.writeHead(404).end();
  }
});
await new Promise((ready) => server.listen(0, ready));
const { default: puppeteer } = await import("puppeteer-core");
const browser = await puppeteer.launch({ executablePath: chromium, args: ["--no-sandbox"] });
for (const [name, path] of [["plain", "plain.html"], ["esbuild", "esbuild/index.html"], ["vite", "vite/index.html"], ["webpack", "webpack/index.html"]]) {
  const tab = await browser.newPage();
  const errors = [];
  tab.on("pageerror", (error) => errors.push(error));
  await tab.goto(`http://localhost:${server.address().port}/${path}`);
  await tab.waitForFunction(() => document.title !== "nothing yet", { timeout: 20_000 }).catch(() => {});
  assert.deepEqual([await tab.title(), ...errors], [expected], name);
  console.log(`${name}, in ${await browser.version()}: right`);
}
await browser.close();
server.close();
