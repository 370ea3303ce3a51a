// SPDX-License-Identifier: Apache-2.0
// Attributes of an object that has more than eight: they are in a fractal heap, found by a B-tree (version 2) of their
// names. Long attributes are elsewhere in the file, found by another B-tree.
import { ByteReader, refuse } from "./bytes.ts";
import { lookup3, requireChecksum } from "./hdf5_checksum.ts";
import { refuseForeign, requireSignature, requireVersion } from "./hdf5_objects.ts";

const MOST_DEPTH = 8;
const NAMES = { type: 8, record: 17 };       // heap id of 8 bytes, flags, order of creation, hash of the name
const LONG_OBJECTS = { type: 1, record: 24 };  // address, length, number

/** Returns the number of bytes that a number up to `most` needs. */
const sizeOf = (most: number) => Math.floor(Math.log2(most) / 8) + 1;

interface Tree {
  type: number;
  record: number;          // bytes
  counts: number[];        // number of records that fit in a node, by its depth
  sizes: number[];         // bytes of the number of all records below a node, by its depth
  seen: Set<number>;       // addresses of nodes
  records: Uint8Array[];
}

/** Finds how many records a node of each depth can have, and the stored width of the number of records below it. */
function capacities(node: number, record: number, depth: number): { counts: number[]; sizes: number[] } {
  const OVERHEAD = 10;
  const counts = [Math.floor((node - OVERHEAD) / record)];
  const sizes = [0];
  let below = counts[0];
  for (let d = 1; d <= depth; ++d) {
    const pointer = 8 + sizeOf(counts[0]) + sizes[d - 1];
    counts.push(Math.floor((node - OVERHEAD - pointer) / (record + pointer)));
    below = (counts[d] + 1) * below + counts[d];
    sizes.push(sizeOf(below));
  }
  return { counts, sizes };
}

function readNode(file: Uint8Array, address: number, count: number, depth: number, tree: Tree): void {
  if (count > tree.counts[depth] || tree.seen.has(address))
    refuse("found a damaged B-tree of attributes, must be whole");
  tree.seen.add(address);
  const reader = new ByteReader(file, address);
  requireSignature(reader, depth > 0 ? "BTIN" : "BTLF");
  requireVersion(reader, "B-tree", 0);
  if (reader.u8() !== tree.type) refuse("found a damaged B-tree of attributes, must be whole");
  for (let k = 0; k < count; ++k) tree.records.push(reader.take(tree.record));
  if (tree.records.length > file.length / tree.record) refuse("found a damaged B-tree of attributes, must be whole");
  const children: [number, number][] = [];
  for (let k = 0; depth > 0 && k <= count; ++k) {
    children.push([reader.u64(), reader.uint(sizeOf(tree.counts[0]))]);
    reader.skip(tree.sizes[depth - 1]);
  }
  requireChecksum(reader, address, "B-tree of attributes");
  for (const [child, records] of children) readNode(file, child, records, depth - 1, tree);
}

/** Returns all records of the tree at `address`. */
function readTree(file: Uint8Array, address: number, kind: { type: number; record: number }): Uint8Array[] {
  const reader = new ByteReader(file, address);
  requireSignature(reader, "BTHD");
  requireVersion(reader, "B-tree", 0);
  const type = reader.u8();
  const node = reader.u32();
  const record = reader.u16();
  const depth = reader.u16();
  reader.skip(2);
  const root = reader.u64();
  const count = reader.u16();
  reader.skip(8);
  requireChecksum(reader, address, "B-tree of attributes");
  if (type !== kind.type || record !== kind.record || node < 64 || depth > MOST_DEPTH)
    refuseForeign("B-tree of attributes", `type ${type}, records of ${record} bytes`, `type ${kind.type}`);
  const tree: Tree = { ...kind, ...capacities(node, record, depth), seen: new Set(), records: [] };
  if (count > 0) readNode(file, root, count, depth, tree);
  return tree.records;
}

interface Heap {
  file: Uint8Array;
  width: number;      // blocks in a row
  start: number;      // bytes of a block in the first row, and in the second; the size doubles with each further row
  largest: number;    // bytes of a block with objects
  offset_size: number;
  length_size: number;
  root: number;
  rows: number;       // rows of the root; 0: the root is itself a block with objects
  long_tree: number;
  long_objects: Map<number, Uint8Array> | null;  // by number
  verified: Set<number>;                         // addresses of blocks whose checksums have been compared
}

