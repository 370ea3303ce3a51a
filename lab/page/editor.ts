// SPDX-License-Identifier: Apache-2.0
// The scene's text: it is checked while it is typed, and runs when it is applied.
import { AvoError } from "../avo/avo.ts";
import { element } from "./elements.ts";
import type { SceneDraft } from "./lab.ts";
import type { PageLab } from "./make_lab.ts";

const PAUSE = 350;       // ms without a key, then the text is checked
const LINE = 18, COLUMN = 7.2;  // pixels
const LONGEST = 300000;  // characters of a refused text that is shown to be corrected

export function mountEditor(lab: PageLab, root: HTMLElement): void {
  const text = element("textarea", {
    class: "editor-text", spellcheck: "false", autocapitalize: "off", autocomplete: "off", wrap: "off", "aria-label": "the scene as YAML",
  });
  const numbers = element("div", { class: "editor-numbers", "aria-hidden": "true" });
  const band = element("div", { class: "editor-band", hidden: true }, element("i", {}));
  const says = element("p", { class: "editor-says", role: "status" });
  const apply = element("button", { type: "button", class: "tool-button primary", title: "run this text from its start (Ctrl+Enter)" }, "Apply");
  const revert = element("button", { type: "button", class: "tool-button", title: "back to the text that runs" }, "Revert");
  root.replaceChildren(
    element("div", { class: "editor-field" }, numbers, element("div", { class: "editor-room" }, band, text)),
    says, element("div", { class: "editor-actions" }, apply, revert));

  let timer = 0;
  let draft: SceneDraft | null = null;  // a text of another scene, to be corrected
  const changed = () => text.value !== lab.text;
  const scroll = () => {
    numbers.style.transform = `translateY(${-text.scrollTop}px)`;
    band.style.transform = `translate(${-text.scrollLeft}px, ${-text.scrollTop}px)`;
  };
  const count = () => {
    const lines = text.value.split("\n").length;
    if (numbers.childElementCount === lines) return;
    numbers.replaceChildren(...Array.from({ length: lines }, (_, k) => element("span", {}, String(k + 1))));
  };
  const mark = (error: AvoError | null) => {
    band.hidden = !error?.line;
    numbers.querySelector(".bad")?.classList.remove("bad");
    if (error?.line) {
      band.style.setProperty("--line", String(error.line - 1));
      band.style.setProperty("--column", String((error.column ?? 1) - 1));
      numbers.children[error.line - 1]?.classList.add("bad");
    }
    says.classList.toggle("bad", error !== null);
    says.textContent = error ? error.message : changed() ? "Not applied yet: Ctrl+Enter runs it from its start." : "";
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
  const run = () => {
    lab.openText(text.value, (draft ?? lab).name, (draft ?? lab).options);
    if (lab.error) mark(lab.error);
  };
  /** So that the place of an error is seen. */
  const scrollTo = ({ line, column }: AvoError) => {
    if (!line) return;
    text.scrollTop = Math.max(0, LINE * (line - 1) - text.clientHeight / 2);
    text.scrollLeft = Math.max(0, COLUMN * (column ?? 1) - text.clientWidth * 0.85);
    scroll();
  };
  text.addEventListener("scroll", scroll);
  text.addEventListener("input", () => {
    count();
    root.classList.toggle("changed", changed());
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
  apply.addEventListener("click", run);
  revert.addEventListener("click", () => show());

  const show = () => {
    draft = null;
    const { scrollTop, scrollLeft } = text;
    text.value = lab.text;
    text.readOnly = lab.text === "";
    text.placeholder = "This recording does not hold its scene.";
    text.scrollTop = scrollTop;
    text.scrollLeft = scrollLeft;
    count();
    mark(null);
    scroll();
  };
  lab.on("error", () => {
    const { error, refused } = lab;
    if (!error || !refused || refused.yaml.length > LONGEST) return;
    if (text.value !== refused.yaml) {
      draft = refused;
      text.value = refused.yaml;
      count();
    }
    mark(error);
    scrollTo(error);
  });
  let last = lab.text;
  lab.on("text", () => {
    if (text.value === last || text.value === lab.text) show();  // what is being typed is not overwritten
    else check();
    last = lab.text;
  });
  show();
}
