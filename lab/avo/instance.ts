// SPDX-License-Identifier: Apache-2.0
// One instance of the module: its memory, and the functions that it needs from its host.
import { eventsOf } from "./scene_tree.ts";

/** An error of the library, in the words of the command line: "name:3:7: robots.0.radius: found ...". */
export class AvoError extends Error {
  override name = "AvoError";
  line?: number;
  column?: number;

  constructor(message: string) {
    super(message);
    const place = /^[^\n]*?:(\d+):(\d+): /.exec(message);
    if (!place) return;
    this.line = Number(place[1]);
    this.column = Number(place[2]);
  }
}

/** The module's functions by name; a function that returns a size has put that many bytes into the room. */
type Functions = Record<string, (...words: number[]) => number>;

export interface Instance {
  memory: WebAssembly.Memory;
  functions: Functions;
}

const NO_SYSTEM = 52; // ENOSYS of WASI

/** The functions of the C library that the module is built with. */
function system(memory: () => WebAssembly.Memory): WebAssembly.ModuleImports {
  const view = () => new DataView(memory().buffer);
  const refuse = () => NO_SYSTEM;
  return {
    environ_get: () => 0,
    environ_sizes_get(count: number, size: number) {
      view().setUint32(count, 0, true);
      view().setUint32(size, 0, true);
      return 0;
    },
    clock_time_get(_clock: number, _precision: bigint, at: number) {
      view().setBigUint64(at, BigInt(Math.round(1e6 * performance.now())), true);
      return 0;
    },
    fd_close: refuse,
    fd_seek: refuse,
    fd_write: refuse,
    proc_exit(code: number) {
      throw new AvoError(`the module ended with status ${code}`);
    },
  };
}

/** `file`: what the module reads as the host's file. */
export function instantiate(module: WebAssembly.Module, file: Uint8Array = new Uint8Array()): Instance {
  let read = 0; // bytes of the file
  const decoder = new TextDecoder("utf-8", { ignoreBOM: true });
  const text = (at: number, length: number) => decoder.decode(new Uint8Array(instance.memory.buffer, at, length));
  const { exports } = new WebAssembly.Instance(module, {
    avo: {
      fail(message: number, length: number) {
        throw new AvoError(text(message, length));
      },
      parse_yaml(at: number, length: number) {
        put(instance, eventsOf(text(at, length)));
      },
      read_file(at: number, size: number) {
        const part = file.subarray(read, read + size);
        new Uint8Array(instance.memory.buffer, at, part.length).set(part);
        read += part.length;
        return part.length;
      },
    },
    wasi_snapshot_preview1: system(() => instance.memory),
  });
  const instance: Instance = {
    memory: exports["memory"] as WebAssembly.Memory,
    functions: exports as Functions,
  };
  instance.functions["_initialize"]!();
  return instance;
}

/** Puts bytes into the room. */
export function put(instance: Instance, bytes: Uint8Array): void {
  const at = instance.functions["room"]!(bytes.length); // memory may have grown, so the view is made after the call
  new Uint8Array(instance.memory.buffer, at, bytes.length).set(bytes);
}

/** Returns a copy of what a function has put into the room. */
export function get(instance: Instance, size: number): Uint8Array {
  const at = instance.functions["room_begin"]!();
  return new Uint8Array(instance.memory.buffer, at, size).slice();
}

export function getText(instance: Instance, size: number): string {
  return new TextDecoder().decode(get(instance, size));
}

/** Returns the whole state of the instance, between two calls. */
export const imageOf = (instance: Instance): Uint8Array => new Uint8Array(instance.memory.buffer).slice();

/** Makes another instance with the same state. */
export function fromImage(module: WebAssembly.Module, image: Uint8Array): Instance {
  const instance = instantiate(module);
  const more = image.length - instance.memory.buffer.byteLength;
  if (more > 0) instance.memory.grow(more / 65536);
  new Uint8Array(instance.memory.buffer).set(image);
  return instance;
}
