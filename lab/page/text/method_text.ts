// SPDX-License-Identifier: Apache-2.0
// The scene's text with another method.
import type { Lab } from "../run/lab.ts";
import { valueAt, withValue } from "./scene_text.ts";

/** Returns the text. Only `avo` may have a certificate; the certificate's keys are left out for other methods. */
export function withMethod(lab: Lab, method: string | undefined): string {
  const text = lab.textWith("method", method);
  if (method === undefined || valueAt(lab.text, "certificate") === undefined) return text;
  try {
    lab.library.simulate(text, { ...lab.options, name: lab.name });
    return text;
  } catch {
    return withValue(text, "certificate", undefined);
  }
}
