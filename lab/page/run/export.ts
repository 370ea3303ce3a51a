// SPDX-License-Identifier: Apache-2.0
// Exports the run as files: the scene, a table of states, pictures and films. All are made here, and the browser saves
// them.
import type { Lab } from "./lab.ts";
import { csvOf } from "../data/csv_writer.ts";
import { GifEncoder } from "../data/gif.ts";
import { element } from "../frame/elements.ts";
import type { PageLab } from "./make_lab.ts";
import { RecordedRun } from "./recorded_run.ts";

export interface Progress {
  tell(share: number): void;  // 0 to 1
  readonly cancelled: boolean;
}

/** Returns the scene's name as a file name. */
export function fileName(lab: Lab, ending: string): string {
  const base = lab.name.replace(/\.(ya?ml|csv|h5)$/i, "").replace(/[^\w.-]+/g, "-").replace(/^-+|-+$/g, "");
  return `${base || "scene"}.${ending}`;
}

export function download(name: string, blob: Blob): void {
  const address = URL.createObjectURL(blob);
  element("a", { href: address, download: name }).click();
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
}

export function saveYaml(lab: Lab): void {
  if (!lab.text) throw new Error("this recording does not hold its scene, so there is none to save");
  download(fileName(lab, "yaml"), new Blob([lab.text], { type: "application/yaml" }));
}

const MEANWHILE = "another run was opened meanwhile, so nothing was saved";

/** Shows the run at each of `times`, in order, and then continues as before. A recording is read meanwhile. */
async function walk(lab: PageLab, times: number[], progress: Progress, visit: (k: number) => Promise<void> | void): Promise<void> {
  const { run, playing } = lab;
  const back = lab.moment.time;
  lab.pause();
  for (let k = 0; k < times.length && !progress.cancelled; ++k) {
    if (lab.run !== run) throw new Error(MEANWHILE);
    lab.seek(times[k]!);
    if (Math.abs(lab.moment.time - times[k]!) > 1e-6) await arrival(lab, times[k]!);
    if (lab.run !== run) throw new Error(MEANWHILE);
    await visit(k);
    progress.tell((k + 1) / times.length);
    if (k % 16 === 15) await pause(0);  // so that the page stays responsive
  }
  if (lab.run !== run) return;
  lab.seek(back);
  if (playing) lab.play();
}

const pause = (milliseconds: number): Promise<void> => new Promise((done) => setTimeout(done, milliseconds));

function arrival(lab: Lab, time: number): Promise<void> {
  return new Promise((done) => {
    const finish = (): void => {
      stop();
      clearTimeout(timer);
      done();
    };
    const stop = lab.on("moment", () => Math.abs(lab.moment.time - time) <= 1e-6 && finish());
    const timer = setTimeout(finish, 3000);
  });
}

const timesSoFar = (lab: Lab): number[] => [...lab.past.times.subarray(0, lab.past.size)];

/** Returns the table that `avo run --record` writes: all steps of the run so far, or all rows of a recording. */
export async function csvOfRun(lab: PageLab, progress: Progress): Promise<string> {
  const { library, run } = lab;
  const parts: string[] = [];
  if (run instanceof RecordedRun) {
    const { dimensions, headings, every, times } = run.recording;
    for (let k = 0; k < times.length && !progress.cancelled; ++k) {
      parts.push(csvOf(library, await run.recording.frame(k), { dimensions, headings, every, begins: k === 0 }));
      progress.tell((k + 1) / times.length);
      if (k % 16 === 15) await pause(0);  // so that the page stays responsive
    }
    return parts.join("");
  }
  const turning = new Set(lab.info.robots.filter(({ model }) => model !== "holonomic").map(({ robot }) => robot));
  await walk(lab, timesSoFar(lab), progress, (k) => {
    const heading = lab.moment.heading.map((angle, i) => (turning.has(lab.moment.robot[i]!) ? angle : NaN));
    parts.push(csvOf(library, { ...lab.moment, heading }, { dimensions: lab.moment.dimensions, headings: turning.size > 0, every: 1, begins: k === 0 }));
  });
  return parts.join("");
}

export async function saveCsv(lab: PageLab, progress: Progress): Promise<void> {
  const text = await csvOfRun(lab, progress);
  if (!progress.cancelled) download(fileName(lab, "csv"), new Blob([text], { type: "text/csv" }));
}

function requirePicture(lab: Lab): NonNullable<Lab["picture"]> {
  if (!lab.picture) throw new Error("there is no picture to save: this browser does not draw with WebGL2");
  return lab.picture;
}

