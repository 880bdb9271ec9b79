// Numbers in the page change at most twelve times a second: nobody reads faster, and text costs layout.

const PAUSE = 80;

/** A function that runs `call` at once or as soon as the pause since the last run is over, never more often. */
export function paced(call: () => void, pause = PAUSE): () => void {
  let last = -Infinity;
  let waiting = 0;
  const run = (): void => {
    waiting = 0;
    last = performance.now();
    call();
  };
  return () => {
    if (waiting) return;
    const rest = last + pause - performance.now();
    if (rest <= 0) run();
    else waiting = window.setTimeout(run, rest);
  };
}
