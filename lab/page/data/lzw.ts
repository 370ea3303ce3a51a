// SPDX-License-Identifier: Apache-2.0
// Compression by Lempel, Ziv and Welch in the form of GIF: codes of 9 to 12 bits in blocks of 255 bytes.

/** A list of bytes; its memory doubles as it grows. Numbers have their low byte first. */
export class ByteWriter {
  private buffer = new Uint8Array(1 << 16);
  private size = 0;

  u8(value: number): void {
    if (this.size === this.buffer.length) {
      const larger = new Uint8Array(2 * this.size);
      larger.set(this.buffer);
      this.buffer = larger;
    }
    this.buffer[this.size++] = value;
  }

  u16(value: number): void {
    this.u8(value & 255);
    this.u8(value >> 8);
  }

  text(ascii: string): void {
    for (let k = 0; k < ascii.length; ++k) this.u8(ascii.charCodeAt(k));
  }

  bytes(): Uint8Array {
    return this.buffer.slice(0, this.size);
  }
}

/** Codes in sequence, low bit first; each block of bytes has its length in front. */
class CodeWriter {
  private readonly block = new Uint8Array(255);
  private filled = 0;
  private bits = 0;
  private count = 0;  // number of bits

  constructor(private readonly out: ByteWriter) {}

  write(code: number, width: number): void {
    this.bits |= code << this.count;
    this.count += width;
    for (; this.count >= 8; this.count -= 8, this.bits >>>= 8) this.add(this.bits & 255);
  }

  end(): void {
    if (this.count > 0) this.add(this.bits);
    if (this.filled > 0) this.flush();
    this.out.u8(0);
  }

  private add(byte: number): void {
    this.block[this.filled++] = byte;
    if (this.filled === this.block.length) this.flush();
  }

  private flush(): void {
    this.out.u8(this.filled);
    for (let k = 0; k < this.filled; ++k) this.out.u8(this.block[k]);
    this.filled = 0;
  }
}

const SYMBOL_BITS = 8;
const CLEAR = 256, END = 257, FIRST = 258;
const MOST_CODES = 4096;
/** The code of a sequence that begins with a code and ends with a symbol, at code * 256 + symbol; 0: none. */
const longer = new Uint16Array(MOST_CODES << SYMBOL_BITS);

/** Writes one or more symbols, each of 8 bits. */
export function writeLzw(symbols: Uint8Array, out: ByteWriter): void {
  out.u8(SYMBOL_BITS);
  const codes = new CodeWriter(out);
  let next = FIRST;
  let width = SYMBOL_BITS + 1;
  const clear = () => {
    codes.write(CLEAR, width);
    longer.fill(0, 0, next << SYMBOL_BITS);
    next = FIRST;
    width = SYMBOL_BITS + 1;
  };
  clear();
  let known = symbols[0];
  for (let k = 1; k < symbols.length; ++k) {
    const key = (known << SYMBOL_BITS) | symbols[k];
    if (longer[key] !== 0) {
      known = longer[key];
      continue;
    }
    codes.write(known, width);
    if (next === MOST_CODES) {
      clear();
    } else {
      if (next === 1 << width) ++width;
      longer[key] = next++;
    }
    known = symbols[k];
  }
  codes.write(known, width);
  if (next === 1 << width && next < MOST_CODES) ++width;
  codes.write(END, width);
  codes.end();
  longer.fill(0, 0, next << SYMBOL_BITS);
}