function readHeap(file: Uint8Array, address: number): Heap {
  const reader = new ByteReader(file, address);
  requireSignature(reader, "FRHP");
  requireVersion(reader, "heap of attributes", 0);
  const id = reader.u16();
  const filters = reader.u16();
  const flags = reader.u8();
  const object = reader.u32();
  reader.skip(8);
  const long_tree = reader.u64();
  reader.skip(80);  // statistics
  const [width, start, largest, bits] = [reader.u16(), reader.u64(), reader.u64(), reader.u16()];
  reader.skip(2);
  const [root, rows] = [reader.u64(), reader.u16()];
  requireChecksum(reader, address, "heap of attributes");
  const sane = id === 8 && filters === 0 && (flags & 2) !== 0 && bits === 40 && object >= 1 &&
    [width, start, largest].every((size) => size >= 1 && Number.isInteger(Math.log2(size)));
  if (!sane) refuseForeign("heap of attributes", "another kind", "one of 40 bits with checksums");
  const length_size = Math.min(Math.floor((Math.log2(largest) + 7) / 8), sizeOf(object));
  return { file, width, start, largest, offset_size: bits / 8, length_size, root, rows, long_tree, long_objects: null,
    verified: new Set() };
}

/** Reads the head, which stands in front of the checksum or the children: signature, version, the heap's address, and
 * the block's place in the heap. */
function blockHead(heap: Heap, address: number, signature: string): ByteReader {
  const reader = new ByteReader(heap.file, address);
  requireSignature(reader, signature);
  requireVersion(reader, "block of the heap", 0);
  reader.skip(8 + heap.offset_size);
  return reader;
}

const sizeInRow = (heap: Heap, row: number) => heap.start * 2 ** Math.max(row - 1, 0);

/** Returns a whole block with objects. Its checksum is part of it and counts as 0. */
function objectBlock(heap: Heap, address: number, size: number): Uint8Array {
  const head = blockHead(heap, address, "FHDB");
  const block = new ByteReader(heap.file, address).take(size);
  if (heap.verified.has(address)) return block;
  const zeroed = new Uint8Array(block);  // a copy
  zeroed.fill(0, head.offset - address, head.offset - address + 4);
  if (head.u32() !== lookup3(zeroed)) refuse("found a damaged heap of attributes, must be whole");
  heap.verified.add(address);
  return block;
}

/** Returns the address of a child of a block without objects: of the child in entry `entry`. */
function childAt(heap: Heap, address: number, rows: number, entry: number): number {
  const reader = blockHead(heap, address, "FHIB");
  const children = reader.skip(8 * rows * heap.width);
  if (!heap.verified.has(address)) requireChecksum(reader, address, "heap of attributes");
  heap.verified.add(address);
  return new ByteReader(heap.file, children + 8 * entry).u64();
}

function shortObject(heap: Heap, offset: number, length: number): Uint8Array {
  let address = heap.root;
  let size = heap.start;
  for (let rows = heap.rows, depth = 0; rows > 0; ++depth) {
    let row = 0;
    for (; row < rows && offset >= heap.width * sizeInRow(heap, row); ++row)
      offset -= heap.width * sizeInRow(heap, row);
    if (row === rows || depth > MOST_DEPTH) refuse("found an attribute outside of its heap, damaged");
    size = sizeInRow(heap, row);
    address = childAt(heap, address, rows, row * heap.width + Math.floor(offset / size));
    offset %= size;
    rows = size > heap.largest ? Math.log2(size / (heap.start * heap.width)) + 1 : 0;
  }
  return new ByteReader(objectBlock(heap, address, size), offset).take(length);
}

function longObject(heap: Heap, number: number): Uint8Array {
  if (heap.long_objects === null) {
    heap.long_objects = new Map();
    for (const record of readTree(heap.file, heap.long_tree, LONG_OBJECTS)) {
      const reader = new ByteReader(record);
      const [address, length] = [reader.u64(), reader.u64()];
      heap.long_objects.set(reader.u64(), new ByteReader(heap.file, address).take(length));
    }
  }
  return heap.long_objects.get(number) ?? refuse("found an attribute outside of its heap, damaged");
}

/** Returns the attributes' messages. */
export function messagesInHeap(file: Uint8Array, heapAddress: number, namesAddress: number): Uint8Array[] {
  const heap = readHeap(file, heapAddress);
  return readTree(file, namesAddress, NAMES).map((record) => {
    const id = new ByteReader(record.subarray(0, 8));
    const kind = id.u8() >> 4;
    if (kind === 0) return shortObject(heap, id.uint(heap.offset_size), id.uint(heap.length_size));
    if (kind === 1) return longObject(heap, id.uint(7));
    refuseForeign("attribute in the heap", `kind ${kind}`, "0 or 1");
  });
}
