// The panel of bodies, joints and springs: a list to search, or the one that is selected.

import type { Player } from "../player";
import type { Recording } from "../recording";
import { BodyCard } from "./body_card";
import { element, textButton } from "./dom";
import { LinkCard } from "./link_card";
import { paced } from "./pace";
import type { Selection, Subject } from "./selection";

/** More rows than this are not made: nobody reads them, and each costs layout. */
const MOST_ROWS = 300;

export class Bodies {
  readonly element = element("div", { class: "bodies" });
  private card: BodyCard | LinkCard | null = null;
  private shown: Subject | null = null;
  private readonly field = element("input", {
    type: "search", placeholder: "Search by name or material", "aria-label": "Search for a body, joint or spring",
    autocomplete: "off", spellcheck: "false",
  });
  private readonly rows = element("ul", { class: "list" });
  private readonly list = element("div", { class: "finder" }, this.field, this.rows);
  private readonly print = paced(() => this.card?.print());

  constructor(
    private readonly recording: Recording,
    private readonly player: Player,
    private readonly selection: Selection,
    private readonly plot: (name: string) => void,
  ) {
    this.field.addEventListener("input", () => this.fill());
    this.fill();
    this.showSubject();
    selection.onChange(() => this.showSubject());
  }

  /** The moment changed. */
  update(): void {
    if (this.card && this.element.isConnected) this.print();
  }

  /** What to look at, or the search when nothing is selected. */
  focus(): void {
    this.element.querySelector<HTMLElement>("input, button")?.focus();
  }

  private showSubject(): void {
    const { subject } = this.selection;
    if (subject !== this.shown || !this.element.firstChild) {
      this.shown = subject;
      this.card = subject && this.cardOf(subject);
      const back = textButton(() => this.selection.select(null), "‹ All bodies");
      back.className = "back";
      const hadFocus = this.element.contains(document.activeElement);
      this.element.replaceChildren(...(this.card ? [back, this.card.element] : [this.list]));
      // Not the search: on a phone that would open the keyboard.
      if (hadFocus) this.element.querySelector<HTMLElement>("button")?.focus();
    }
    if (this.card instanceof BodyCard) this.card.showFollowed();
    this.update();
  }

  private cardOf(subject: Subject): BodyCard | LinkCard {
    const { recording, player, selection, plot } = this;
    if (subject.what === "body") return new BodyCard(recording, player, subject.body, selection, plot);
    return new LinkCard(recording, player, subject.link, subject.what, selection, plot);
  }

  private fill(): void {
    const found = [...this.subjects()];
    const rows = found.slice(0, MOST_ROWS).map((subject) => element("li", {}, this.row(subject)));
    const more = found.length - MOST_ROWS;
    if (more > 0) rows.push(element("li", { class: "more" }, `${more} more: type more of the name.`));
    if (!found.length) rows.push(element("li", { class: "more" }, "Nothing of that name."));
    this.rows.replaceChildren(...rows);
  }

  private *subjects(): Generator<Subject> {
    const words = this.field.value.toLowerCase().split(/\s+/).filter(Boolean);
    const fits = (text: string): boolean => words.every((word) => text.toLowerCase().includes(word));
    const { bodies, joints, springs } = this.recording;
    for (const body of bodies) if (fits(`${body.name} ${body.material}`)) yield { what: "body", body };
    for (const link of joints) if (fits(`${link.name} ${link.kind} joint`)) yield { what: "joint", link };
    for (const link of springs) if (fits(`${link.name} ${link.kind} spring`)) yield { what: "spring", link };
  }

  private row(subject: Subject): HTMLButtonElement {
    const name = subject.what === "body" ? subject.body.name : subject.link.name;
    const more = subject.what === "body" ? [subject.body.material, subject.body.fixed ? "fixed" : ""].filter(Boolean).join(", ")
      : `${subject.link.kind} ${subject.what}`;
    const swatch = element("span", { class: `swatch ${subject.what}` });
    if (subject.what === "body") swatch.style.setProperty("--swatch", subject.body.colour);
    const select = (): void => this.selection.select(subject);
    return textButton(select, swatch, element("span", {}, name), element("span", { class: "unit" }, more));
  }
}
