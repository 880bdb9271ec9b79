// The panels at the sides of the view, one on each side at most; on narrow screens one in all, at the bottom.

import { button, element, icon } from "./dom";
import { CLOSE } from "./icons";

export type Side = "left" | "right";

export interface Panel {
  readonly name: string;
  readonly key: string;
  readonly side: Side;
  readonly icon: readonly string[];
  readonly content: HTMLElement;
}

/** So narrow that two panels would leave no view. */
const ONE_PANEL = matchMedia("(max-width: 1099px)");

export class Panels {
  readonly buttons = element("div", { class: "panel-buttons", role: "toolbar", "aria-label": "Panels" });
  readonly sides: Record<Side, HTMLElement> = {
    left: element("aside", { class: "panel left", hidden: true }), right: element("aside", { class: "panel right", hidden: true }),
  };
  private readonly open: Record<Side, Panel | null> = { left: null, right: null };
  private readonly switches = new Map<string, HTMLButtonElement>();

  constructor(
    private readonly panels: readonly Panel[],
    private readonly changed: () => void,
  ) {
    for (const panel of panels) {
      const made = button(panel.name, icon(...panel.icon), panel.key, () => this.toggle(panel.name));
      made.append(element("span", {}, panel.name));
      made.setAttribute("aria-expanded", "false");
      this.switches.set(panel.name, made);
      this.buttons.append(made);
    }
    ONE_PANEL.addEventListener("change", () => ONE_PANEL.matches && this.open.left && this.close("right"));
  }

  isOpen(name: string): boolean {
    const panel = this.find(name);
    return this.open[panel.side] === panel;
  }

  toggle(name: string): void {
    const panel = this.find(name);
    if (this.isOpen(name)) this.close(panel.side);
    else this.show(name);
  }

  show(name: string): void {
    const panel = this.find(name);
    if (ONE_PANEL.matches) this.close(panel.side === "left" ? "right" : "left");
    if (this.open[panel.side] === panel) return;
    this.open[panel.side] = panel;
    const side = this.sides[panel.side];
    side.setAttribute("aria-label", panel.name);
    const close = button(`Close ${panel.name}`, icon(...CLOSE), "", () => this.close(panel.side));
    side.replaceChildren(element("header", {}, element("h2", {}, panel.name), close), panel.content);
    side.hidden = false;
    this.tell();
  }

  close(side: Side): void {
    if (this.sides[side].contains(document.activeElement)) this.switches.get(this.open[side]?.name ?? "")?.focus();
    this.open[side] = null;
    this.sides[side].hidden = true;
    this.sides[side].replaceChildren();
    this.tell();
  }

  /** Closes what is open; whether anything was. */
  closeAll(): boolean {
    const any = this.open.left !== null || this.open.right !== null;
    this.close("left");
    this.close("right");
    return any;
  }

  private find(name: string): Panel {
    const panel = this.panels.find((one) => one.name === name);
    if (!panel) throw new Error(`no panel ${name}`);
    return panel;
  }

  private tell(): void {
    for (const panel of this.panels) {
      this.switches.get(panel.name)?.setAttribute("aria-expanded", String(this.open[panel.side] === panel));
    }
    this.changed();
  }
}
