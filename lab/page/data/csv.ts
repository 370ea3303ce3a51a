// SPDX-License-Identifier: Apache-2.0
// Recordings as CSV (docs/check.md), read like io/recording/csv_rows.cpp and refused in its words.
import { refuse } from "./bytes.ts";
import { emptyFrame, LARGEST, LARGEST_RANGE, MOST_ROBOTS, type Recording, type RecordedFrame } from "./recording.ts";
import { inQuotes, nearest, shortest } from "./words.ts";

const COLUMNS = ["time", "robot", "x", "y", "vx", "vy"];
const HEADING_COLUMNS = ["heading", "speed"];
const EVERY = "every";
const LONGEST_LINE = 65536;
const NUMBER = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?$/;
const INFINITE = /^[+-]?inf(?:inity)?$/i;

/** Positions of the columns in the first line; -1: missing. */
interface Header { columns: number; at: number[]; heading: number; speed: number; every: number }

function refuseAt(line: number, what: string): never {
  refuse(`${line}: ${what}`);
}

/** Returns the text without the blanks around it, and without the quotes within them. */
function trimmed(field: string): string {
  const text = field.replace(/^[ \t]+|[ \t]+$/g, "");
  return text.length >= 2 && text.startsWith('"') && text.endsWith('"') ? text.slice(1, -1) : text;
}

function splitFields(line: string): string[] {
  const fields = line.split(",");
  for (let k = 0; k < fields.length; ++k) {
    const field = fields[k];
    const first = field.charCodeAt(0);
    const last = field.charCodeAt(field.length - 1);
    if (first <= 34 || last <= 34) fields[k] = trimmed(field);  // no blank or quote is larger
  }
  return fields;
}

function findColumn(fields: string[], name: string): number {
  const allowed = `the first line must name ${COLUMNS.join(", ")}`;
  const at = fields.indexOf(name);
  if (at < 0) {
    const meant = nearest(name, fields.filter((field) => !COLUMNS.includes(field)));
    refuseAt(1, `found no column "${name}", ${allowed}${meant === null ? "" : `; is ${inQuotes(meant)} meant?`}`);
  }
  if (fields.indexOf(name, at + 1) >= 0) refuseAt(1, `found column "${name}" more than once, ${allowed}`);
  return at;
}

function readHeader(line: string | undefined): Header {
  if (line === undefined) refuseAt(1, `found nothing, the first line must name ${COLUMNS.join(", ")}`);
  const fields = splitFields(line);
  const headings = HEADING_COLUMNS.every((name) => fields.includes(name));
  const at = COLUMNS.map((name) => findColumn(fields, name));
  const [heading, speed] = HEADING_COLUMNS.map((name) => (headings ? findColumn(fields, name) : -1));
  return { columns: fields.length, at, heading, speed, every: fields.includes(EVERY) ? findColumn(fields, EVERY) : -1 };
}

/** Returns NaN for text that is not a number. */
function parsed(text: string): number {
  if (NUMBER.test(text)) return Number(text);
  return INFINITE.test(text) ? (text.startsWith("-") ? -Infinity : Infinity) : NaN;
}

function numberAt(text: string, name: string, line: number): number {
  const value = parsed(text);
  if (Math.abs(value) <= LARGEST) return value;
  const large = !Number.isNaN(value) && /\d/.test(text);
  refuseAt(line, `${name}: found ${inQuotes(text)}, must be ${large ? LARGEST_RANGE : "a finite number"}`);
}

/** Returns an integer, also one written as 3.0; -1 for any other text, or a negative number. */
function wholeNumber(text: string): number {
  const value = parsed(text);
  return Number.isSafeInteger(value) && value >= 0 ? Math.abs(value) : -1;
}

function robotAt(text: string, line: number): number {
  const robot = wholeNumber(text);
  if (robot < 0) refuseAt(line, `robot: found ${inQuotes(text)}, must be an integer >= 0`);
  if (robot >= MOST_ROBOTS) refuseAt(line, `robot: found ${robot}, must be less than ${MOST_ROBOTS} to be shown here`);
  return robot;
}

function everyAt(text: string, line: number): number {
  const every = wholeNumber(text);
  if (every < 1) refuseAt(line, `${EVERY}: found ${inQuotes(text)}, must be an integer >= 1`);
  return every;
}

/** Returns lines without their ends, including a last line without an end. The bytes are decoded part by part. */
function* linesOf(bytes: Uint8Array): Generator<string> {
  const PART = 1 << 22;
  const decoder = new TextDecoder();  // it drops the byte order mark
  let rest = "";
  let number = 0;
  for (let begin = 0; begin < bytes.length; begin += PART) {
    const last = begin + PART >= bytes.length;
    const text = rest + decoder.decode(bytes.subarray(begin, begin + PART), { stream: !last });
    const lines = text.split("\n");
    rest = lines.pop() as string;
    if (last && rest !== "") lines.push(rest);
    else if (rest.length > LONGEST_LINE) lines.push(rest);
    for (const line of lines) {
      ++number;
      if (line.length > LONGEST_LINE)
        refuseAt(number, `found more than ${LONGEST_LINE} characters, a line must be shorter`);
      yield line.endsWith("\r") ? line.slice(0, -1) : line;
    }
  }
}

