// Keeps the picture fluent: lowers the quality when pictures take too long, raises it when there is time to spare.

/** What the drawing costs most. */
export interface Quality {
  /** Pixels drawn for one pixel of the page, along each side. */
  readonly pixels: number;
  /** Side of the shadow map, 0: no shadows. */
  readonly shadows: number;
  /** Round shapes look round, and light falls on every pixel. */
  readonly fine: boolean;
}

const LEVELS: readonly Quality[] = [
  { pixels: 2, shadows: 2048, fine: true },
  { pixels: 1.5, shadows: 2048, fine: true },
  { pixels: 1, shadows: 2048, fine: true },
  { pixels: 1, shadows: 1024, fine: true },
  { pixels: 1, shadows: 0, fine: true },
  { pixels: 1, shadows: 0, fine: false },
  { pixels: 0.75, shadows: 0, fine: false },
  { pixels: 0.5, shadows: 0, fine: false },
];
/** What it begins with where the processor draws, with few solids and with many. */
const SOFTWARE_BEST = 3;
const SOFTWARE_MANY = 5;
const MANY_SOLIDS = 300;
/** So much slower than wanted: two levels at once. */
const FAR_TOO_SLOW = 2;
/** Pictures that take longer [s] are too slow, on average over `PATIENCE` seconds. When they took less than `TO_SPARE`
 *  for `CAUTION` seconds there is time to spare. */
const TOO_SLOW = 1 / 34;
const TO_SPARE = 1 / 50;
const PATIENCE = 0.6;
const CAUTION = 4;
/** A level that was too slow is tried again after so many seconds: something else may have kept the machine busy. */
const FORGET = 20;
/** Times between pictures that say nothing: another tab was in front, or nothing was drawn for a while. */
const INTERRUPTED = 0.5;
/** After a change the first pictures compile shaders and make buffers. */
const SETTLING = 3;

export class Governor {
  private level: number;
  private readonly best: number;
  private readonly first: number;
  /** The lowest level that was too slow, and with it all above it. */
  private blocked = -1;
  private sinceBlocked = 0;
  private time = 0;
  private pictures = 0;
  private spare = 0;
  private settling = SETTLING;

  /** ratio: pixels of the screen for one of the page; software: whether the processor draws. */
  constructor(ratio: number, software: boolean, solids: number) {
    const sharpest = LEVELS.findIndex((quality) => quality.pixels <= Math.max(1, ratio));
    this.best = software ? Math.max(sharpest, SOFTWARE_BEST) : sharpest;
    this.first = software && solids > MANY_SOLIDS ? SOFTWARE_MANY : this.best;
    this.level = this.first;
  }

  /** While something moves. */
  get quality(): Quality {
    return LEVELS[this.level];
  }

  /** When nothing moves: there is time for one good picture. */
  get still(): Quality {
    return LEVELS[this.first];
  }

  /** Says how long the last picture took [s]; true when the quality changed. Only while something moves. */
  measure(elapsed: number): boolean {
    if (elapsed > INTERRUPTED && this.pictures === 0) return false;
    if (this.settling > 0) {
      this.settling--;
      return false;
    }
    this.time += elapsed;
    this.pictures++;
    this.sinceBlocked += elapsed;
    if (this.sinceBlocked > FORGET) this.blocked = -1;
    return this.time > PATIENCE && this.judge(this.time / this.pictures);
  }

  /** mean: time that a picture took lately [s]. */
  private judge(mean: number): boolean {
    if (mean > TOO_SLOW) return this.change(mean > FAR_TOO_SLOW * TOO_SLOW ? 2 : 1);
    this.spare = mean < TO_SPARE ? this.spare + this.time : 0;
    const better = this.level - 1;
    if (this.spare > CAUTION && better >= this.best && better > this.blocked) return this.change(-1);
    this.restart();
    return false;
  }

  /** Nothing moves any more: what was measured so far counts no longer. */
  restart(): void {
    this.time = 0;
    this.pictures = 0;
  }

  /** A level that was too slow is not tried again for a while. */
  private change(by: number): boolean {
    const level = Math.min(LEVELS.length - 1, this.level + by);
    if (by > 0) {
      this.blocked = Math.max(this.blocked, level - 1);
      this.sinceBlocked = 0;
    }
    this.restart();
    this.spare = 0;
    this.settling = SETTLING;
    const changed = level !== this.level;
    this.level = level;
    return changed;
  }
}
