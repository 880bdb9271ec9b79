// What the address says after `#`: `t=1.5` shows that time [s], `body=NAME` selects a body.

import type { App, Ui } from "./app";

/** Shows what the address asks for, now and whenever it changes. Names of nobody are passed over. */
export function followAddress(app: App, ui: Ui): void {
  const go = (): void => {
    const wishes = new URLSearchParams(window.location.hash.slice(1));
    const time = wishes.get("t");
    if (time !== null && time !== "") app.player.seek(Number(time));
    const name = wishes.get("body");
    const body = app.recording.bodies.find((one) => one.name === name);
    if (body) ui.select(body.index);
  };
  window.addEventListener("hashchange", go);
  go();
}
