// Contact points and the forces in them: sticking ones as discs, sliding ones as diamonds, forces as arrows.

import { Color, Group, Vector3 } from "three";
import type { Moment } from "../../player";
import type { Recording } from "../../recording";
import type { World } from "../../world";
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
  private scale: ForceScale | null = null;
  private drawn = -1;

  constructor(
    private readonly recording: Recording,
    private readonly world: World,
    private readonly store: Store,
  ) {
    this.group.add(this.arrows.group, this.points.points);
    world.overlay.add(this.group);
    store.watch(["contacts", "arrowSize"], () => {
      this.group.visible = store.now.contacts;
      this.drawn = -1;
      world.redraw();
    });
    world.onFrame((moment) => this.update(moment));
  }

  /** What the lengths of arrows mean now; made when it is first needed. */
  get forceScale(): ForceScale {
    this.scale ??= forceScale(this.recording, Math.max(1.5 * this.world.bodySize, SHORTEST) * this.world.unit);
    const { length, force, longest } = this.scale;
    return { length, force: force / this.store.now.arrowSize, longest };
  }

  private update(moment: Moment): void {
    if (!this.group.visible || moment.frame === this.drawn) return;
    this.drawn = moment.frame;
    const contacts = this.recording.frames ? this.recording.contacts(moment.frame) : null;
    const scale = this.forceScale;
    this.arrows.clear();
    this.points.clear();
    for (let i = 0; contacts && i < contacts.count; i++) {
      const sliding = contacts.sliding[i] === 1;
      const p = contacts.position;
      this.world.toView(p[3 * i], p[3 * i + 1], p[3 * i + 2], this.place);
      this.points.add(this.place.x, this.place.y, this.place.z, sliding ? DIAMOND : DISC, sliding ? SLIDING : STICKING);
      // The force on A; where A stands still anyway, what is pushed is B.
      const sign = this.isFixed(contacts.bodyA[i]) && !this.isFixed(contacts.bodyB[i]) ? -1 : 1;
      this.addArrow(contacts.force, 3 * i, sign, sliding, scale);
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
