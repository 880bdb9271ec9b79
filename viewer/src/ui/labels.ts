// Names beside the bodies, as text of the page: at most a few dozen, the nearest.

import { Vector3 } from "three";
import type { Moment } from "../player";
import type { Recording } from "../recording";
import type { World } from "../world";
import { element, setText } from "./dom";
import { paced } from "./pace";
import { placed } from "./pose";
import type { Store } from "./settings";

const MOST = 40;

export class Labels {
  private readonly box = element("div", { class: "labels", "aria-hidden": "true" });
  private readonly tags: HTMLElement[] = [];
  private chosen: number[] = [];
  private readonly point = new Vector3();
  private readonly choose = paced(() => this.chooseNearest(), 250);

  constructor(
    root: HTMLElement,
    private readonly recording: Recording,
    private readonly world: World,
    store: Store,
  ) {
    root.append(this.box);
    store.watch(["labels"], () => {
      this.box.hidden = !store.now.labels;
      world.redraw();
    });
    world.onFrame((moment) => {
      if (this.box.hidden) return;
      this.moment = moment;
      this.choose();
      this.place(moment);
    });
  }

  private moment: Moment | null = null;

  private chooseNearest(): void {
    const { moment } = this;
    if (!moment) return;
    const far = this.recording.bodies
      .filter((body) => Number.isFinite(body.mass))
      .map((body) => ({ body: body.index, z: this.project(moment, body.index).z }))
      .filter(({ z }) => z < 1);
    this.chosen = far.sort((a, b) => a.z - b.z).slice(0, MOST).map(({ body }) => body);
    while (this.tags.length < this.chosen.length) {
      const tag = element("span");
      this.tags.push(tag);
      this.box.append(tag);
    }
    this.tags.forEach((tag, i) => {
      tag.hidden = i >= this.chosen.length;
      if (!tag.hidden) setText(tag, this.recording.bodies[this.chosen[i]].name);
    });
    this.place(moment);
  }

  private place(moment: Moment): void {
    const { canvas } = this.world;
    const width = canvas.clientWidth;
    const height = canvas.clientHeight;
    for (let i = 0; i < this.chosen.length; i++) {
      const { x, y } = this.project(moment, this.chosen[i]);
      this.tags[i].style.transform = `translate(${((0.5 + x / 2) * width).toFixed(1)}px, ${((0.5 - y / 2) * height).toFixed(1)}px)`;
    }
  }

  /** On the screen: -1 to 1 to the right and up, depth below 1 in front of the camera. */
  private project(moment: Moment, body: number): Vector3 {
    const { x, y, z } = placed(moment, body, this.recording.bodies[body].center, this.point);
    return this.world.toView(x, y, z, this.point).project(this.world.camera);
  }
}
