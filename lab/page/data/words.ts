// SPDX-License-Identifier: Apache-2.0
// Words and numbers in messages and tables, as the command line shows them (io/text/words.cpp, io/text/printable.cpp).

/** Control characters, line ends and directions of writing: characters that change how other text is shown. */
const UNPRINTABLE = /[\u0000-\u001f\u007f-\u009f\u2028-\u202e\u2066-\u2069]/;

function printable(character: string): string {
  if (character === "\n") return "\\n";
  if (!UNPRINTABLE.test(character)) return character;
  return Array.from(new TextEncoder().encode(character), (byte) => `\\x${byte.toString(16).padStart(2, "0")}`).join("");
}

/** Returns the text in quotes, at most 40 characters; the middle of a longer text is left out. */
export function inQuotes(text: string): string {
  const MOST = 40, LAST = 10;
  const characters = Array.from(text);
  const shown = characters.map(printable);
  if (characters.length <= MOST) return `"${shown.join("")}"`;
  return `"${shown.slice(0, MOST - LAST).join("")}...${shown.slice(-LAST).join("")}"`;
}

/** Returns the smallest number of insertions, deletions, replacements and swaps of neighbors (optimal string
 * alignment). */
function editDistance(a: string, b: string): number {
  let beforeLast: number[] = [];
  let last = Array.from({ length: b.length + 1 }, (_, j) => j);
  for (let i = 1; i <= a.length; ++i) {
    const row = [i];
    for (let j = 1; j <= b.length; ++j) {
      row.push(Math.min(last[j - 1] + (a[i - 1] === b[j - 1] ? 0 : 1), last[j] + 1, row[j - 1] + 1));
      const swapped = i > 1 && j > 1 && a[i - 1] === b[j - 2] && a[i - 2] === b[j - 1];
      if (swapped) row[j] = Math.min(row[j], beforeLast[j - 2] + 1);
    }
    beforeLast = last;
    last = row;
  }
  return last[b.length];
}

/** Returns whether `given` abbreviates `word`: it has the same beginning, and all its letters occur in order. */
function abbreviates(given: string, word: string): boolean {
  if (given.length < 3 || !word.startsWith(given.slice(0, 3))) return false;
  let k = 0;
  for (const letter of word) if (letter === given[k]) ++k;
  return k === given.length;
}

/** Returns the word that `given` may have meant. */
export function nearest(given: string, words: string[]): string | null {
  const LONGEST = 40;
  if (given === "" || given.length > LONGEST) return null;
  let best: string | null = null;
  let smallest = Infinity;
  for (const word of words) {
    if (word.length > 2 * LONGEST) continue;  // farther than any allowed distance
    const distance = editDistance(given, word);
    if (distance > Math.max(1, Math.floor(Math.max(given.length, word.length) / 3)) || distance >= smallest) continue;
    best = word;
    smallest = distance;
  }
  return best ?? words.find((word) => abbreviates(given, word)) ?? null;
}

/** Returns the fewest digits that identify the number, in the form of C++: 1e-05, 1e+16, -0. */
export function shortest(value: number): string {
  const magnitude = Math.abs(value);
  if (magnitude === 0) return Object.is(value, -0) ? "-0" : "0";
  if (magnitude >= 1e-4 && magnitude < 1e16) return String(value);
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
  const [digits, exponent] = value.toExponential().split("e");
  const size = Math.abs(Number(exponent)).toString().padStart(2, "0");
  return `${digits}e${exponent[0]}${size}`;
}
