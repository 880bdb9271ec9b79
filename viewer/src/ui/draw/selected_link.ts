// The joint or spring that is selected: its ends are marked, whatever lies before them.

import { Color, Group, Vector3 } from "three";
import type { Moment } from "../../player";
import type { Recording } from "../../recording";
import type { World } from "../../world";
import { anchor } from "../pose";
import type { Selection } from "../selection";
import { DIAMOND, Marks } from "./marks";
import { Sticks } from "./sticks";

const TINT = new Color("#e8590c");

export class SelectedLinkDrawing {
  private readonly group = new Group();
  private readonly marks = new Marks(16);
  private readonly line = new Sticks(false, 0.6);
  private readonly ends = [new Vector3(), new Vector3()] as const;

  constructor(
    recording: Recording,
    private readonly world: World,
    private readonly selection: Selection,
  ) {
    this.group.add(this.marks.points, this.line.group);
    this.group.visible = false;
    world.overlay.add(this.group);
    selection.onChange(() => {
      const { subject } = selection;
      this.group.visible = subject !== null && subject.what !== "body";
    });
    world.onFrame((moment) => {
      if (this.group.visible && recording.frames > 0) this.update(moment);
    });
  }

  private update(moment: Moment): void {
    const { subject } = this.selection;
    if (!subject || subject.what === "body") return;
    this.marks.clear();
    this.line.clear();
    const [a, b] = this.ends;
    for (const end of [0, 1] as const) {
      const { x, y, z } = anchor(moment, subject.link, end, this.ends[end]);
      this.world.toView(x, y, z, this.ends[end]);
      this.marks.add(this.ends[end].x, this.ends[end].y, this.ends[end].z, DIAMOND, TINT);
    }
    this.line.add(a.x, a.y, a.z, b.x - a.x, b.y - a.y, b.z - a.z, 0.02 * this.world.bodySize, TINT);
    this.marks.commit();
    this.line.commit();
  }
}
