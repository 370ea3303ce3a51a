// SPDX-License-Identifier: Apache-2.0
// Outputs of the lab: a link to the scene, files of the run, and the tour of the paper.
import { element } from "./elements.ts";
import type { Progress } from "../run/export.ts";
import { saveCsv, saveGif, savePng, saveVelocitySpace, saveWebm, saveYaml } from "../run/export.ts";
import type { PageLab } from "../run/make_lab.ts";
import { putIntoAddress } from "../text/share.ts";
import { openTour } from "../guide/tour.ts";

interface Saving {
  label: string;
  says: string;
  save(lab: PageLab, progress: Progress): Promise<void> | void;
  lacks?(lab: PageLab): string;  // names what the file lacks
}

const SAVINGS: Saving[] = [
  { label: "Scene (YAML)", says: "what avo run, avo lab and this page read", save: saveYaml, lacks: besidesText },
  { label: "States so far (CSV)", says: "every step, for avo check and spreadsheets", save: saveCsv },
  { label: "Picture (PNG)", says: "the world as it is on the screen", save: savePng },
  { label: "Velocity space (PNG)", says: "of the selected robot", save: saveVelocitySpace },
  { label: "Animation (GIF)", says: "the run so far, for slides and web pages", save: saveGif },
  { label: "Film (WebM)", says: "the run so far, sharper than a GIF", save: saveWebm },
];

export function mountTools(lab: PageLab, root: HTMLElement, dialog: HTMLElement): void {
  const said = element("span", { class: "tool-said", role: "status" });
  const tour = element("button", { type: "button", class: "tool-button", title: "the paper in six steps", onclick: () => openTour(lab, dialog) }, "Tour");
  const link = element("button", { type: "button", class: "tool-button", title: "copy a link that holds the whole scene" }, "Copy link");
  link.addEventListener("click", () => void copyLink(lab, said));
  const menu = saveMenu(lab, said);
  root.replaceChildren(tour, link, menu, said);
}

let timer = 0;
function tell(said: HTMLElement, text: string, isError = false): void {
  said.textContent = text;
  said.classList.toggle("tool-error", isError);
  clearTimeout(timer);
  timer = window.setTimeout(() => (said.textContent = ""), isError ? 9000 : 4000);
}

const BY_HAND = "what was changed on the map alone";

/** Names the changes of the run that its text does not contain. */
function besidesText(lab: PageLab): string {
  const { overrides = [], start_at_rest, limit_speed } = lab.options;
  const missing = overrides.map((override) => `--set ${override}`);
  if (start_at_rest) missing.push("--start-at-rest");
  if (limit_speed) missing.push("--limit-speed");
  if (lab.run.handmade) missing.push(BY_HAND);
  return missing.length > 0 ? `, without ${missing.join(", ")}` : "";
}

const messageOf = (error: unknown): string => (error instanceof Error ? error.message : String(error));

async function copyLink(lab: PageLab, said: HTMLElement): Promise<void> {
  try {
    const link = await putIntoAddress(lab);
    const copied = await navigator.clipboard.writeText(link).then(() => true, () => false);
    const missing = lab.run.handmade ? `, without ${BY_HAND}` : "";
    tell(said, copied ? `Link copied: it holds the whole scene${missing}` : `The link is in the address bar: copy it there${missing}`);
  } catch (error) {
    tell(said, messageOf(error), true);
  }
}

function saveMenu(lab: PageLab, said: HTMLElement): HTMLElement {
  const details = element("details", { class: "tool-menu" });
  const close = (): void => details.removeAttribute("open");
  const items = SAVINGS.map((saving) => element("button", {
    type: "button", role: "menuitem",
    onclick() {
      close();
      void run(lab, saving, said);
    },
  }, element("b", {}, saving.label), element("small", {}, saving.says)));
  details.append(element("summary", { class: "tool-button" }, "Save as"), element("div", { class: "tool-items", role: "menu" }, ...items));
  details.addEventListener("keydown", (event) => {
    const at = items.indexOf(document.activeElement as HTMLButtonElement);
    if (event.key === "Escape") {
      close();
      details.querySelector("summary")!.focus();
    } else if (event.key === "ArrowDown") items[(at + 1) % items.length]!.focus();
    else if (event.key === "ArrowUp") items[(at + items.length - 1) % items.length]!.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  document.addEventListener("pointerdown", (event) => {
    if (!details.contains(event.target as Node)) close();
  });
  return details;
}

/** Saves with a bar that shows the progress, and a button to cancel. */
async function run(lab: PageLab, saving: Saving, said: HTMLElement): Promise<void> {
  let cancelled = false;
  const bar = element("progress", { max: 1, value: 0 });
  const cancel = element("button", { type: "button", class: "tool-button", onclick: () => (cancelled = true) }, "Cancel");
  // the dialog blocks changes while the run is shown from its start on
  const shown = element("dialog", { class: "tool-progress", "aria-label": `saving: ${saving.label}` }, `${saving.label} …`, bar, cancel);
  shown.addEventListener("cancel", () => (cancelled = true));
  document.body.append(shown);
  shown.showModal();
  try {
    await saving.save(lab, { tell: (share) => (bar.value = share), get cancelled() { return cancelled; } });
    tell(said, cancelled ? "Cancelled" : `Saved: ${saving.label}${saving.lacks?.(lab) ?? ""}`);
  } catch (error) {
    tell(said, messageOf(error), true);
  } finally {
    shown.close();
    shown.remove();
  }
}
