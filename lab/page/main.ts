// SPDX-License-Identifier: Apache-2.0
// The start of the page: it unpacks the module, opens a scene, and builds the panels.
import { load, type Library } from "../avo/avo.ts";
import { mountCharts } from "./run/charts.ts";
import { bytesOfBase64, uncompressed } from "./data/compression.ts";
import { mountFigures } from "./run/figures.ts";
import { mountFiles } from "./run/files.ts";
import { mountHelp } from "./guide/help.ts";
import { mountHint } from "./guide/hint.ts";
import { first, openInput, type Input } from "./run/input.ts";
import { mountInspector } from "./inspector/inspector.ts";
import { mountKeys } from "./frame/keys.ts";
import type { Lab } from "./run/lab.ts";
import type { PageLab } from "./run/make_lab.ts";
import { mountMapControls } from "./map/map_controls.ts";
import { mountNotice } from "./frame/notice.ts";
import { mountPointer, type Hand } from "./map/pointer.ts";
import { mountScenePanel } from "./text/scene_panel.ts";
import { mountScenePicker } from "./text/scene_picker.ts";
import { keepAddressTrue, openFromAddress } from "./text/share.ts";
import { mountTabs } from "./frame/tabs.ts";
import { mountTheme, chosenTheme } from "./frame/theme.ts";
import { mountTools } from "./frame/tools.ts";
import { mountTransport } from "./run/transport.ts";
import { toPixels } from "./map/camera.ts";
import { makeWorldView, type WorldView } from "./map/world_view.ts";

const MOST_MODULE_BYTES = 64e6;

/** The Lab at window.avoLab, for tests and for curious users. */
interface OpenLab extends Lab {
  ready: Promise<void>;                                // resolved when the first picture is drawn
  toScreen(place: [number, number, number?]): [number, number]; // from m to CSS pixels of the page
  resetView(): void;                                   // shows everything
}

const at = (id: string): HTMLElement => document.getElementById(id)!;

async function unpack(): Promise<Library> {
  const packed = bytesOfBase64(at("avo-module").textContent!.trim());
  return load(await uncompressed(packed, "gzip", MOST_MODULE_BYTES));
}

function mountPanels(lab: PageLab): WorldView {
  mountTheme(lab, at("theme"));
  mountTabs(lab, at("tabs"));
  mountNotice(lab, at("notice"));
  const view = makeWorldView(lab, at("world") as HTMLCanvasElement);
  const hand: Hand = { tool: "move" };
  const chooseTool = mountMapControls(lab, view, hand, { palette: at("palette"), zoom: at("zoom"), legend: at("legend") });
  mountPointer(lab, view, hand, at("tip"));
  mountFigures(lab, at("figures"));
  mountTransport(lab, at("transport"));
  mountScenePanel(lab, at("scene"));
  mountInspector(lab, at("inspector"));
  mountCharts(lab, at("charts"));
  mountTools(lab, at("tools"), at("dialog"));
  const scenes = mountScenePicker(lab, at("scenes"), at("dialog"));
  const files = mountFiles(lab, at("open"));
  const help = mountHelp(at("help"), at("dialog"));
  mountHint(lab, at("hint"));
  mountKeys(lab, view, { scenes, files, help, tool: chooseTool });
  lab.picture = { canvas: view.canvas, draw: () => view.draw() };
  return view;
}

/** Advances the time while pictures are drawn. */
function keepGoing(lab: PageLab, view: WorldView): void {
  let last = performance.now();
  const frame = (now: number): void => {
    lab.frame(Math.max(0, now - last) / 1000);
    last = now;
    view.frame();
    requestAnimationFrame(frame);
  };
  requestAnimationFrame(frame);
}

function publish(lab: PageLab, view: WorldView, ready: Promise<void>): void {
  const open: Pick<OpenLab, "ready" | "toScreen" | "resetView"> = {
    ready,
    toScreen(place) {
      const box = view.canvas.getBoundingClientRect();
      const [px, py] = view.shown.project(place[0], place[1], place[2] ?? 0);
      const [x, y] = toPixels(view.camera, px, py);
      return [box.left + x, box.top + y];
    },
    resetView: () => view.fit(),
  };
  (window as unknown as { avoLab: OpenLab }).avoLab = Object.assign(lab, open);
}

/** Opens a link, which takes precedence over the page's own input. A damaged link is reported over that input. */
async function openBeginning(lab: PageLab, input: Input | null): Promise<void> {
  const linked = await openFromAddress(lab).catch((error: Error) => error);
  if (linked === true) return;
  if (input) await openInput(lab, input);
  if (linked) lab.refuse(linked.message);
}

async function begin(): Promise<void> {
  document.documentElement.dataset["theme"] = chosenTheme();
  const input = JSON.parse(at("avo-input").textContent!) as Input | null;
  document.body.classList.toggle("embedded", input?.embedded === true);
  const library = await unpack();
  const lab = first(library);
  const view = mountPanels(lab);
  const opened = openBeginning(lab, input).then(() => view.draw());
  keepAddressTrue(lab);
  window.addEventListener("hashchange", () => { openFromAddress(lab).catch((error: Error) => lab.refuse(error.message)); });
  publish(lab, view, opened);
  await opened;
  keepGoing(lab, view);
}

begin().catch((error: unknown) => {
  const notice = at("notice");
  notice.hidden = false;
  notice.textContent = `The lab cannot start: ${error instanceof Error ? error.message : String(error)}.`;
});