/** A list of numbers of any length; its memory doubles as it grows. */
class Column {
  values = new Float64Array(1024);
  size = 0;
  push(value: number): void {
    if (this.size === this.values.length) {
      const values = new Float64Array(2 * this.size);
      values.set(this.values);
      this.values = values;
    }
    this.values[this.size++] = value;
  }
}

/** Rows in sequence: robot, x, y, vx, vy, heading, speed; and the index where the rows of each time begin. */
interface Table { rows: Column[]; line: Column; times: Column; begins: Column; robots: number; every: number }

const ROBOT = 0, X = 1, Y = 2, VX = 3, VY = 4, HEADING = 5, SPEED = 6;

/** Requires that each robot occurs once in the rows of the last time. `last`: the last read row of each robot. */
function requireOnce(table: Table, last: Map<number, number>, robot: number, line: number): void {
  const row = last.get(robot);
  if (row !== undefined && row >= table.begins.values[table.begins.size - 1]) {
    const time = shortest(table.times.values[table.times.size - 1]);
    refuseAt(line, `robot: found ${robot} again at ${time} s, must be once a time (line ${table.line.values[row]})`);
  }
  last.set(robot, table.line.size);
}

function addTime(table: Table, time: number, line: number): void {
  const last = table.times.values[table.times.size - 1];
  if (table.times.size > 0 && time === last) return;
  if (table.times.size > 0 && time < last)
    refuseAt(line, `time: found ${shortest(time)} s, must be >= ${shortest(last)} s, the time before`);
  table.times.push(time);
  table.begins.push(table.line.size);
}

function addRow(table: Table, header: Header, fields: string[], line: number, last: Map<number, number>): void {
  if (fields.length !== header.columns)
    refuseAt(line, `found ${fields.length} columns, must be ${header.columns} as in the first line`);
  const { at } = header;
  const time = numberAt(fields[at[0]], "time", line);
  const robot = robotAt(fields[at[1]], line);
  const numbers = [2, 3, 4, 5].map((c) => numberAt(fields[at[c]], COLUMNS[c], line));
  const texts = header.heading < 0 ? [] : [fields[header.heading], fields[header.speed]];
  const headings = texts.every((text) => text === "") ? [NaN, NaN]
    : texts.map((text, k) => numberAt(text, HEADING_COLUMNS[k], line));
  if (header.every >= 0) table.every = Math.max(table.every, everyAt(fields[header.every], line));
  addTime(table, time, line);
  requireOnce(table, last, robot, line);
  [robot, ...numbers, ...headings].forEach((value, c) => table.rows[c].push(value));
  table.line.push(line);
  table.robots = Math.max(table.robots, robot + 1);
}

function frameOf(table: Table, k: number): RecordedFrame {
  const frame = emptyFrame(table.times.values[k], table.robots);
  const end = k + 1 < table.begins.size ? table.begins.values[k + 1] : table.line.size;
  const value = (column: number, row: number) => table.rows[column].values[row];
  for (let row = table.begins.values[k]; row < end; ++row) {
    const robot = value(ROBOT, row);
    frame.there[robot] = 1;
    frame.position.set([value(X, row), value(Y, row)], 2 * robot);
    frame.velocity.set([value(VX, row), value(VY, row)], 2 * robot);
    frame.heading[robot] = value(HEADING, row);
    frame.speed[robot] = value(SPEED, row);
    frame.status[robot] = 0;
  }
  return frame;
}

/** Returns whether the first line names columns of a recording; otherwise it begins a scene. */
export function looksLikeCsv(bytes: Uint8Array): boolean {
  const begin = new TextDecoder().decode(bytes.subarray(0, 4096)).split("\n", 1)[0].replace(/\r$/, "");
  const fields = splitFields(begin);
  return COLUMNS.filter((name) => fields.includes(name)).length >= 2;
}

/** Line numbers in messages follow the name that openRecording() puts in front: `name:line: ...`. */
export function openCsv(name: string, bytes: Uint8Array): Recording {
  const lines = linesOf(bytes);
  const header = readHeader(lines.next().value as string | undefined);
  const rows = [ROBOT, X, Y, VX, VY, HEADING, SPEED].map(() => new Column());
  const table: Table = { rows, line: new Column(), times: new Column(), begins: new Column(), robots: 0, every: 1 };
  const last = new Map<number, number>();
  let line = 1;
  for (const text of lines) {
    ++line;
    if (text !== "") addRow(table, header, splitFields(text), line, last);
  }
  const times = table.times.values.slice(0, table.times.size);
  if (times.length < 2)
    refuseAt(line, `found rows of ${times.length === 0 ? "no time" : "one time only"}, must be of two or more`);
  const { robots, every } = table;
  return { kind: "csv", name, times, robots, headings: header.heading >= 0, every, scene: null,
    frame: async (k) => frameOf(table, k) };
}
