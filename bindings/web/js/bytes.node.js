import { readFile } from "node:fs/promises";

/** The bytes of a file beside the package's: Node fetches no files. */
export const bytes = (url) => (url.protocol === "file:" ? readFile(url) : fetch(url).then((response) => response.arrayBuffer()));
