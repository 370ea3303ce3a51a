// SPDX-License-Identifier: Apache-2.0
// The module's host, in a browser or in Node.js. What the library refuses becomes a JavaScript Error with its
// message; the instance is of no use after that, so make another one.

const NO_SYSTEM = 52;  // ENOSYS of WASI

/** Of `bytes` or a compiled module: its exports, and what reads its memory. */
export async function load(source) {
  const module = source instanceof WebAssembly.Module ? source : await WebAssembly.compile(source);
  let memory;  // its buffer is another one whenever it has grown: made anew for each view
  const text = (at, length) => new TextDecoder().decode(new Uint8Array(memory.buffer, at, length));
  const refuse = () => NO_SYSTEM;
  const { exports } = await WebAssembly.instantiate(module, {
    avo: { fail(message, length) { throw new Error(text(message, length)); } },
    wasi_snapshot_preview1: {
      environ_get: () => 0,
      environ_sizes_get(count, size) {
        const view = new DataView(memory.buffer);
        view.setUint32(count, 0, true);
        view.setUint32(size, 0, true);
        return 0;
      },
      clock_time_get(clock, precision, at) {
        new DataView(memory.buffer).setBigUint64(at, BigInt(Math.round(1e6 * performance.now())), true);
        return 0;
      },
      fd_close: refuse,
      fd_seek: refuse,
      fd_write: refuse,
      proc_exit(code) { throw new Error(`the module ended with status ${code}`); },
    },
  });
  memory = exports.memory;
  exports._initialize();
  return {
    ...exports,
    /** Hands over what Simulation::save() wrote, and goes on from there. */
    restore(saved) {
      const at = exports.room(saved.length);
      new Uint8Array(memory.buffer, at, saved.length).set(saved);
      exports.restore();
    },
    save() {
      const size = exports.save();
      return new Uint8Array(memory.buffer, exports.saved(), size).slice();
    },
    /** x and y (m) of each robot in turn. */
    positions() {
      const at = exports.positions();
      return new Float64Array(memory.buffer, at, 2 * exports.robots()).slice();
    },
    /** The instructions of the kernels: "simd128" or "scalar". */
    simdTarget() {
      const at = exports.simd_target();
      return text(at, new Uint8Array(memory.buffer, at).indexOf(0));
    },
    stateHash: () => BigInt.asUintN(64, exports.state_hash()),
  };
}
