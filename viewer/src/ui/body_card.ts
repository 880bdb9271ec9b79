// The selected body: who it is, what it does at this moment, whom it touches, what it is tied to.

import type { Player } from "../player";
import type { Body, Contacts, Link, Recording } from "../recording";
import { button, element, icon, setText, textButton } from "./dom";
import { count, exact, quantity } from "./format";
import { FOLLOW } from "./icons";
import { emptyNumbers, readBody, turnInWords, type BodyNumbers } from "./numbers";
import { Reading } from "./reading";
import type { Selection } from "./selection";

const XYZ = ["x", "y", "z"];
const MOST_PARTNERS = 12;

export class BodyCard {
  readonly element: HTMLElement;
  private readonly numbers = emptyNumbers();
  private readonly position: Reading;
  private readonly orientation: Reading;
  private readonly velocity: Reading;
  private readonly spin: Reading;
  private readonly speed: Reading;
  private readonly energy: Reading;
  private readonly turn = element("p", { class: "note" });
  private readonly contacts = element("table", { class: "partners" });
  private readonly when = element("p", { class: "note" });
  private readonly follow: HTMLButtonElement;

  constructor(
    private readonly recording: Recording,
    private readonly player: Player,
    private readonly body: Body,
    private readonly selection: Selection,
    plot: (name: string) => void,
  ) {
    const make = (title: string, field: string, unit: string, parts: readonly string[]): Reading =>
      new Reading(title, unit, parts, () => plot(`bodies.${body.name}.${field}`));
    this.position = make("position", "position", "m", XYZ);
    this.orientation = make("orientation", "orientation", "", ["w", ...XYZ]);
    this.velocity = make("velocity", "velocity", "m s-1", XYZ);
    this.spin = make("angular velocity", "angular_velocity", "rad s-1", XYZ);
    this.speed = make("speed", "speed", "m s-1", []);
    this.energy = make("kinetic energy", "kinetic_energy", "J", []);
    this.follow = button("Follow with the camera", "", "F", () => selection.toggleFollow());
    this.follow.className = "wide";
    this.follow.replaceChildren(icon(...FOLLOW), "Follow");
    this.element = element("section", { class: "card" }, ...this.parts());
    this.showFollowed();
    this.print();
  }

  private parts(): Node[] {
    const { body } = this;
    return [
      element("h3", { class: "name" }, body.name),
      element("p", { class: "facts" }, facts(body)),
      this.follow, this.when,
      this.position.element, this.orientation.element, this.turn, this.velocity.element, this.spin.element,
      element("div", { class: "pair" }, this.speed.element, this.energy.element),
      element("h4", {}, "contacts"), this.contacts, ...this.links(),
    ];
  }

  showFollowed(): void {
    this.follow.setAttribute("aria-pressed", String(this.selection.followed === this.body.index));
  }

  /** The numbers of the moment that is shown. */
  print(): void {
    const { recording, player, body, numbers } = this;
    const { moment, playing } = player;
    if (!recording.frames) return;
    readBody(recording, moment, body, numbers);
    const of = (track: Recording["position"]) => (i: number) => track.error(body.index, i);
    this.position.print(numbers.position, playing, of(recording.position));
    this.orientation.print(numbers.orientation, playing, of(recording.orientation));
    this.velocity.print(numbers.velocity, playing, of(recording.velocity));
    this.spin.print(numbers.angularVelocity, playing, of(recording.angularVelocity));
    const speedError = Math.hypot(...[0, 1, 2].map((i) => recording.velocity.error(body.index, i)));
    this.speed.print([numbers.speed], playing, () => speedError);
    this.energy.print([numbers.kineticEnergy], playing, () => energyError(recording, body, numbers, speedError));
    setText(this.turn, turnInWords(numbers.orientation));
    setText(this.when, moment.fraction ? `between frames ${moment.frame + 1} and ${moment.frame + 2}: interpolated`
      : `at frame ${moment.frame + 1}`);
    this.when.hidden = playing;
    this.printContacts(recording.contacts(moment.frame));
  }

  private printContacts(contacts: Contacts | null): void {
    if (!contacts) return this.contacts.replaceChildren(row("not recorded"));
    const partners = partnersOf(contacts, this.body.index);
    const rows = partners.slice(0, MOST_PARTNERS).map(([other, sum]) =>
      row(this.recording.bodies[other]?.name ?? "world", count(sum.points, "point"), quantity(Math.hypot(...sum.force), "N", 4)));
    const more = partners.length - MOST_PARTNERS;
    if (more > 0) rows.push(row(`and ${count(more, "body more", "bodies more")}`));
    if (!partners.length) rows.push(row("touches nothing"));
    if (contacts.omitted) rows.push(row(`${count(contacts.omitted, "weak point")} left out of this frame`));
    this.contacts.replaceChildren(...rows);
  }

  private links(): Node[] {
    const { recording, body } = this;
    const made: Node[] = [];
    for (const what of ["joint", "spring"] as const) {
      const links = (what === "joint" ? recording.joints : recording.springs).filter((link) => link.bodies.includes(body.index));
      if (!links.length) continue;
      made.push(element("h4", {}, `${what}s`), element("ul", { class: "list" }, ...links.map((link) =>
        element("li", {}, this.linkButton(what, link)))));
    }
    return made;
  }

  private linkButton(what: "joint" | "spring", link: Link): HTMLButtonElement {
    const other = link.bodies[0] === this.body.index ? link.bodies[1] : link.bodies[0];
    const partner = this.recording.bodies[other]?.name ?? "world";
    const note = element("span", { class: "unit" }, `${link.kind}, to ${partner}`);
    return textButton(() => this.selection.select({ what, link }), element("span", {}, link.name), note);
  }
}

function facts(body: Body): string {
  const mass = Number.isFinite(body.mass) ? `${exact(body.mass)}\u202fkg` : "a half-space: no mass";
  return [body.material || "no material", mass, body.fixed ? "fixed" : ""].filter(Boolean).join(" · ");
}

/** First order: d(m v^2 / 2 + w I w / 2) = m v dv + I w dw. */
function energyError(recording: Recording, body: Body, numbers: BodyNumbers, speedError: number): number {
  if (body.fixed || !Number.isFinite(body.mass)) return 0;
  const spinError = Math.max(...[0, 1, 2].map((i) => recording.angularVelocity.error(body.index, i)));
  const inertia = Math.max(...body.inertia.map(Math.abs));
  return body.mass * numbers.speed * speedError + 3 * inertia * Math.hypot(...numbers.angularVelocity) * spinError;
}

interface Sum {
  points: number;
  force: [number, number, number];
}

/** Whom a body touches, with the sum of the forces on it; the strongest first. */
export function partnersOf(contacts: Contacts, body: number): [number, Sum][] {
  const sums = new Map<number, Sum>();
  for (let i = 0; i < contacts.count; i++) {
    const isA = contacts.bodyA[i] === body;
    if (!isA && contacts.bodyB[i] !== body) continue;
    const other = isA ? contacts.bodyB[i] : contacts.bodyA[i];
    const sum = sums.get(other) ?? { points: 0, force: [0, 0, 0] };
    sum.points += 1;
    for (let k = 0; k < 3; k++) sum.force[k] += (isA ? 1 : -1) * contacts.force[3 * i + k];
    sums.set(other, sum);
  }
  return [...sums].sort((a, b) => Math.hypot(...b[1].force) - Math.hypot(...a[1].force));
}

function row(...texts: string[]): HTMLTableRowElement {
  return element("tr", {}, ...texts.map((text, i) => element("td", i ? {} : { colspan: texts.length === 1 ? 3 : 1 }, text)));
}
