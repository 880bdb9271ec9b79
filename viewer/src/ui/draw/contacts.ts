// Contact points and the forces in them: sticking ones as discs, sliding ones as diamonds, forces as arrows.

import { Color, Group, Vector3 } from "three";
import type { Moment } from "../../player";
import type { Recording } from "../../recording";
import type { World } from "../../world";
import type { Selection } from "../selection";
import type { Store } from "../settings";
import { forceScale, type ForceScale } from "./force_scale";
import { DIAMOND, DISC, Marks } from "./marks";
import { Sticks } from "./sticks";

const STICKING = new Color("#d1495b");
const SLIDING = new Color("#edae49");
const CUT = new Color("#7b2cbf");
/** A common force is drawn at least so long [view units; the scene is about ten of them]. */
const SHORTEST = 0.8;

export class ContactDrawing {
  private readonly group = new Group();
  private readonly arrows = new Sticks(true, 0.5);
  private readonly points = new Marks(10);
  private readonly place = new Vector3();
  /** Contact points of the frame that the page does not hold. */
  omitted = 0;
  private scale: ForceScale | null = null;
  private scaledAt = 0;
  private drawn = -1;

  constructor(
    private readonly recording: Recording,
    private readonly world: World,
    private readonly store: Store,
    private readonly selection: Selection,
  ) {
    this.group.add(this.arrows.group, this.points.points);
    world.overlay.add(this.group);
    const again = (): void => {
      this.group.visible = store.now.contacts;
      this.drawn = -1;
      world.redraw();
    };
    store.watch(["contacts", "contactsOf", "arrowSize"], again);
    selection.onChange(again);
    world.onFrame((moment) => this.update(moment));
  }

  /** What the lengths of arrows mean now; made when it is first needed, and anew when a watched run is twice as long. */
  get forceScale(): ForceScale {
    const { frames } = this.recording;
    if (!this.scale || frames > 2 * this.scaledAt) {
      this.scale = forceScale(this.recording, Math.max(1.5 * this.world.bodySize, SHORTEST) * this.world.unit);
      this.scaledAt = frames;
    }
    const { length, force, longest } = this.scale;
    return { length, force: force / this.store.now.arrowSize, longest };
  }

  private update(moment: Moment): void {
    if (!this.group.visible || moment.frame === this.drawn) return;
    this.drawn = moment.frame;
    const contacts = this.recording.frames ? this.recording.contacts(moment.frame) : null;
    const scale = this.forceScale;
    const only = this.store.now.contactsOf === "selected" ? this.selection.body : null;
    this.omitted = contacts?.omitted ?? 0;
    this.arrows.clear();
    this.points.clear();
    for (let i = 0; contacts && i < contacts.count; i++) {
      const a = contacts.bodyA[i];
      const b = contacts.bodyB[i];
      if (only !== null && a !== only && b !== only) continue;
      const sliding = contacts.sliding[i] === 1;
      const p = contacts.position;
      this.world.toView(p[3 * i], p[3 * i + 1], p[3 * i + 2], this.place);
      this.points.add(this.place.x, this.place.y, this.place.z, sliding ? DIAMOND : DISC, sliding ? SLIDING : STICKING);
      // The file has the force on A. What one asks for is the force on the selected body, or on the one that can move.
      const onB = only === null ? this.isFixed(a) && !this.isFixed(b) : b === only;
      this.addArrow(contacts.force, 3 * i, onB ? -1 : 1, sliding, scale);
    }
    this.arrows.commit();
    this.points.commit();
  }

  private addArrow(force: Float64Array, at: number, sign: number, sliding: boolean, scale: ForceScale): void {
    const size = Math.hypot(force[at], force[at + 1], force[at + 2]);
    if (!(size > 0)) return;
    const metres = (size / scale.force) * scale.length;
    const cut = metres > scale.longest;
    const factor = (sign * Math.min(metres, scale.longest)) / this.world.unit / size;
    const { x, y, z } = this.place;
    const colour = cut ? CUT : sliding ? SLIDING : STICKING;
    const wide = (cut ? 0.11 : 0.08) * (scale.length / this.world.unit);
    this.arrows.add(x, y, z, factor * force[at], factor * force[at + 1], factor * force[at + 2], wide, colour);
  }

  private isFixed(body: number): boolean {
    return this.recording.bodies[body]?.fixed ?? true;
  }
}