export async function savePng(lab: Lab): Promise<void> {
  const picture = requirePicture(lab);
  picture.draw();
  const blob = await new Promise<Blob | null>((done) => picture.canvas.toBlob(done, "image/png"));
  if (blob) download(fileName(lab, "png"), blob);
}

/** Returns a picture of the velocity space of the selected robot, as on the screen. */
export async function saveVelocitySpace(lab: Lab): Promise<void> {
  const canvas = document.querySelector<HTMLCanvasElement>(".insp:not([hidden]) .insp-canvas");
  if (!canvas || lab.selected === null) throw new Error("select a robot first: its velocity space is what is saved");
  const blob = await new Promise<Blob | null>((done) => canvas.toBlob(done, "image/png"));
  if (blob) download(fileName(lab, `robot-${lab.selected}.png`), blob);
}

const FILM_FRAMES = 150;     // the most frames
const FILM_WIDTH = 640;      // px, the largest width
const FRAME_TIME = 0.05;     // s of the film, from frame to frame

/** Films moments of the run so far, evenly spaced, with the scene's title and the time over each picture. */
function filmTimes(lab: Lab): number[] {
  const times = timesSoFar(lab);
  const every = Math.max(1, Math.ceil(times.length / FILM_FRAMES));
  return times.filter((_, k) => k % every === 0);
}

class Film {
  readonly canvas: HTMLCanvasElement;
  private readonly context: CanvasRenderingContext2D;
  constructor(private readonly lab: Lab) {
    const { canvas } = requirePicture(lab);
    const scale = Math.min(1, FILM_WIDTH / canvas.width);
    const even = (length: number): number => Math.max(2, 2 * Math.round(0.5 * scale * length));  // codecs require even sizes
    this.canvas = element("canvas", { width: even(canvas.width), height: even(canvas.height) });
    this.context = this.canvas.getContext("2d", { willReadFrequently: true })!;
  }
  take(): void {
    const picture = requirePicture(this.lab);
    picture.draw();
    const { width, height } = this.canvas;
    this.context.drawImage(picture.canvas, 0, 0, width, height);
    this.context.font = "13px system-ui, sans-serif";
    this.context.textBaseline = "bottom";
    this.context.fillStyle = this.lab.theme === "dark" ? "#ffffff" : "#000000";
    this.context.fillText(`${this.lab.info.name} · ${this.lab.info.options.method} · ${this.lab.moment.time.toFixed(1)} s`, 8, height - 6);
  }
  pixels(): Uint8ClampedArray {
    return this.context.getImageData(0, 0, this.canvas.width, this.canvas.height).data;
  }
}

export async function saveGif(lab: PageLab, progress: Progress): Promise<void> {
  const film = new Film(lab);
  const encoder = new GifEncoder(film.canvas.width, film.canvas.height, { delay: FRAME_TIME });
  await walk(lab, filmTimes(lab), progress, () => {
    film.take();
    encoder.add(film.pixels());
  });
  if (!progress.cancelled) download(fileName(lab, "gif"), new Blob([encoder.finish() as BlobPart], { type: "image/gif" }));
}

/** Films in real time, so it takes as long as the film. */
export async function saveWebm(lab: PageLab, progress: Progress): Promise<void> {
  const type = ["video/webm;codecs=vp9", "video/webm;codecs=vp8", "video/webm"]
    .find((candidate) => typeof MediaRecorder !== "undefined" && MediaRecorder.isTypeSupported(candidate));
  if (!type) throw new Error("this browser does not record WebM: save a GIF instead");
  const film = new Film(lab);
  const stream = film.canvas.captureStream();
  const recorder = new MediaRecorder(stream, { mimeType: type, videoBitsPerSecond: 4e6 });
  const parts: Blob[] = [];
  recorder.addEventListener("dataavailable", (event) => parts.push(event.data));
  const stopped = new Promise((done) => recorder.addEventListener("stop", done));
  let next = performance.now();
  await walk(lab, filmTimes(lab), progress, async (k) => {
    film.take();
    if (k === 0) recorder.start();
    next = Math.max(next + 1000 * FRAME_TIME, performance.now());
    await pause(next - performance.now());
  });
  if (recorder.state !== "inactive") recorder.stop();
  await stopped;
  stream.getTracks().forEach((track) => track.stop());
  if (!progress.cancelled) download(fileName(lab, "webm"), new Blob(parts, { type: "video/webm" }));
}
