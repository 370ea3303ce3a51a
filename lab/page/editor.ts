// SPDX-License-Identifier: Apache-2.0
// The scene's text: it is checked while it is typed, and runs when it is applied.
import { AvoError } from "../avo/avo.ts";
import { element } from "./elements.ts";
import type { SceneDraft } from "./lab.ts";
import type { PageLab } from "./make_lab.ts";

const PAUSE = 350;       // ms without a key, then the text is checked
const LINE = 18, COLUMN = 7.2;  // pixels
const LONGEST = 300000;  // characters of a refused text that is shown to be corrected

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
  root.replaceChildren(
    element("div", { class: "editor-field" }, numbers, element("div", { class: "editor-room" }, band, text)),
    says, element("div", { class: "editor-actions" }, apply, revert));
  return { text, numbers, band, says, apply, revert };
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

/** So that the place of an error is seen. */
function scrollTo(field: Field, { line, column }: AvoError): void {
  const { text } = field;
  if (!line) return;
  text.scrollTop = Math.max(0, LINE * (line - 1) - text.clientHeight / 2);
  text.scrollLeft = Math.max(0, COLUMN * (column ?? 1) - text.clientWidth * 0.85);
  scroll(field);
}

export function mountEditor(lab: PageLab, root: HTMLElement): void {
  const field = makeField(root);
  const { text } = field;
  let draft: SceneDraft | null = null;  // a text of another scene, to be corrected
  const changed = () => text.value !== lab.text;
  const mark = (error: AvoError | null) => {
    markLine(field, error);
    field.says.classList.toggle("bad", error !== null);
    field.says.textContent = error ? error.message : changed() ? "Not applied yet: Ctrl+Enter runs it from its start." : "";
    root.classList.toggle("changed", changed());
  };
  const check = () => {
    if (!changed()) return mark(null);
    try {
      lab.library.simulate(text.value, { ...(draft ?? lab).options, name: (draft ?? lab).name });
      mark(null);
    } catch (error) {
      mark(error instanceof AvoError ? error : new AvoError(String(error)));
    }
  };
  const show = (yaml: string) => {
    const { scrollTop, scrollLeft } = text;
    text.value = yaml;
    text.readOnly = yaml === "";
    text.placeholder = "This recording does not hold its scene.";
    text.scrollTop = scrollTop;
    text.scrollLeft = scrollLeft;
    countLines(field);
    scroll(field);
  };
  const showRunning = () => {
    draft = null;
    show(lab.text);
    mark(null);
  };
  lab.on("error", () => {
    const { error, refused } = lab;
    if (!error || !refused || refused.yaml.length > LONGEST) return;
    draft = refused;
    if (text.value !== refused.yaml) show(refused.yaml);
    mark(error);
    scrollTo(field, error);
  });
  let last = lab.text;
  lab.on("text", () => {
    const isTyped = ![last, lab.text, draft?.yaml].includes(text.value);  // and so not overwritten
    if (!isTyped) showRunning();
    else check();
    last = lab.text;
  });
  listenToKeys(root, field, check, () => lab.openText(text.value, (draft ?? lab).name, (draft ?? lab).options));
  field.revert.addEventListener("click", showRunning);
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
