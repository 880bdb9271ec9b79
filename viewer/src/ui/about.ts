// What the page holds and what it does not: the file, how the run ended, the precision of the numbers.

import type { About, Recording } from "../recording";
import { element, setText } from "./dom";
import { count, quantity } from "./format";

const STATUS: Record<About["status"], { mark: string; text: string }> = {
  complete: { mark: "✓", text: "complete" },
  running: { mark: "…", text: "still running" },
  failed: { mark: "✕", text: "failed" },
  interrupted: { mark: "‖", text: "interrupted" },
};

/** Says how the run ended, with a sign and a word; nothing when it is complete. */
export class Badge {
  readonly element = element("span", { class: "badge", role: "status" });

  constructor(private readonly recording: Recording) {
    this.update();
  }

  update(): void {
    const { status, detail } = this.recording.about;
    const { mark, text } = STATUS[status];
    this.element.hidden = status === "complete";
    this.element.dataset.status = status;
    this.element.title = detail;
    setText(this.element, `${mark} ${text}`);
  }
}

export class AboutPanel {
  readonly element = element("div", { class: "about" });

  constructor(private readonly recording: Recording) {
    this.update();
  }

  update(): void {
    const { about } = this.recording;
    this.element.replaceChildren(
      element("dl", {}, ...this.facts().flatMap(([name, value]) => [element("dt", {}, name), element("dd", {}, value)])),
      element("h3", {}, "Precision and what was left out"),
      element("ul", { class: "notes" }, ...about.notes.map((note) => element("li", {}, note))),
      element("p", { class: "note" }, "Between two frames positions and turns are interpolated. Everything is in SI units; ",
        "the page loads nothing from the network."),
    );
  }

  private facts(): [string, string][] {
    const { about, bodies, joints, springs, frames, times } = this.recording;
    const { text } = STATUS[about.status];
    const facts: [string, string][] = [
      ["Title", about.title || "none"],
      ["File", about.file],
      ["Run", about.detail ? `${text}: ${about.detail}` : text],
      ["physsim", about.physsimVersion],
      ["Frames", about.framesInFile === frames ? count(frames, "frame") : `${count(frames, "frame")} of ${about.framesInFile} in the file`],
    ];
    if (frames) facts.push(["Time", `${quantity(times[0], "s", 6)} to ${quantity(times[frames - 1], "s", 6)}`]);
    const who = [count(bodies.length, "body", "bodies"), count(joints.length, "joint"), count(springs.length, "spring")];
    facts.push(["Scene", who.filter((one) => !one.startsWith("0 ")).join(", ")]);
    return facts;
  }
}
