// SPDX-License-Identifier: Apache-2.0
// Files as a user brings them: dropped onto the page, and chosen in the browser's own dialog.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import { close, frames, launch, open, pixelsOf } from "./browser.mjs";

let browser, lab;
before(async () => {
  browser = await launch();
  lab = await open(browser);
});
after(async () => {
  await close(lab);
  await browser.close();
});

const sceneAt = (x, more = "") =>
  `version: 1\nrobots:\n  - {position: [${x}, ${x}], goal: [${x + 9}, ${x}]}\n  - {position: [${x + 9}, ${x + 1}], goal: [${x}, ${x + 1}]}\n${more}`;

/** Once the first robot starts there, and a picture shows it. */
async function shownAt(x) {
  await lab.page.waitForFunction((place) => window.avoLab.moment.position[0] === place, x);
  await frames(lab.page, 2);
  assert.equal(await lab.page.evaluate(() => window.avoLab.error?.message ?? null), null);
}

async function drop(name, text) {
  await lab.page.evaluate(([called, content]) => {
    const dataTransfer = new DataTransfer();
    dataTransfer.items.add(new File([content], called));
    const target = document.getElementById("world");
    const send = (type) => target.dispatchEvent(new DragEvent(type, { dataTransfer, bubbles: true, cancelable: true }));
    if (send("dragover")) throw new Error("the page does not take the file");
    if (!document.body.classList.contains("dropping")) throw new Error("the page does not say that it takes files");
    send("drop");
  }, [name, text]);
}

test("a scene that is dropped is shown, wherever it lies", async () => {
  await drop("s.yaml", sceneAt(1));
  await shownAt(1);
  assert.equal(await lab.page.evaluate(() => window.avoLab.name), "s.yaml");
  assert.equal(await lab.page.evaluate(() => document.body.classList.contains("dropping")), false);
  await drop("s.yaml", sceneAt(1000)); // another one of that name
  await shownAt(1000);
  const box = await lab.page.locator("#world").boundingBox();
  for (const place of [[1000, 1000], [1009, 1001]]) {
    const [px, py] = await pixelsOf(lab.page, place);
    assert.ok(px > box.x && px < box.x + box.width && py > box.y && py < box.y + box.height, `(${place}) is at (${px}, ${py})`);
  }
});

test("what the file chooser returns is opened, a scene with its map", async () => {
  const [chooser] = await Promise.all([lab.page.waitForEvent("filechooser"), lab.page.getByRole("button", { name: "Open", exact: true }).click()]);
  assert.ok(chooser.isMultiple());
  const file = (name, text) => ({ name, mimeType: "", buffer: Buffer.from(text) });
  await chooser.setFiles([
    file("hall.map", "type octile\nheight 2\nwidth 2\nmap\n.@\n..\n"),
    file("hall.yaml", sceneAt(20, "obstacles:\n  - {map: maps/hall.map}\n")),
  ]);
  await shownAt(20);
  assert.ok(await lab.page.evaluate(() => window.avoLab.info.walls.length > 0), "the map's walls are there");
});
