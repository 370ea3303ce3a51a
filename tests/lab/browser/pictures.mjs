// SPDX-License-Identifier: Apache-2.0
// Two pictures compared, as a person would: where they differ by more than what fonts and edges of shapes do from
// machine to machine. The browser reads the PNG files.
const CELL = 8; // pixels a side, over whose means pictures are compared
const FAINT = 24; // of 255: a mean may differ by so much

/** The share of the cells that differ, 0 to 1; 1 where the sizes do. */
export async function difference(browser, one, other) {
  const page = await browser.newPage();
  try {
    return await page.evaluate(compare, [one.toString("base64"), other.toString("base64"), CELL, FAINT]);
  } finally {
    await page.close();
  }
}

async function compare([one, other, cell, faint]) {
  const pixels = async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
    const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
    const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
    const drawing = canvas.getContext("2d");
    drawing.drawImage(bitmap, 0, 0);
    return drawing.getImageData(0, 0, bitmap.width, bitmap.height);
  };
  const a = await pixels(one);
  const b = await pixels(other);
  if (a.width !== b.width || a.height !== b.height) return 1;
  const mean = (image, left, top, channel) => {
    let sum = 0;
    let count = 0;
    for (let y = top; y < Math.min(top + cell, image.height); ++y) {
      for (let x = left; x < Math.min(left + cell, image.width); ++x, ++count) {
        sum += image.data[4 * (y * image.width + x) + channel];
      }
    }
    return sum / count;
  };
  let cells = 0;
  let different = 0;
  for (let top = 0; top < a.height; top += cell) {
    for (let left = 0; left < a.width; left += cell, ++cells) {
      const differs = [0, 1, 2].some((k) => Math.abs(mean(a, left, top, k) - mean(b, left, top, k)) > faint);
      if (differs) ++different;
    }
  }
  return different / cells;
}
