// SPDX-License-Identifier: Apache-2.0
// Bytes in the form that the module reads: numbers, and texts with their lengths in front (lab/wasm/host.h).

const encoder = new TextEncoder();

export interface Bytes {
  data: Uint8Array;
  view: DataView;
  size: number;
}

export function emptyBytes(): Bytes {
  const data = new Uint8Array(1024);
  return { data, view: new DataView(data.buffer), size: 0 };
}

function reserve(bytes: Bytes, more: number): void {
  if (bytes.size + more <= bytes.data.length) return;
  const data = new Uint8Array(2 * (bytes.size + more));
  data.set(bytes.data.subarray(0, bytes.size));
  bytes.data = data;
  bytes.view = new DataView(data.buffer);
}

/** Adds a whole number of 32 bits. */
export function addWhole(bytes: Bytes, value: number): void {
  reserve(bytes, 4);
  bytes.view.setUint32(bytes.size, value, true);
  bytes.size += 4;
}

/** Adds text as UTF-8, or bytes verbatim. */
export function addText(bytes: Bytes, text: string | Uint8Array): void {
  const encoded = typeof text === "string" ? encoder.encode(text) : text;
  addWhole(bytes, encoded.length);
  reserve(bytes, encoded.length);
  bytes.data.set(encoded, bytes.size);
  bytes.size += encoded.length;
}

export const taken = (bytes: Bytes): Uint8Array => bytes.data.subarray(0, bytes.size);
