// SPDX-License-Identifier: Apache-2.0
// Deflate by the browser's own streams, and base64.
import { refuse } from "./bytes.ts";

export type Compression = "deflate" | "gzip";

const damaged = (): never => refuse("found compressed bytes that are damaged, must be whole");

/** Joins the parts of a stream, at most `most` bytes of them: a stream that has more is damaged. */
async function collected(stream: ReadableStream<Uint8Array>, most: number): Promise<Uint8Array<ArrayBuffer>[]> {
  const reader = stream.getReader();
  const parts: Uint8Array<ArrayBuffer>[] = [];
  for (let size = 0; ; ) {
    const { done, value } = await reader.read().catch(damaged);
    if (done) return parts;
    size += value.length;
    if (size > most) {
      reader.cancel().catch(() => undefined);
      damaged();
    }
    parts.push(value as Uint8Array<ArrayBuffer>);
  }
}

export function concatenated(parts: Uint8Array[]): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(parts.reduce((size, part) => size + part.length, 0));
  let end = 0;
  for (const part of parts) {
    bytes.set(part, end);
    end += part.length;
  }
  return bytes;
}

const joined = async (stream: ReadableStream<Uint8Array>, most: number) => concatenated(await collected(stream, most));
const streamOf = (bytes: Uint8Array) => new Blob([bytes as Uint8Array<ArrayBuffer>]).stream();

export function compressed(bytes: Uint8Array, kind: Compression): Promise<Uint8Array<ArrayBuffer>> {
  return joined(streamOf(bytes).pipeThrough(new CompressionStream(kind)), Infinity);
}

/** Uncompresses at most `most` bytes, whatever the compressed bytes promise. Rejects with RecordingError if they are
 * damaged. */
export function uncompressed(bytes: Uint8Array, kind: Compression, most: number): Promise<Uint8Array<ArrayBuffer>> {
  return joined(streamOf(bytes).pipeThrough(new DecompressionStream(kind)), most);
}

export function base64Of(bytes: Uint8Array): string {
  const PART = 0x8000;  // arguments of one call
  let text = "";
  for (let k = 0; k < bytes.length; k += PART) text += String.fromCharCode(...bytes.subarray(k, k + PART));
  return btoa(text);
}

export function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  let characters = "";
  try {
    characters = atob(text);
  } catch {
    refuse("found a character that is none of base64");
  }
  const bytes = new Uint8Array(characters.length);  // from() would take ten times as long
  for (let k = 0; k < bytes.length; ++k) bytes[k] = characters.charCodeAt(k);
  return bytes;
}

/** Returns base64 that needs no escapes in an address. */
export function base64UrlOf(bytes: Uint8Array): string {
  return base64Of(bytes).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
}

export function bytesOfBase64Url(text: string): Uint8Array<ArrayBuffer> {
  return bytesOfBase64(text.replaceAll("-", "+").replaceAll("_", "/"));
}
