// Pictures per second.

const SPAN = 1000;
const MOST = 256;

export class Rate {
  private readonly moments = new Float64Array(MOST);
  private count_ = 0;
  private last = 0;

  /** Of the last second in which something moved; 0 before. */
  get perSecond(): number {
    return this.last;
  }

  /** A picture was drawn at a time [ms]. False for the first one after a pause, which has no picture before it. */
  count(now: number): boolean {
    this.moments[this.count_ % MOST] = now;
    this.count_++;
    const known = Math.min(this.count_, MOST);
    let first = now, pictures = 0;
    while (pictures + 1 < known && now - this.moments[(this.count_ - 2 - pictures) % MOST] <= SPAN) {
      pictures++;
      first = this.moments[(this.count_ - 1 - pictures) % MOST];
    }
    if (now > first) this.last = (1000 * pictures) / (now - first);
    return pictures > 0;
  }

  /** Nothing moves: the time until it does again is nobody's fault. */
  pause(): void {
    this.count_ = 0;
  }
}
