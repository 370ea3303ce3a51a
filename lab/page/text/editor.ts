// SPDX-License-Identifier: Apache-2.0
// The scene's text: it is checked while the user types, and runs when it is applied.
import { AvoError } from "../../avo/avo.ts";
import { element } from "../frame/elements.ts";
import type { SceneDraft } from "../run/lab.ts";
import type { PageLab } from "../run/make_lab.ts";

const PAUSE = 350;       // ms without a key, then the text is checked
const LINE = 18, COLUMN = 7.2;  // pixels
const LONGEST = 300000;  // characters; a longer refused text is not shown for correction

type Field = ReturnType<typeof makeField>;

function makeField(root: HTMLElement) {
  const text = element("textarea", {
    class: "editor-text", spellcheck: "false", autocapitalize: "off", autocomplete: "off", wrap: "off", "aria-label": "the scene as YAML",
    title: "Ctrl+Enter runs it, Escape leaves it",
  });
  const numbers = element("div", { class: "editor-numbers", "aria-hidden": "true" });
  const band = element("div", { class: "editor-band", hidden: true }, element("i", {}));
  const says = element("p", { class: "editor-says", role: "status" });
  const apply = element("button", { type: "button", class: "tool-button primary", title: "run this text from its start (Ctrl+Enter)" }, "Apply");
  const revert = element("button", { type: "button", class: "tool-button", title: "back to the text that runs" }, "Revert");
  const back = element("button", { type: "button", class: "tool-button editor-back", hidden: true });
  root.replaceChildren(
    element("div", { class: "editor-field" }, numbers, element("div", { class: "editor-room" }, band, text)),
    says, element("div", { class: "editor-actions" }, apply, revert), back);
  return { text, numbers, band, says, apply, revert, back };
}

/** Puts another text into the field, at the scroll position of the last one. */
function fill(field: Field, yaml: string): void {
  const { text } = field;
  const { scrollTop, scrollLeft } = text;
  text.value = yaml;
  text.readOnly = yaml === "";
  text.placeholder = "This recording does not hold its scene.";
  text.scrollTop = scrollTop;
  text.scrollLeft = scrollLeft;
  countLines(field);
  scroll(field);
}

/** Texts that were typed, but replaced by another scene before they ran; the button brings the last one back. */
function keptBy({ back }: Field) {
  const drafts: SceneDraft[] = [];
  const tell = (): void => {
    const last = drafts.at(-1);
    back.hidden = !last;
    back.textContent = `Back to your text of ${last?.name}`;
  };
  return {
    push(draft: SceneDraft): void {
      drafts.push(draft);
      tell();
    },
    pop(): SceneDraft | undefined {
      const draft = drafts.pop();
      tell();
      return draft;
    },
  };
}

/** Line numbers and the mark of an error move with the text. */
function scroll({ text, numbers, band }: Field): void {
  numbers.style.transform = `translateY(${-text.scrollTop}px)`;
  band.style.transform = `translate(${-text.scrollLeft}px, ${-text.scrollTop}px)`;
}

function countLines({ text, numbers }: Field): void {
  const lines = text.value.split("\n").length;
  if (numbers.childElementCount === lines) return;
  numbers.replaceChildren(...Array.from({ length: lines }, (_, k) => element("span", {}, String(k + 1))));
}

function markLine({ numbers, band }: Field, error: AvoError | null): void {
  band.hidden = !error?.line;
  numbers.querySelector(".bad")?.classList.remove("bad");
  if (!error?.line) return;
  band.style.setProperty("--line", String(error.line - 1));
  band.style.setProperty("--column", String((error.column ?? 1) - 1));
  numbers.children[error.line - 1]?.classList.add("bad");
}

/** Scrolls to the place of an error. */
function scrollTo(field: Field, { line, column }: AvoError): void {
  const { text } = field;
  if (!line) return;
  text.scrollTop = Math.max(0, LINE * (line - 1) - text.clientHeight / 2);
  text.scrollLeft = Math.max(0, COLUMN * (column ?? 1) - text.clientWidth * 0.85);
  scroll(field);
}

function refusalOf(lab: PageLab, yaml: string, { name, options }: Omit<SceneDraft, "yaml">): AvoError | null {
  try {
    lab.library.simulate(yaml, { ...options, name });
    return null;
  } catch (error) {
    return error instanceof AvoError ? error : new AvoError(String(error));
  }
}

const unapplied = (other: SceneDraft | null): string =>
  `${other ? `The text of ${other.name}, not` : "Not"} applied yet: Ctrl+Enter runs it from its start.`;

export function mountEditor(lab: PageLab, root: HTMLElement): void {
  const field = makeField(root);
  const { text } = field;
  let draft: SceneDraft | null = null;  // a text of another scene, for correction or restored
  let given = lab.text;                 // the original text, before typing
  let { name, options } = lab;          // of the shown scene
  const kept = keptBy(field);
  const target = () => draft ?? { name, options };
  const changed = () => text.value !== lab.text;
  const mark = (error: AvoError | null) => {
    markLine(field, error);
    field.says.classList.toggle("bad", error !== null);
    field.says.textContent = error ? error.message : changed() ? unapplied(draft?.name === name ? null : draft) : "";
    root.classList.toggle("changed", changed());
  };
  const check = () => mark(changed() ? refusalOf(lab, text.value, target()) : null);
  const show = (yaml: string, other: SceneDraft | null) => {
    given = yaml;
    draft = other;
    fill(field, yaml);
  };
  /** Returns whether the text was typed or refused, and not applied. A slider's changes may replace any other text. */
  const isOwn = () => changed() && (draft !== null || text.value !== given);
  /** Saves the text before another one replaces it. */
  const keep = () => { if (isOwn()) kept.push({ ...target(), yaml: text.value }); };
  const showRunning = () => {
    show(lab.text, null);
    mark(null);
  };
  lab.on("error", () => {
    const { error, refused } = lab;
    if (!error || !refused || refused.yaml.length > LONGEST) return;
    if (text.value === refused.yaml) draft = refused;  // the user typed it here
    else keep(), show(refused.yaml, refused);
    mark(error);
    scrollTo(field, error);
  });
  lab.on("text", () => {
    const isOther = lab.options !== options || lab.name !== name;
    const stays = isOwn() && !isOther;
    if (isOther) keep();
    ({ name, options } = lab);
    if (!stays) showRunning();
    else check();
  });
  listenToKeys(root, field, check, () => lab.openText(text.value, target().name, target().options));
  field.revert.addEventListener("click", showRunning);
  field.back.addEventListener("click", () => {
    const back = kept.pop();
    if (!back) return;
    keep();
    show(back.yaml, back);
    given = "";  // treat it as typed now
    check();
  });
  showRunning();
}

function listenToKeys(root: HTMLElement, field: Field, check: () => void, run: () => void): void {
  const { text } = field;
  let timer = 0;
  text.addEventListener("scroll", () => scroll(field));
  text.addEventListener("input", () => {
    countLines(field);
    root.classList.add("changed");
    clearTimeout(timer);
    timer = window.setTimeout(check, PAUSE);
  });
  text.addEventListener("keydown", (event) => {
    event.stopPropagation();  // letters are text here, not commands
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) run();
    else if (event.key === "Tab" && !event.shiftKey) document.execCommand("insertText", false, "  ");
    else if (event.key === "Escape") text.blur();
    else return;
    event.preventDefault();
  });
  field.apply.addEventListener("click", run);
}
