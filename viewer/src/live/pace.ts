// How often a page shows what is new of a run: so that drawing leaves the processors to the run where they are few.

/** Milliseconds between two pictures at least, and those that a picture may take without being called slow. */
const REST = 15;
const QUICK = 25;
/** A page that is slow to draw rests so many times as long as it drew: then it takes a quarter of the time. */
const SHARE = 3;

export class Pace {
  /** Milliseconds until growth may be told again. */
  rest = REST;

  /** Growth was told, and a picture will follow: finds out how long the browser is busy with it. */
  measure(): void {
    requestAnimationFrame((drawn) =>
      requestAnimationFrame((next) => {
        const took = next - drawn;
        this.rest = took > QUICK ? SHARE * took : REST;
      }),
    );
  }
}
