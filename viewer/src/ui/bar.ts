// The bar at the bottom: playing, stepping, the slider of time, speed, loop.

import type { Player } from "../player";
import { button, element, icon, setText } from "./dom";
import { signed, timeDecimals, times } from "./format";
import { BACK, FIRST, FORWARD, LAST, LOOP, PAUSE, PLAY } from "./icons";
import { paced } from "./pace";

export const SPEEDS = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100];

/** The next speed of the list above (`way` 1) or below (-1) the one that is set. */
export function nextSpeed(speed: number, way: 1 | -1): number {
  const near = 1e-9 * speed;
  const found = way > 0 ? SPEEDS.find((one) => one > speed + near) : SPEEDS.filter((one) => one < speed - near).pop();
  return found ?? speed;
}

export class Bar {
  readonly element: HTMLElement;
  private readonly play: HTMLButtonElement;
  private readonly loop: HTMLButtonElement;
  private readonly playIcon = icon(...PLAY);
  private readonly pauseIcon = icon(...PAUSE);
  private readonly slider = element("input", { type: "range", class: "time", step: "any", "aria-label": "Time" });
  private readonly time = element("output", { class: "now", "aria-live": "off" });
  private readonly frame = element("span", { class: "frame" });
  private readonly speed = element("select", { "aria-label": "Speed of playing", title: "Speed ([ slower, ] faster)" });
  private shown: boolean | null = null;
  private readonly print = paced(() => this.printNow());

  constructor(private readonly player: Player) {
    this.play = button("Play", this.playIcon, "Space", () => player.toggle());
    this.play.className = "play";
    this.loop = button("Loop", icon(...LOOP), "L", () => player.setLoop(!player.loop));
    this.element = element(
      "div", { class: "bar", role: "toolbar", "aria-label": "Playing" },
      this.slider,
      element("div", { class: "buttons" },
        button("First frame", icon(...FIRST), "Home", () => player.seek(player.start)),
        button("One frame back", icon(...BACK), "←", () => player.step(-1)),
        this.play,
        button("One frame forward", icon(...FORWARD), "→", () => player.step(1)),
        button("Last frame", icon(...LAST), "End", () => player.seek(player.end))),
      element("div", { class: "readout" }, this.time, this.frame),
      element("div", { class: "pace" }, this.speed, this.loop),
    );
    this.listen();
    this.update();
    this.printNow();
  }

  /** The moment, or how it is played, changed. */
  update(): void {
    if (this.shown !== this.player.playing) this.showPlaying();
    this.print();
  }

  private showPlaying(): void {
    this.shown = this.player.playing;
    this.play.replaceChildren(this.shown ? this.pauseIcon : this.playIcon);
    this.play.setAttribute("aria-label", this.shown ? "Pause" : "Play");
    this.play.title = `${this.shown ? "Pause" : "Play"} (Space)`;
  }

  private printNow(): void {
    const { player, slider } = this;
    const { start, end, moment, recording } = player;
    const decimals = timeDecimals(recording.frames > 1 ? (end - start) / (recording.frames - 1) : 0);
    const now = signed(moment.time, decimals);
    slider.min = String(start);
    slider.max = String(end);
    slider.disabled = !(end > start);
    slider.value = String(moment.time);
    slider.style.setProperty("--played", `${(100 * (moment.time - start)) / (end - start || 1)}%`);
    slider.setAttribute("aria-valuetext", `${now} of ${signed(end, decimals)} seconds`);
    setText(this.time, `${now} / ${signed(end, decimals)}\u202fs`);
    setText(this.frame, `frame ${moment.frame + 1} of ${recording.frames}`);
    this.loop.setAttribute("aria-pressed", String(player.loop));
    this.printSpeed();
  }

  private printSpeed(): void {
    const wanted = String(this.player.speed);
    if (this.speed.value === wanted && this.speed.options.length) return;
    const all = [...new Set([...SPEEDS, this.player.speed])].sort((a, b) => a - b);
    this.speed.replaceChildren(...all.map((one) => element("option", { value: one, selected: String(one) === wanted },
      one === 1 ? "1× real time" : times(one))));
    this.speed.value = wanted;
  }

  private listen(): void {
    const { slider, speed, player } = this;
    let wasPlaying = false;
    slider.addEventListener("pointerdown", () => {
      wasPlaying = player.playing;
      player.pause();
    });
    slider.addEventListener("input", () => player.seek(Number(slider.value)));
    slider.addEventListener("change", () => {
      if (wasPlaying) player.play();
      wasPlaying = false;
    });
    let byPointer = false;
    speed.addEventListener("pointerdown", () => (byPointer = true));
    speed.addEventListener("keydown", () => (byPointer = false));
    speed.addEventListener("change", () => {
      player.setSpeed(Number(speed.value));
      // Else the next key would choose another speed.
      if (byPointer) speed.blur();
    });
  }
}
