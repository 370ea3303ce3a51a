// SPDX-License-Identifier: Apache-2.0
// Makes the page: one HTML file with everything inside. So it runs from file://, without any server.
//   node build.mjs --wasm build/wasm/avo.wasm --out build/lab/lab.html
import { createHash } from "node:crypto";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { gzipSync } from "node:zlib";
import { build } from "esbuild";

const HERE = dirname(fileURLToPath(import.meta.url));
const { values: options } = parseArgs({
  options: {
    wasm: { type: "string", default: join(HERE, "../build/wasm/avo.wasm") },
    out: { type: "string", default: join(HERE, "../build/lab/lab.html") },
  },
});

/** The text of `entry` and all that it imports. */
async function bundle(entry) {
  const made = await build({
    entryPoints: [join(HERE, "page", entry)],
    bundle: true,
    minify: true,
    write: false,
    format: "iife",
    target: ["chrome110", "firefox115", "safari16.4"],
    charset: "utf8",
    loader: { ".yaml": "text" },
    legalComments: "none",
    logLevel: "warning",
  });
  return made.outputFiles[0].text;
}

/** `text` inside of <script> or <style>, which only their closing tag may end. */
const inside = (text) => text.replace(/<\/(script|style)/gi, "<\\/$1").replace(/<!--/g, "<\\!--");

const [page, script, style, wasm] = await Promise.all([
  readFile(join(HERE, "page/index.html"), "utf8"),
  bundle("main.ts"),
  bundle("style.css"),
  readFile(options.wasm),
]);
const parts = { style: inside(style), script: inside(script), wasm: gzipSync(wasm, { level: 9 }).toString("base64") };
parts.script_hash = createHash("sha256").update(parts.script).digest("base64");  // no other script may run
const html = page.replace(/\{\{(\w+)\}\}/g, (_, part) => parts[part]);
await mkdir(dirname(options.out), { recursive: true });
await writeFile(options.out, html);
const size = (text) => `${(Buffer.byteLength(text) / 1e6).toFixed(2)} MB`;
console.log(`${options.out}: ${size(html)} (module ${size(parts.wasm)}, script ${size(script)}, style ${size(style)})`);
