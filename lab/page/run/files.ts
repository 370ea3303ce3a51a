// SPDX-License-Identifier: Apache-2.0
// Files that are opened or dropped: a scene, a recording, and further files of a scene (maps, scenarios, graymaps).
import type { SceneFile } from "../../avo/avo.ts";
import { formatOf } from "../data/open.ts";
import { element } from "../frame/elements.ts";
import type { PageLab } from "./make_lab.ts";

export interface OpenedFile { name: string; bytes: Uint8Array }

const MOST_BYTES = 1e9;
const BEGINNING = 65536;  // bytes; the first key of a scene must be within them
const ROS_MAP = /^image\s*:/m;
const SCENE = /^[\s{]*["']?(version|name|robots|robots_from|groups)["']?\s*:/m;

const textOf = (bytes: Uint8Array) => new TextDecoder().decode(bytes);

/** Returns whether the file is read by scenes, and is not a scene itself. If the ending of the name does not tell, the
 * content does. */
function isAuxiliary({ name, bytes }: OpenedFile): boolean {
  if (/\.(map|scen|pgm|png|bmp|wkt|geojson)$/i.test(name)) return true;
  if (formatOf(name, bytes) !== "yaml") return false;
  const text = textOf(bytes.subarray(0, BEGINNING));
  return /\.ya?ml$/i.test(name) ? ROS_MAP.test(text) : !SCENE.test(text);
}

/** Lists the file under each path that a text may use for it: each path that ends with its name. */
function asSceneFiles(file: OpenedFile, texts: string[]): SceneFile[] {
  const escaped = file.name.replace(/[.*+?^${}()|[\]\\]/g, "\\$&");
  const paths = new Set([file.name, ...texts.flatMap((yaml) => yaml.match(new RegExp(`[^\\s"',:{}\\[\\]]*/${escaped}`, "g")) ?? [])]);
  return [...paths].map((path) => ({ path, text: file.bytes, builtin: false }));
}

function filesFor(scene: OpenedFile, kept: OpenedFile[]): SceneFile[] {
  const texts = [scene, ...kept.filter(({ name }) => /\.ya?ml$/i.test(name))].map(({ bytes }) => textOf(bytes));
  return kept.flatMap((file) => asSceneFiles(file, texts));
}

/** Opens the scenes and recordings among the files, with the other files as their input. */
export function makeOpener(lab: PageLab): (files: OpenedFile[]) => Promise<void> {
  let kept: OpenedFile[] = [];  // later scenes read them too
  let waiting: OpenedFile | null = null;  // a refused scene, which may lack a file
  return async (files) => {
    const read = files.filter(isAuxiliary);
    kept = [...kept.filter(({ name }) => !read.some((file) => file.name === name)), ...read];
    const [first, ...others] = files.filter((file) => !isAuxiliary(file));
    const shown = first ?? waiting;
    if (!shown) return lab.refuse(`${read[0]!.name} is kept for scenes that read it, e.g. by obstacles: [{map: ${read[0]!.name}}]`);
    const isScene = formatOf(shown.name, shown.bytes) === "yaml";
    await lab.openFile(shown.name, shown.bytes, isScene ? filesFor(shown, kept) : []);
    waiting = isScene && lab.error ? shown : null;
    if (others.length && !lab.error)
      lab.refuse(`${shown.name} is opened, and not ${others.map(({ name }) => name).join(", ")}: one scene or recording at a time`);
  };
}

/** Returns a function that asks for files. */
export function mountFiles(lab: PageLab, button: HTMLElement): () => void {
  const open = makeOpener(lab);
  const input = element("input", { type: "file", multiple: true, hidden: true, "aria-label": "files to open" });
  document.body.append(input);
  input.addEventListener("change", () => {
    void readAll(lab, [...(input.files ?? [])]).then((files) => files.length ? open(files) : undefined);
    input.value = "";
  });
  const ask = (): void => input.click();
  button.addEventListener("click", ask);

  const isOfFiles = (event: DragEvent): boolean => event.dataTransfer?.types.includes("Files") ?? false;
  const over = (is: boolean): void => { document.body.classList.toggle("dropping", is); };
  document.addEventListener("dragover", (event) => {
    if (!isOfFiles(event)) return;
    event.preventDefault();
    over(true);
  });
  document.addEventListener("dragleave", (event) => { if (event.relatedTarget === null) over(false); });
  document.addEventListener("drop", (event) => {
    if (!isOfFiles(event)) return;
    event.preventDefault();
    over(false);
    void readAll(lab, [...event.dataTransfer!.files]).then((files) => files.length ? open(files) : undefined);
  });
  return ask;
}

async function readAll(lab: PageLab, files: File[]): Promise<OpenedFile[]> {
  const large = files.find((file) => file.size > MOST_BYTES);
  if (large) {
    lab.refuse(`${large.name}: found ${(large.size / 1e9).toFixed(1)} GB, must be at most 1 GB here; avo replays larger recordings`);
    return [];
  }
  try {
    return await Promise.all(files.map(async (file) => ({ name: file.name, bytes: new Uint8Array(await file.arrayBuffer()) })));
  } catch {
    lab.refuse("the browser could not read what was dropped: drop files, not folders");
    return [];
  }
}
