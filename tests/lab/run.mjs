// SPDX-License-Identifier: Apache-2.0
// Runs a test of the lab's TypeScript by node: node run.mjs SCRATCH_FOLDER TEST.test.mjs
import { spawnSync } from "node:child_process";
import { mkdirSync } from "node:fs";
import { createRequire } from "node:module";
import { basename, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const lab = fileURLToPath(new URL("../../lab/", import.meta.url));
const { build } = createRequire(join(lab, "package.json"))("esbuild");
const [scratch, test] = process.argv.slice(2).map((path) => resolve(path));
mkdirSync(scratch, { recursive: true });
const bundle = join(scratch, basename(test));
await build({
  entryPoints: [test],
  outfile: bundle,
  bundle: true,
  format: "esm",
  platform: "node",
  target: "node18",
  sourcemap: "inline",
  nodePaths: [join(lab, "node_modules")],
  logLevel: "warning",
});
const env = { ...process.env, AVO_LAB: lab, NODE_OPTIONS: "--enable-source-maps" };
const { status } = spawnSync(process.execPath, ["--test", bundle], { cwd: scratch, stdio: "inherit", env });
process.exit(status ?? 1);
