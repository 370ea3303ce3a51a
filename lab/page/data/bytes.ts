// SPDX-License-Identifier: Apache-2.0
// Bytes of unknown origin, read in order and never beyond their end.

/** An error about damaged or foreign data, in one line without the file's name; openRecording() puts that in front. */
export class RecordingError extends Error {}

export function refuse(what: string): never {
  throw new RecordingError(what);
}

/** Reads bytes in order; numbers are stored with their low byte first. */
export class ByteReader {
  private readonly view: DataView;

  /** `of` is the name of the bytes in messages. */
  constructor(readonly bytes: Uint8Array, public offset = 0, private readonly of = "file") {
    if (!(offset <= bytes.length)) this.end();
    this.view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  }

  private end(): never {
    refuse(`found a ${this.of} that ends too early, cut off or damaged, must be whole`);
  }

  get left(): number {
    return this.bytes.length - this.offset;
  }

  /** Advances by `size` bytes and returns where they begin. */
  skip(size: number): number {
    const begin = this.offset;
    if (!(size <= this.left)) this.end();
    this.offset += size;
    return begin;
  }

  /** Returns a view, not a copy. */
  take(size: number): Uint8Array {
    const begin = this.skip(size);
    return this.bytes.subarray(begin, begin + size);
  }

  u8(): number {
    return this.view.getUint8(this.skip(1));
  }

  u16(): number {
    return this.view.getUint16(this.skip(2), true);
  }

  u32(): number {
    return this.view.getUint32(this.skip(4), true);
  }

  exact64(): bigint {
    return this.view.getBigUint64(this.skip(8), true);
  }

  /** Reads a number of 1 to 8 bytes; a number too large for a double becomes infinite, more than any file has. */
  uint(size: number): number {
    const begin = this.skip(size);
    let value = 0;
    for (let k = size - 1; k >= 0; --k) value = value * 256 + this.view.getUint8(begin + k);
    return value <= Number.MAX_SAFE_INTEGER ? value : Infinity;
  }

  u64(): number {
    return this.uint(8);
  }

  float64s(count: number): Float64Array {
    const begin = this.skip(8 * count);
    const values = new Float64Array(count);
    for (let k = 0; k < count; ++k) values[k] = this.view.getFloat64(begin + 8 * k, true);
    return values;
  }
}

export function beginsWith(bytes: Uint8Array, text: string): boolean {
  if (bytes.length < text.length) return false;
  for (let k = 0; k < text.length; ++k) if (bytes[k] !== text.charCodeAt(k)) return false;
  return true;
}

/** Returns e.g. "89 48 44", to compare short byte sequences. */
export function hexOf(bytes: Uint8Array): string {
  return Array.from(bytes, (byte) => byte.toString(16).padStart(2, "0")).join(" ");
}
