// SPDX-License-Identifier: Apache-2.0
// Finds the kind of an opened file by its content.
import { AvoError, type Library } from "../../avo/avo.ts";
import { frameReader, requireSize, requireTimes } from "./blocks.ts";
import { RecordingError, refuse } from "./bytes.ts";
import { looksLikeCsv, openCsv } from "./csv.ts";
import { openHdf5 } from "./hdf5.ts";
import { isHdf5 } from "./hdf5_objects.ts";
import type { Recording } from "./recording.ts";
import { isSpool, openSpool } from "./spool.ts";

export type FileFormat = "hdf5" | "spool" | "csv" | "yaml" | "unknown";

const FIRST_BYTES = 4096;
const HDF5_NAME = /\.h5(\.part)?$/i;

/** Returns the kind by the first bytes; if they are not those of a recording, by the ending of the name. unknown:
 * neither a text nor a recording. */
export function formatOf(name: string, bytes: Uint8Array): FileFormat {
  if (isHdf5(bytes)) return "hdf5";
  if (isSpool(bytes)) return "spool";
  if (HDF5_NAME.test(name) || bytes.subarray(0, FIRST_BYTES).includes(0)) return "unknown";
  return /\.csv$/i.test(name) || looksLikeCsv(bytes) ? "csv" : "yaml";
}

function openBlocks(library: Library, kind: "hdf5" | "spool", name: string, bytes: Uint8Array): Recording {
  const { header, stored } = kind === "hdf5" ? openHdf5(library, bytes) : openSpool(library, bytes);
  requireTimes(stored.times);
  requireSize(stored);
  return { ...header, kind, name, times: stored.times, frame: frameReader(stored) };
}

/** Errors are one line with the file's name in front. */
function named(name: string, error: unknown): Error {
  if (!(error instanceof RecordingError || error instanceof AvoError)) return error as Error;
  return new Error(error.message.startsWith(`${name}:`) ? error.message : `${name}: ${error.message}`);
}

/** Rejects with an Error of one line if the file is damaged or not a recording. */
export async function openRecording(library: Library, name: string, bytes: Uint8Array): Promise<Recording> {
  try {
    const kind = formatOf(name, bytes);
    if (kind === "yaml") refuse("found a scene, must be a recording");
    if (kind === "unknown" && HDF5_NAME.test(name))
      refuse("found neither HDF5 nor a spool in it, cut off or damaged, must be one of them, whole");
    if (kind === "unknown") refuse("found no text, must be a scene as YAML, or a recording as CSV or HDF5");
    const recording = kind === "csv" ? openCsv(library, name, bytes) : openBlocks(library, kind, name, bytes);
    const { frame } = recording;
    recording.frame = (k) => frame(k).catch((error) => Promise.reject(named(name, error)));
    return recording;
  } catch (error) {
    throw named(name, error);
  }
}
