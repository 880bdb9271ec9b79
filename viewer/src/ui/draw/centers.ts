// The centre of mass of every body that can move.

import { Color, Vector3 } from "three";
import type { Moment } from "../../player";
import type { Recording } from "../../recording";
import type { World } from "../../world";
import { placed } from "../pose";
import type { Store } from "../settings";
import { Marks, QUARTERS } from "./marks";

const INK = new Color("#000000");

export class CenterDrawing {
  private readonly marks = new Marks(15);
  private readonly place = new Vector3();

  constructor(
    private readonly recording: Recording,
    private readonly world: World,
    store: Store,
  ) {
    world.overlay.add(this.marks.points);
    store.watch(["centers"], () => {
      this.marks.points.visible = store.now.centers;
      world.redraw();
    });
    world.onFrame((moment) => {
      if (this.marks.points.visible) this.update(moment);
    });
  }

  private update(moment: Moment): void {
    this.marks.clear();
    for (const body of this.recording.bodies) {
      if (!Number.isFinite(body.mass)) continue;
      const { x, y, z } = placed(moment, body.index, body.center, this.place);
      this.world.toView(x, y, z, this.place);
      this.marks.add(this.place.x, this.place.y, this.place.z, QUARTERS, INK);
    }
    this.marks.commit();
  }
}
