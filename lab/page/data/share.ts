// SPDX-License-Identifier: Apache-2.0
// A scene's text as a part of an address: the text behind "#" of a shared link.
import { base64UrlOf, bytesOfBase64Url, compressed, uncompressed } from "./compression.ts";

const MOST_CHARACTERS = 1_000_000;  // of the address
const MOST_BYTES = 8_000_000;       // of the text

/** Characters that an address holds without escapes. The checksum of "deflate" detects a link that was cut off. */
export async function encodeScene(text: string): Promise<string> {
  const bytes = new TextEncoder().encode(text);
  const encoded = bytes.length > MOST_BYTES ? "" : base64UrlOf(await compressed(bytes, "deflate"));
  if (bytes.length > MOST_BYTES || encoded.length > MOST_CHARACTERS)
    throw new Error("found a scene that is too large for a link, must be saved as a file instead");
  return encoded;
}

export async function decodeScene(encoded: string): Promise<string> {
  try {
    if (encoded.length > MOST_CHARACTERS) throw new Error("too long");
    const bytes = await uncompressed(bytesOfBase64Url(encoded), "deflate", MOST_BYTES);
    return new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(bytes);
  } catch {
    throw new Error("found a link whose scene is damaged or cut off, must be copied whole");
  }
}
