// SPDX-License-Identifier: Apache-2.0
// Runs by node what uses the lab's TypeScript: node run.mjs SCRATCH_FOLDER TEST.test.mjs, or SCRIPT.mjs ARGUMENT...
import { spawnSync } from "node:child_process";
import { mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const lab = fileURLToPath(new URL("../../lab/", import.meta.url));
const { build } = createRequire(join(lab, "package.json"))("esbuild");
const [scratch, script] = process.argv.slice(2, 4).map((path) => resolve(path));
mkdirSync(scratch, { recursive: true });
const bundle = join(scratch, basename(script));
await build({
  entryPoints: [script],
  outfile: bundle,
  bundle: true,
  format: "esm",
  platform: "node",
  target: "node18",
  sourcemap: "inline",
  loader: { ".yaml": "text" },
  alias: { yaml: join(lab, "node_modules/yaml/browser/index.js") },  // the code that the page has
  nodePaths: [join(lab, "node_modules")],
  logLevel: "warning",
});
const env = { ...process.env, AVO_LAB: lab, NODE_OPTIONS: "--enable-source-maps" };
const words = script.endsWith(".test.mjs") ? ["--test", bundle] : [bundle, ...process.argv.slice(4)];
const { status } = spawnSync(process.execPath, words, { stdio: "inherit", env });
process.exit(status ?? 1);
