// SPDX-License-Identifier: Apache-2.0
// Texts of scenes and of the files that they name. Raw graymaps (P5) are not text: they become plain graymaps (P2) with
// the same values, which the scene's reader also accepts.
const HEADER = /^P5\s+(?:#[^\n]*\n\s*)*(\d+)\s+(?:#[^\n]*\n\s*)*(\d+)\s+(?:#[^\n]*\n\s*)*(\d+)\s/;
const LONGEST_HEADER = 65536;

/** Returns null for any other file. */
function plainGraymap(bytes: Uint8Array): string | null {
  const begin = new TextDecoder("latin1").decode(bytes.subarray(0, LONGEST_HEADER));
  const header = HEADER.exec(begin);
  if (header === null) return null;
  const [width, height, white] = header.slice(1).map(Number);
  const wide = white > 255;
  const values: number[] = [];
  const end = bytes.length - (wide ? 1 : 0);
  for (let k = header[0].length; k < end && values.length < width * height; k += wide ? 2 : 1)
    values.push(wide ? 256 * bytes[k] + bytes[k + 1] : bytes[k]);
  return `P2\n${width} ${height}\n${white}\n${values.join("\n")}\n`;
}

export function textOf(bytes: Uint8Array): string {
  try {
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    return plainGraymap(bytes) ?? new TextDecoder("utf-8", { ignoreBOM: true }).decode(bytes);
  }
}
