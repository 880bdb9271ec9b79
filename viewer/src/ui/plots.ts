// The plots beside the view: a search for quantities, and the chosen ones below each other.

import type { Player } from "../player";
import type { Recording } from "../recording";
import { energyEntries, entryOf, search, type Entry } from "./catalogue";
import { element, textButton } from "./dom";
import { unitInPrint } from "./format";
import { paced } from "./pace";
import { PlotCard } from "./plot_card";

const MOST_FOUND = 40;
const MOST_PLOTS = 12;

export class Plots {
  readonly element = element("div", { class: "plots" });
  private readonly cards: PlotCard[] = [];
  private readonly list = element("div", { class: "plot-list" });
  private readonly field = element("input", {
    type: "search", placeholder: "Add a plot: ball position z", "aria-label": "Search for a quantity to plot",
    autocomplete: "off", spellcheck: "false",
  });
  private readonly results = element("ul", { class: "results", "aria-label": "Quantities found", hidden: true });
  private readonly move = paced(() => this.cards.forEach((card) => card.setTime(this.player.moment.time)), 40);
  private readonly print = paced(() => this.cards.forEach((card) => card.printValues(this.player.moment.time)));

  constructor(
    private readonly recording: Recording,
    private readonly player: Player,
  ) {
    this.element.append(element("div", { class: "finder" }, this.field, this.results), this.list);
    this.listen();
    const first = energyEntries(recording)[0];
    if (first) this.add(first);
    this.sayWhenEmpty();
  }

  get isEmpty(): boolean {
    return !this.cards.length;
  }

  /** Plots a quantity by its name as in `expect`, with all components of a vector. */
  addNamed(name: string): void {
    const entry = entryOf(this.recording, name);
    if (entry) this.add(entry);
  }

  /** The moment changed. */
  update(): void {
    if (!this.element.isConnected) return;
    this.move();
    this.print();
  }

  /** The colours changed. */
  redraw(): void {
    for (const card of this.cards) card.redraw();
  }

  focus(): void {
    this.field.focus();
  }

  private add(entry: Entry): void {
    const old = this.cards.find((card) => card.entry.title === entry.title);
    if (old) return old.element.scrollIntoView({ block: "nearest" });
    if (this.cards.length === MOST_PLOTS) this.remove(this.cards[MOST_PLOTS - 1]);
    const card: PlotCard = new PlotCard(
      this.recording, entry, (time) => this.player.seek(time), () => this.remove(card),
    );
    this.cards.unshift(card);
    this.list.prepend(card.element);
    this.sayWhenEmpty();
    card.setTime(this.player.moment.time);
    card.printValues(this.player.moment.time);
    return undefined;
  }

  private remove(card: PlotCard): void {
    this.cards.splice(this.cards.indexOf(card), 1);
    card.element.remove();
    this.sayWhenEmpty();
  }

  private sayWhenEmpty(): void {
    this.list.querySelector(".empty")?.remove();
    if (this.isEmpty) this.list.append(element("p", { class: "empty" }, "No plot yet. Search above for what to plot."));
  }

  private listen(): void {
    this.field.addEventListener("input", () => this.find());
    this.field.addEventListener("focus", () => this.find());
    this.element.addEventListener("focusout", (event) => {
      if (!(event.relatedTarget instanceof Node) || !this.results.parentElement?.contains(event.relatedTarget)) {
        this.results.hidden = true;
      }
    });
    this.element.addEventListener("keydown", (event) => this.onKey(event));
    this.recording.onGrowth(paced(() => this.cards.forEach((card) => card.read()), 500));
  }

  private find(): void {
    const { found, more } = search(this.recording, this.field.value, MOST_FOUND);
    const rows = found.map((entry) => element("li", {}, this.result(entry)));
    if (more) rows.push(element("li", { class: "more" }, "More fit: type more of the name."));
    if (!found.length) rows.push(element("li", { class: "more" }, "Nothing of that name was recorded."));
    this.results.replaceChildren(...rows);
    this.results.hidden = false;
  }

  private result(entry: Entry): HTMLButtonElement {
    const take = (): void => {
      this.results.hidden = true;
      this.field.value = "";
      this.add(entry);
    };
    const made = textButton(take, element("span", {}, entry.title), element("span", { class: "unit" }, unitInPrint(entry.unit)));
    made.tabIndex = -1;
    // Else the field loses the focus before the click, and the list is gone.
    made.addEventListener("mousedown", (event) => event.preventDefault());
    return made;
  }

  /** Up and down walk through what was found, Enter takes the first, Escape closes. */
  private onKey(event: KeyboardEvent): void {
    if (this.results.hidden) return;
    const all = [...this.results.querySelectorAll("button")];
    const at = all.indexOf(document.activeElement as HTMLButtonElement);
    if (event.key === "Escape") this.results.hidden = true;
    else if (event.key === "Enter" && at < 0) all[0]?.click();
    else if (event.key === "ArrowDown") (all[at + 1] ?? all[at])?.focus();
    else if (event.key === "ArrowUp") (at > 0 ? all[at - 1] : this.field).focus();
    else return;
    event.stopPropagation();
    if (event.key !== "Enter" || at < 0) event.preventDefault();
  }
}
