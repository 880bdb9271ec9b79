// What the page holds and what it does not: the file, how the run ended, the precision of the numbers.

import type { About, Recording } from "../recording";
import type { World } from "../world";
import { element, setText } from "./dom";
import { count, exact } from "./format";
import { paced } from "./pace";

const STATUS: Record<About["status"], { mark: string; text: string }> = {
  complete: { mark: "✓", text: "complete" },
  running: { mark: "…", text: "still running" },
  failed: { mark: "✕", text: "failed" },
  interrupted: { mark: "‖", text: "interrupted" },
};

/** Says how the run ended, with a sign and a word; nothing when it is complete, or still watched. */
export class Badge {
  readonly element = element("span", { class: "badge", role: "status" });

  constructor(private readonly recording: Recording) {
    this.update();
  }

  update(): void {
    const { status, detail } = this.recording.about;
    const { mark, text } = STATUS[status];
    this.element.hidden = status === "complete" || this.recording.growing;
    this.element.dataset.status = status;
    this.element.title = detail;
    setText(this.element, `${mark} ${text}`);
  }
}

export class AboutPanel {
  readonly element = element("div", { class: "about", tabindex: 0 });

  private readonly drawing = element("dd", {});

  constructor(
    private readonly recording: Recording,
    private readonly world: World,
  ) {
    this.update();
    const say = paced(() => setText(this.drawing, this.howDrawn()), 500);
    world.onFrame(() => this.element.isConnected && say());
  }

  /** Takes what is said of the file anew. */
  update(): void {
    const { about } = this.recording;
    this.element.replaceChildren(
      element("dl", {}, ...this.facts().flatMap(([name, value]) => [element("dt", {}, name), element("dd", {}, value)]),
        element("dt", {}, "Drawn"), this.drawing),
      element("h3", {}, "Precision and what was left out"),
      element("ul", { class: "notes" }, ...about.notes.map((note) => element("li", {}, note))),
      element("p", { class: "note" }, "Between two frames positions and turns are interpolated. Everything is in SI units; ",
        "the page loads nothing from the network."),
    );
  }

  private howDrawn(): string {
    const fps = this.world.fps();
    return this.world.quality() + (fps > 0 ? `, ${Math.round(fps)} pictures/s` : "");
  }

  private facts(): [string, string][] {
    const { about, bodies, joints, springs, frames, times } = this.recording;
    const { text } = STATUS[about.status];
    const left = about.framesInFile === frames ? "" : ` of ${about.framesInFile} in the file`;
    const facts: [string, string][] = [
      ["Title", about.title || "none"],
      ["File", about.file],
      ["Run", about.detail ? `${text}: ${about.detail}` : text],
      ["physsim", about.physsimVersion],
      ["Frames", count(frames, "frame") + left],
    ];
    if (frames) facts.push(["Time", `${exact(times[0])} to ${exact(times[frames - 1])}\u202fs`]);
    const who = [count(bodies.length, "body", "bodies"), count(joints.length, "joint"), count(springs.length, "spring")];
    facts.push(["Scene", who.filter((one) => !one.startsWith("0 ")).join(", ")]);
    return facts;
  }
}
