// SPDX-License-Identifier: Apache-2.0
// The checksum of HDF5's metadata: Jenkins' lookup3, hashlittle(), with initial value 0.
import { type ByteReader, refuse } from "./bytes.ts";

const rotated = (x: number, by: number) => (x << by) | (x >>> (32 - by));

/** Returns four bytes; bytes beyond the end are 0. */
function word(bytes: Uint8Array, at: number): number {
  return (bytes[at] ?? 0) | ((bytes[at + 1] ?? 0) << 8) | ((bytes[at + 2] ?? 0) << 16) | ((bytes[at + 3] ?? 0) << 24);
}

export function lookup3(bytes: Uint8Array): number {
  let a = (0xdeadbeef + bytes.length) | 0;
  let b = a;
  let c = a;
  let at = 0;
  for (; bytes.length - at > 12; at += 12) {
    a = (a + word(bytes, at)) | 0;
    b = (b + word(bytes, at + 4)) | 0;
    c = (c + word(bytes, at + 8)) | 0;
    a = ((a - c) | 0) ^ rotated(c, 4); c = (c + b) | 0;
    b = ((b - a) | 0) ^ rotated(a, 6); a = (a + c) | 0;
    c = ((c - b) | 0) ^ rotated(b, 8); b = (b + a) | 0;
    a = ((a - c) | 0) ^ rotated(c, 16); c = (c + b) | 0;
    b = ((b - a) | 0) ^ rotated(a, 19); a = (a + c) | 0;
    c = ((c - b) | 0) ^ rotated(b, 4); b = (b + a) | 0;
  }
  if (at === bytes.length) return c >>> 0;
  a = (a + word(bytes, at)) | 0;
  b = (b + word(bytes, at + 4)) | 0;
  c = (c + word(bytes, at + 8)) | 0;
  c = ((c ^ b) - rotated(b, 14)) | 0;
  a = ((a ^ c) - rotated(c, 11)) | 0;
  b = ((b ^ a) - rotated(a, 25)) | 0;
  c = ((c ^ b) - rotated(b, 16)) | 0;
  a = ((a ^ c) - rotated(c, 4)) | 0;
  b = ((b ^ a) - rotated(a, 14)) | 0;
  c = ((c ^ b) - rotated(b, 24)) | 0;
  return c >>> 0;
}

/** The reader must stand behind `what`, which began at `begin`, and in front of its checksum. */
export function requireChecksum(reader: ByteReader, begin: number, what: string): void {
  const covered = reader.bytes.subarray(begin, reader.offset);
  if (reader.u32() !== lookup3(covered)) refuse(`found a damaged ${what}, must be whole`);
}
