// SPDX-License-Identifier: Apache-2.0
// Attributes of HDF5 objects: texts of fixed length and whole numbers. Other attributes are ignored, as
// io/recording/hdf5_reader.cpp does.
import { ByteReader, hexOf, refuse } from "./bytes.ts";
import { messagesInHeap } from "./hdf5_heap.ts";
import { ATTRIBUTE, ATTRIBUTE_INFO, type Message, readExtent, refuseForeign, requireVersion } from "./hdf5_objects.ts";
import type { Fields } from "./recording_fields.ts";

const MOST_ATTRIBUTES = 100_000;
/** Parts of datatype messages: version and class, bits, size. */
const UNSIGNED_64 = "10 00 00 00 08 00 00 00 00 00 40 00";
const TEXT_CLASS = 3;

function addAttribute(message: Uint8Array, fields: Fields): void {
  const reader = new ByteReader(message, 0, "attribute");
  requireVersion(reader, "attribute", 3);
  if (reader.u8() !== 0) refuseForeign("type of an attribute", "one that is shared", "its own");
  const [nameSize, typeSize, extentSize] = [reader.u16(), reader.u16(), reader.u16()];
  reader.skip(1);  // character set
  const name = new TextDecoder().decode(reader.take(nameSize)).replace(/\0.*$/s, "");
  const type = reader.take(typeSize);
  const extent = readExtent(new ByteReader(reader.take(extentSize), 0, "attribute"));
  if (fields.has(name)) refuse("found an attribute twice, must be once");
  if (extent !== null && extent.length > 0) return;
  if (hexOf(type) === UNSIGNED_64 && extent !== null) {
    fields.set(name, reader.exact64());
  } else if ((type[0] & 0x0f) === TEXT_CLASS) {
    const size = new ByteReader(type, 4, "attribute").u32();
    fields.set(name, extent === null ? new Uint8Array() : reader.take(size));
  }
}

export function readAttributes(file: Uint8Array, messages: Message[]): Fields {
  const bodies = messages.filter(({ type }) => type === ATTRIBUTE).map(({ body }) => body);
  const info = messages.find(({ type }) => type === ATTRIBUTE_INFO);
  if (info !== undefined) {
    const reader = new ByteReader(info.body, 0, "list of attributes");
    requireVersion(reader, "list of attributes", 0);
    if ((reader.u8() & 1) !== 0) reader.skip(2);
    const heap = reader.u64();
    const names = reader.u64();
    if (heap !== Infinity) bodies.push(...messagesInHeap(file, heap, names));
  }
  if (bodies.length > MOST_ATTRIBUTES || bodies.reduce((size, body) => size + body.length, 0) > file.length)
    refuse("found more attributes than there can be, damaged");
  const fields: Fields = new Map();
  for (const body of bodies) addAttribute(body, fields);
  return fields;
}
