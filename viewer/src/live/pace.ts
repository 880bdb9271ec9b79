// How often a page shows what is new of a run: so that drawing leaves the processors to the run where they are few.

/** Milliseconds between two pictures at least, and those that a picture may take without being called slow. */
const REST = 15;
const QUICK = 25;
/** A page that is slow to draw rests so many times as long as it drew, so that it takes a quarter of the time; but
 *  somebody is looking, so no longer than this. */
const SHARE = 3;
const LONGEST_REST = 700;

export class Pace {
  /** Milliseconds until growth may be told again. */
  rest = REST;

  /** Growth was told, and a picture will follow: finds out how long the browser is busy with it. */
  measure(): void {
    requestAnimationFrame((drawn) =>
      requestAnimationFrame((next) => {
        const took = next - drawn;
        this.rest = took > QUICK ? Math.min(SHARE * took, LONGEST_REST) : REST;
      }),
    );
  }
}
