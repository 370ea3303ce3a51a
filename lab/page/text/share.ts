// SPDX-License-Identifier: Apache-2.0
// A scene in an address: the link alone has the whole scene, and no server has seen it.
import type { Lab } from "../run/lab.ts";
import type { SceneOptions } from "../../avo/avo.ts";
import { decodeScene, encodeScene } from "../data/share.ts";

/** Throws one line for a scene that does not fit into a link. */
async function linkOf(lab: Lab): Promise<string> {
  const { overrides = [], files = [], start_at_rest, limit_speed } = lab.options;
  if (!lab.text) throw new Error("this recording does not hold its scene, so there is no link to it");
  if (files.some((file) => !file.builtin))
    throw new Error("this scene reads other files, which a link does not hold: pass the files on instead");
  const parts = new URLSearchParams({ name: lab.name });
  for (const override of overrides) parts.append("set", override);
  if (start_at_rest) parts.set("start_at_rest", "true");
  if (limit_speed) parts.set("limit_speed", "true");
  if (lab.selected !== null) parts.set("robot", String(lab.selected));
  return `${location.href.split("#")[0]}#scene=${await encodeScene(lab.text)}&${parts}`;
}

let linked: string | null = null;  // the text that the address holds

/** Returns the link of the present scene, which becomes the address of the page. */
export async function putIntoAddress(lab: Lab): Promise<string> {
  const link = await linkOf(lab);
  history.replaceState(null, "", link.slice(link.indexOf("#")));
  linked = lab.text;
  return link;
}

/** Another text differs from the address: a reload of the page would show the old text. */
export function keepAddressTrue(lab: Lab): void {
  lab.on("text", () => {
    if (linked === null || lab.text === linked) return;
    linked = null;
    history.replaceState(null, "", location.href.split("#")[0]);
  });
}

/** Opens the scene of `#scene=...` in the address. Returns false if there is none. */
export async function openFromAddress(lab: Lab, hash = location.hash): Promise<boolean> {
  const parts = new URLSearchParams(hash.replace(/^#/, ""));
  const scene = parts.get("scene");
  if (scene === null) return false;
  const options: SceneOptions = {
    overrides: parts.getAll("set"),
    start_at_rest: parts.get("start_at_rest") === "true",
    limit_speed: parts.get("limit_speed") === "true",
  };
  const yaml = await decodeScene(scene);
  linked = null;
  lab.openText(yaml, parts.get("name") || "shared scene", options);
  if (!lab.error) linked = lab.text;
  const robot = Number(parts.get("robot") ?? NaN);
  if (!lab.error && lab.moment.robot.includes(robot)) lab.select(robot);
  return true;
}
