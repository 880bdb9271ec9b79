// Light and dark: as the system says, or as chosen here.

import type { World } from "../world";
import type { Store } from "./settings";

/** Keeps the page and the view in the theme that is wanted; `changed` is called after every change. */
export function keepTheme(world: World, store: Store, changed: () => void): void {
  const system = matchMedia("(prefers-color-scheme: dark)");
  const apply = (): void => {
    const { theme } = store.now;
    const dark = theme === "dark" || (theme === "auto" && system.matches);
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    world.setTheme(dark ? "dark" : "light");
    changed();
    world.redraw();
  };
  system.addEventListener("change", apply);
  store.watch(["theme"], apply);
}
