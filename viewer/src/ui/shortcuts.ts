// What the keys do.

import type { App } from "../app";
import { nextSpeed } from "./bar";
import type { Shortcut } from "./keys";
import type { Panels } from "./panels";
import type { Selection } from "./selection";
import type { Colouring, Key, Settings, Store, ThemeChoice, Trails } from "./settings";
import { SWITCHES } from "./show";

/** Speeds of the keys 1 to 9. */
const SPEED_KEYS = [0.01, 0.05, 0.1, 0.5, 1, 2, 5, 20, 100];
const COLOURINGS: readonly Colouring[] = ["material", "speed", "body"];
const TRAILS: readonly Trails[] = ["none", "selected", "all"];
const THEMES: readonly ThemeChoice[] = ["auto", "light", "dark"];

/** What the keys act on. */
export interface Hands {
  app: App;
  store: Store;
  selection: Selection;
  panels: Panels;
  openHelp: () => void;
  findPlot: () => void;
  findBody: () => void;
}

export function shortcuts(parts: Hands): Shortcut[] {
  return [...playing(parts), ...seeing(parts), ...switches(parts), ...panelKeys(parts)];
}

function playing({ app: { player } }: Hands): Shortcut[] {
  return [
    { keys: [" ", "k"], print: "Space", group: "Play", does: "play, pause", act: () => player.toggle() },
    { keys: ["ArrowRight", "."], print: "→  .", group: "Play", does: "one frame forward", act: () => player.step(1) },
    { keys: ["ArrowLeft", ","], print: "←  ,", group: "Play", does: "one frame back", act: () => player.step(-1) },
    { keys: ["ArrowUp", "PageUp"], print: "↑", group: "Play", does: "ten frames forward", act: () => player.step(10) },
    { keys: ["ArrowDown", "PageDown"], print: "↓", group: "Play", does: "ten frames back", act: () => player.step(-10) },
    { keys: ["Home"], print: "Home", group: "Play", does: "to the start", act: () => player.seek(player.start) },
    { keys: ["End"], print: "End", group: "Play", does: "to the end", act: () => player.seek(player.end) },
    { keys: ["]"], print: "]", group: "Play", does: "faster", act: () => player.setSpeed(nextSpeed(player.speed, 1)) },
    { keys: ["["], print: "[", group: "Play", does: "slower", act: () => player.setSpeed(nextSpeed(player.speed, -1)) },
    { keys: SPEED_KEYS.map((_, i) => String(i + 1)), print: "1 to 9", group: "Play", does: "speed 0.01× to 100×; 5: real time",
      act: (key) => player.setSpeed(SPEED_KEYS[Number(key) - 1]) },
    { keys: ["l"], print: "L", group: "Play", does: "play in a loop", act: () => player.setLoop(!player.loop) },
  ];
}

function seeing({ app: { world }, store, selection }: Hands): Shortcut[] {
  return [
    { keys: ["f"], print: "F", group: "View", does: "follow the selected body, let go", act: () => selection.toggleFollow() },
    { keys: ["r"], print: "R", group: "View", does: "show all that moves", act: () => world.frameAll() },
    { keys: ["t"], print: "T", group: "View", does: "trails: none, selected body, all", act: () => next(store, "trails", TRAILS) },
    { keys: ["v"], print: "V", group: "View", does: "colours by material, speed, body",
      act: () => next(store, "colouring", COLOURINGS) },
    { keys: ["d"], print: "D", group: "View", does: "as the system, light, dark", act: () => next(store, "theme", THEMES) },
  ];
}

function switches({ app: { recording }, store }: Hands): Shortcut[] {
  return SWITCHES.filter((one) => one.shortcut).map(({ key, name, shortcut, missing }) => ({
    keys: [shortcut.toLowerCase()], print: shortcut, group: "Show", does: name.toLowerCase(),
    act: () => !missing(recording) && store.flip(key),
  }));
}

function panelKeys({ panels, selection, openHelp, findPlot, findBody }: Hands): Shortcut[] {
  return [
    { keys: ["/"], print: "/", group: "Panels", does: "search for a body", act: findBody },
    { keys: ["p"], print: "P", group: "Panels", does: "plots", act: () => panels.toggle("Plots") },
    { keys: ["+"], print: "+", group: "Panels", does: "search for a quantity to plot", act: findPlot },
    { keys: ["i"], print: "I", group: "Panels", does: "about this page", act: () => panels.toggle("About") },
    { keys: ["Escape"], print: "Esc", group: "Panels", does: "deselect; close panels",
      act: () => (selection.subject ? selection.select(null) : panels.closeAll()) },
    { keys: ["?", "h"], print: "?  H", group: "Panels", does: "this help", act: openHelp },
  ];
}

function next<K extends Key>(store: Store, key: K, all: readonly Settings[K][]): void {
  store.set(key, all[(all.indexOf(store.now[key]) + 1) % all.length]);
}
