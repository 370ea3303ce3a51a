// SPDX-License-Identifier: Apache-2.0
// The library's errors, in the order in which a reader needs their parts.

/** Moves the key or the word that was probably meant. It then comes before the list of all allowed ones: `found the
unknown key
 * "radus", did you mean "radius"? Allowed are ...`. Other errors stay. */
export function nearestFirst(message: string): string {
  const parts = /^(.*), ((?:allowed are|must be one of) .*); (did you mean "[^"]*"\?)$/s.exec(message);
  if (!parts) return message;
  const [, found, allowed, meant] = parts as unknown as [string, string, string, string];
  return `${found}, ${meant} ${allowed[0]!.toUpperCase()}${allowed.slice(1)}.`;
}
