// SPDX-License-Identifier: Apache-2.0
// Makes the npm package: the binding as one JavaScript module, its types, and the WebAssembly module.
//   node package.mjs --wasm build/wasm/avo.wasm --out build/npm
import { execFileSync } from "node:child_process";
import { cp, mkdir, readdir, readFile, rm, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { build } from "esbuild";

const HERE = dirname(fileURLToPath(import.meta.url));
const { values: options } = parseArgs({
  options: {
    wasm: { type: "string", default: join(HERE, "../build/wasm/avo.wasm") },
    out: { type: "string", default: join(HERE, "../build/npm") },
  },
});
const dist = join(options.out, "dist");
await rm(options.out, { recursive: true, force: true });
await mkdir(dist, { recursive: true });

await build({
  entryPoints: [join(HERE, "avo/avo.ts")],
  outfile: join(dist, "avo.js"),
  bundle: true,
  format: "esm",
  target: "es2022",
  external: ["yaml"],
  legalComments: "none",
  logLevel: "warning",
});
execFileSync(process.execPath, [
  join(HERE, "node_modules/typescript/bin/tsc"), "-p", join(HERE, "tsconfig.package.json"), "--outDir", dist,
], { stdio: "inherit" });
for (const name of await readdir(dist)) {  // declarations name each other as they will be found there
  if (!name.endsWith(".d.ts")) continue;
  const text = await readFile(join(dist, name), "utf8");
  await writeFile(join(dist, name), text.replace(/(from ")(\.\/\w+)\.ts"/g, '$1$2.js"'));
}
await cp(options.wasm, join(dist, "avo.wasm"));
for (const name of ["package.json", "README.md"]) await cp(join(HERE, "avo", name), join(options.out, name));
