// SPDX-License-Identifier: Apache-2.0
// The lab's page in Debian's Chromium, as a user opens it: from a file, without any server. Whatever the page asks of
// the network, and whatever it says on its console as an error, fails the test that opened it.
import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";

const PAGE = process.env.AVO_LAB_PAGE; // the built page
const HANG = 1_200_000; // ms: no wait is shorter, so that a busy machine fails no test
// playwright-core is one of the lab's packages; a test may lie elsewhere than they do
const { chromium } = createRequire(pathToFileURL(`${process.env.AVO_LAB_SOURCE}/package.json`))("playwright-core");

export async function launch() {
  return chromium.launch({
    timeout: HANG,
    executablePath: process.env.AVO_CHROMIUM ?? "/usr/bin/chromium",
    // No processor of graphics is needed: SwiftShader draws. Chromium puts the page together without it, which is quicker.
    args: ["--no-sandbox", "--disable-gpu-compositing", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
  });
}

/** Of the file at `path`: the page, once its first picture is there. */
export async function open(browser, { path = PAGE, hash = "", width = 1280, height = 800, ...context } = {}) {
  const page = await (await browser.newContext({ viewport: { width, height }, deviceScaleFactor: 1, ...context })).newPage();
  page.setDefaultTimeout(HANG); // also of navigation
  const faults = [];
  page.on("request", (request) => {
    if (!/^(file|data|blob):/.test(request.url())) faults.push(`a request of ${request.url()}`);
  });
  page.on("pageerror", (error) => faults.push(`an error: ${error.message}`));
  page.on("console", (message) => {
    if (message.type() === "error") faults.push(`on the console: ${message.text()}`);
  });
  await page.goto(pathToFileURL(path).href + hash);
  await page.waitForFunction(() => window.avoLab?.ready !== undefined);
  await page.evaluate(() => window.avoLab.ready);
  await frames(page, 2);
  return { page, faults };
}

export async function close({ page, faults }) {
  await page.context().close();
  assert.deepEqual(faults, []);
}

/** Waits until the page has drawn so many times. */
export async function frames(page, count) {
  await page.evaluate(async (n) => {
    for (let k = 0; k < n; ++k) await new Promise((drawn) => requestAnimationFrame(drawn));
  }, count);
}

/** The library's hash of what is shown, as the command line prints it. */
export async function stateHash(page) {
  return page.evaluate(() => `0x${window.avoLab.live.stateHash().toString(16).padStart(16, "0")}`);
}

export async function steps(page, count) {
  await page.evaluate((n) => {
    for (let k = 0; k < n; ++k) window.avoLab.stepForward();
  }, count);
}

/** Pixels of a place in the world, m. */
export async function pixelsOf(page, place) {
  return page.evaluate((at) => window.avoLab.toScreen(at), place);
}

export async function openText(page, text, name = "scene") {
  await page.evaluate(([yaml, called]) => window.avoLab.openText(yaml, called), [text, name]);
}
