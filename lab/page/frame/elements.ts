// SPDX-License-Identifier: Apache-2.0
// Makes elements of the page in one expression each, and formats numbers for people.

type Child = Node | string | null;

/** Makes an element. `class` is a string, `on…` a listener, `true` an attribute without a value, `false` none; other
 * values are attributes. */
export function element<K extends keyof HTMLElementTagNameMap>(
  name: K, attributes: Record<string, string | number | boolean | ((event: never) => void)> = {}, ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (typeof value === "function") made.addEventListener(key.slice(2), value as EventListener);
    else if (typeof value === "boolean") made.toggleAttribute(key, value);
    else made.setAttribute(key, String(value));
  }
  made.append(...children.filter((child) => child !== null));
  return made;
}

/** Returns digits with a minus sign that is as wide as a plus, without -0, and with words for non-finite values. */
export function digits(value: number, places = 2): string {
  if (!Number.isFinite(value)) return Number.isNaN(value) ? "–" : value > 0 ? "∞" : "−∞";
  const text = value.toFixed(places);
  return Number(text) === 0 ? text.replace("-", "") : text.replace("-", "−");
}

/** A press beside the dialog closes it, but not a press on its rim: a phone has no Escape. */
export function closeFromBeside(dialog: HTMLDialogElement): void {
  dialog.addEventListener("click", (event) => {
    const { left, right, top, bottom } = dialog.getBoundingClientRect();
    const isInside = event.clientX >= left && event.clientX <= right && event.clientY >= top && event.clientY <= bottom;
    if (event.target === dialog && !isInside) dialog.close();
  });
}

/** Calls `work` once before the next frame, however often this is called. */
export function oncePerFrame(work: () => void): () => void {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      work();
    });
  };
}

/** Returns a cleared 2D context in pixels of CSS, at the full resolution of the screen. */
export function crispContext(canvas: HTMLCanvasElement, width: number, height: number): CanvasRenderingContext2D {
  const density = Math.max(1, window.devicePixelRatio || 1);
  const columns = Math.max(1, Math.round(width * density)), rows = Math.max(1, Math.round(height * density));
  if (canvas.width !== columns || canvas.height !== rows) canvas.width = columns, canvas.height = rows;
  const context = canvas.getContext("2d")!;
  context.setTransform(columns / width, 0, 0, rows / height, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}
