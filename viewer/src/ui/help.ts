// The help that lies over the page: what keys, mouse and fingers do.

import { button, element, icon } from "./dom";
import { CLOSE } from "./icons";
import type { Shortcut } from "./keys";

const POINTER = [
  ["drag, one finger", "turn the view"],
  ["right drag, two fingers", "move the view"],
  ["wheel, pinch", "nearer, farther"],
  ["click, tap on a body", "select it; on nothing: deselect"],
  ["click in a plot", "go to that time"],
  ["Ctrl + wheel, pinch in a plot", "zoom in time; double click: all"],
] as const;

const GROUPS = ["Play", "View", "Show", "Panels"] as const;

/** A function that opens the help, and closes it again. */
export function help(root: HTMLElement, shortcuts: readonly Shortcut[]): () => void {
  const box = element("dialog", { class: "sheet help", "aria-labelledby": "help-title" });
  const close = button("Close", icon(...CLOSE), "Escape", () => box.close());
  const fingers = table("Mouse and fingers", POINTER);
  const hasKeys = !matchMedia("(pointer: coarse)").matches;
  box.append(
    element("header", {}, element("h2", { id: "help-title" }, "Keys, mouse, fingers"), close),
    element("div", { class: "help-columns" },
      ...(hasKeys ? [] : [fingers]),
      ...GROUPS.map((group) => table(group, shortcuts.filter((one) => one.group === group).map((one) => [one.print, one.does]))),
      ...(hasKeys ? [fingers] : [])),
  );
  box.addEventListener("click", (event) => event.target === box && box.close());
  root.append(box);
  return () => (box.open ? box.close() : box.showModal());
}

function table(name: string, rows: readonly (readonly [string, string])[]): HTMLElement {
  const asKeys = (text: string): (Node | string)[] => (rows === POINTER ? [text] : caps(text));
  const lines = rows.map(([keys, does]) =>
    element("tr", {}, element("th", { scope: "row" }, ...asKeys(keys)), element("td", {}, does)));
  const body = element("table", {}, element("tbody", {}, ...lines));
  return element("section", { class: rows === POINTER ? "fingers" : "keys" }, element("h3", {}, name), body);
}

/** Two spaces stand between keys that do the same. */
function caps(keys: string): (Node | string)[] {
  return keys.split("  ").flatMap((key, i) => [i ? " " : "", element("kbd", {}, key)]);
}
