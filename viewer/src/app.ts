// What the parts of the page are given to work together.

import type { Player } from "./player";
import type { Recording } from "./recording";
import type { World } from "./world";

/** What `ui/index.ts` gets: `export function mountUi(app: App): Ui`. */
export interface App {
  readonly recording: Recording;
  readonly player: Player;
  readonly world: World;
  /** The element that fills the window; the canvas is its first child, the user interface adds its own. */
  readonly root: HTMLElement;
}

/** What the user interface gives back. */
export interface Ui {
  /** The body that is selected, null for none. */
  selected(): number | null;
  select(body: number | null): void;
}
