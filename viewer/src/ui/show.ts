// The panel that says what the picture shows: switches, colours, trails, view.

import type { App } from "../app";
import type { Recording } from "../recording";
import { element, textButton } from "./dom";
import type { Settings, Store, Switch } from "./settings";
import { lookFrom, VIEWPOINTS } from "./viewpoints";

interface SwitchRow {
  key: Switch;
  name: string;
  shortcut: string;
  /** Why it cannot be switched, or "". */
  missing: (recording: Recording) => string;
}

const always = (): string => "";

export const SWITCHES: readonly SwitchRow[] = [
  { key: "contacts", name: "Contact points and forces", shortcut: "C",
    missing: (recording) => {
      if (recording.growing || !recording.frames) return "";
      return !recording.contacts(0) ? "not recorded" : recording.strongestContact > 0 ? "" : "none in this run";
    } },
  { key: "joints", name: "Joints", shortcut: "J",
    missing: (recording) => (recording.joints.length ? "" : "none in this scene") },
  { key: "springs", name: "Springs", shortcut: "S",
    missing: (recording) => (recording.springs.length ? "" : "none in this scene") },
  { key: "labels", name: "Names of bodies", shortcut: "N", missing: always },
  { key: "centers", name: "Centres of mass", shortcut: "M", missing: always },
  { key: "frames", name: "Axes of bodies", shortcut: "B", missing: always },
  { key: "axes", name: "Axes of the world", shortcut: "A", missing: always },
  { key: "grid", name: "Grid", shortcut: "G", missing: always },
  { key: "wireframe", name: "Collision shapes as wireframe", shortcut: "W", missing: always },
  { key: "shadows", name: "Shadows", shortcut: "", missing: always },
];

type Options<K extends keyof Settings> = readonly (readonly [Settings[K], string])[];

const COLOURINGS: Options<"colouring"> = [["material", "Material"], ["speed", "Speed"], ["body", "Body"]];
const TRAILS: Options<"trails"> = [["none", "None"], ["selected", "Selected"], ["all", "All"]];
const THEMES: Options<"theme"> = [["auto", "System"], ["light", "Light"], ["dark", "Dark"]];
const CONTACTS_OF: Options<"contactsOf"> = [["all", "All bodies"], ["selected", "Selected body"]];
const SIZES: Options<"arrowSize"> = [[0.25, "¼×"], [0.5, "½×"], [1, "1×"], [2, "2×"], [4, "4×"]];
const LENGTHS: Options<"trailLength"> = [[0.1, "0.1\u202fs"], [1, "1\u202fs"], [10, "10\u202fs"], [Infinity, "Whole"]];

/** The panel. */
export function showPanel({ recording, world }: App, store: Store): HTMLElement {
  return element(
    "div", { class: "show" },
    element("div", { class: "switches" }, ...SWITCHES.map((row) => switchOf(recording, store, row))),
    element("h3", {}, "Look from"),
    element("div", { class: "viewpoints" }, ...VIEWPOINTS.map((one) =>
      textButton(() => lookFrom(world, one), one.name))),
    choice(store, "colouring", "Colours by (V)", COLOURINGS),
    choice(store, "trails", "Trails (T)", TRAILS),
    choice(store, "trailLength", "Length of trails", LENGTHS),
    choice(store, "contactsOf", "Contacts of", CONTACTS_OF),
    choice(store, "arrowSize", "Size of force arrows", SIZES),
    choice(store, "theme", "Light or dark (D)", THEMES),
  );
}

function switchOf(recording: Recording, store: Store, { key, name, shortcut, missing }: SwitchRow): HTMLElement {
  const why = missing(recording);
  const box = element("input", { type: "checkbox", role: "switch", disabled: why !== "" });
  box.addEventListener("change", () => store.set(key, box.checked));
  store.watch([key], () => (box.checked = store.now[key] && !why));
  const hint = why ? element("span", { class: "unit" }, why) : shortcut ? element("kbd", {}, shortcut) : "";
  return element("label", {}, box, element("span", {}, name), hint);
}

/** One of a few, as radio buttons in a row. */
function choice<K extends keyof Settings>(store: Store, key: K, name: string, options: Options<K>): HTMLElement {
  const set = element("fieldset", { class: "choice" }, element("legend", {}, name));
  const boxes = options.map(([value, text]) => {
    const box = element("input", { type: "radio", name: key, value: String(value) });
    box.addEventListener("change", () => store.set(key, value));
    set.append(element("label", {}, box, element("span", {}, text)));
    return box;
  });
  store.watch([key], () => boxes.forEach((box, i) => (box.checked = options[i][0] === store.now[key])));
  return set;
}
