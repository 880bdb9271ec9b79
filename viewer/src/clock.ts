// The player: simulated time against the time of the wall.

import { MomentFinder } from "./moment";
import { round125 } from "./round125";
import type { Moment, Player } from "./player";
import type { Recording } from "./recording";

/** Text and curves beside the view are drawn anew so often [s] where pictures take longer than they should. */
const SLOW = 1 / 45;
const BETWEEN_CALLS = 0.1;
/** After a pause of the browser (another tab was in front) time goes on from where it stood. */
const LONGEST_STEP = 0.25;

/** Runs that last so long [s] play in real time at first; shorter and longer ones in about so many seconds. */
const REAL_TIME = [0.2, 120] as const;
const SHOWN_IN = 8;

export class Clock implements Player {
  readonly moment: Moment;
  playing = false;
  speed = 1;
  loop = false;
  /** Set when something changed; whoever draws asks for it. */
  private changed = true;
  /** Whether it stood at the end when it was shown; the end may have moved since. */
  private atEnd = false;
  private readonly finder: MomentFinder;
  private readonly calls = new Set<() => void>();
  private silent = 0;

  /** `wake`: asks for a picture. */
  constructor(
    readonly recording: Recording,
    private readonly wake: () => void,
  ) {
    this.finder = new MomentFinder(recording);
    this.moment = this.finder.moment;
    if (!recording.growing) this.speed = firstSpeed(this.end - this.start);
    this.show(this.start);
    recording.onGrowth(() => this.grow());
  }

  get following(): boolean {
    return this.playing && this.recording.growing && this.atEnd;
  }

  get start(): number {
    return this.recording.frames ? this.recording.times[0] : 0;
  }

  get end(): number {
    return this.recording.frames ? this.recording.times[this.recording.frames - 1] : 0;
  }

  play(): void {
    const { growing } = this.recording;
    if (this.end <= this.start && !growing) return;
    if (this.moment.time >= this.end && !growing) this.show(this.start);
    this.playing = true;
    this.touch();
  }

  pause(): void {
    this.playing = false;
    this.touch();
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  seek(time: number): void {
    if (!Number.isFinite(time)) return;
    this.show(Math.min(Math.max(time, this.start), this.end));
    this.touch();
  }

  step(n: number): void {
    this.playing = false;
    const { recording, moment } = this;
    if (!recording.frames || !Number.isFinite(n)) return;
    const onFrame = moment.fraction === 0 || n > 0 ? moment.frame : moment.frame + 1;
    const frame = Math.min(Math.max(onFrame + Math.trunc(n), 0), recording.frames - 1);
    this.seek(recording.times[frame]);
  }

  setSpeed(speed: number): void {
    if (!(speed > 0) || !Number.isFinite(speed)) return;
    this.speed = speed;
    this.touch();
  }

  setLoop(loop: boolean): void {
    this.loop = loop;
    this.touch();
  }

  onChange(call: () => void): () => void {
    this.calls.add(call);
    return () => this.calls.delete(call);
  }

  /** Goes on by so many seconds of the wall, and tells who listens: at every picture, but less often while a
   *  slow machine plays, which then has the time for the view. */
  advance(elapsed: number): void {
    const wasPlaying = this.playing;
    if (wasPlaying) this.goOn(Math.min(elapsed, LONGEST_STEP) * this.speed);
    this.silent += elapsed;
    if (!this.changed || (wasPlaying && this.playing && elapsed > SLOW && this.silent < BETWEEN_CALLS)) return;
    this.changed = false;
    this.silent = 0;
    for (const call of this.calls) call();
  }

  private goOn(seconds: number): void {
    if (this.following) return;
    const time = this.moment.time + seconds;
    this.changed = true;
    if (time < this.end) this.show(time);
    else if (this.loop) this.show(this.start + ((time - this.start) % (this.end - this.start)));
    else {
      this.show(this.end);
      this.playing = this.recording.growing;
    }
  }

  /** Frames came; those before may have got other numbers. */
  private grow(): void {
    this.show(this.following ? this.end : this.moment.time);
    this.touch();
  }

  private show(time: number): void {
    this.finder.show(time);
    this.atEnd = time >= this.end;
  }

  private touch(): void {
    this.changed = true;
    this.wake();
  }
}

function firstSpeed(duration: number): number {
  return duration === 0 || (duration >= REAL_TIME[0] && duration <= REAL_TIME[1]) ? 1 : round125(duration / SHOWN_IN);
}
