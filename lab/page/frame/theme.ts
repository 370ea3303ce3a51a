// SPDX-License-Identifier: Apache-2.0
// Dark or light: as in the system, until the user chooses.
import type { PageLab } from "../run/make_lab.ts";

const KEY = "avo-lab-theme";

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;  // some browsers refuse storage to pages from files
  }
}

const system = matchMedia("(prefers-color-scheme: dark)");

export function chosenTheme(): "light" | "dark" {
  const known = stored();
  return known === "dark" || known === "light" ? known : system.matches ? "dark" : "light";
}

export function mountTheme(lab: PageLab, button: HTMLElement): void {
  const show = (theme: "light" | "dark") => {
    document.documentElement.dataset["theme"] = theme;
    button.textContent = theme === "dark" ? "☀" : "☾";
    button.title = theme === "dark" ? "light colors" : "dark colors";
    button.setAttribute("aria-label", button.title);
    lab.theme = theme;
    lab.say("theme");
  };
  show(chosenTheme());
  system.addEventListener("change", () => { if (!stored()) show(system.matches ? "dark" : "light"); });
  button.addEventListener("click", () => {
    const theme = lab.theme === "dark" ? "light" : "dark";
    try {
      localStorage.setItem(KEY, theme);
    } catch {
      // then the choice lasts as long as the page
    }
    show(theme);
  });
}
