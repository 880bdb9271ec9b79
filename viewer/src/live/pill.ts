// The pill above the view that says how far a run is that is being watched, and leads back to its newest moment.

import type { App } from "../app";
import { keepInSight } from "./framing";
import type { LiveRecording, LiveStatus } from "./recording";
import "./pill.css";

const WORDS: Record<Exclude<LiveStatus, "running">, string> = {
  complete: "✓ The run is complete",
  failed: "✕ The run failed",
  interrupted: "‖ The run was interrupted",
  lost: "✕ The connection to the run was lost",
};
/** The end of a run is said for so many milliseconds; the header goes on saying what is worth knowing. */
const LAST = 12_000;

/** Follows the run, and adds the pill to the page. */
export function keepLive(app: App, recording: LiveRecording): void {
  const { player, root } = app;
  const pill = document.createElement("button");
  pill.className = "live-pill";
  pill.setAttribute("aria-live", "polite");
  pill.addEventListener("click", () => {
    player.seek(player.end);
    player.play();
  });
  const show = (): void => {
    pill.textContent = textOf(recording, player.following);
    pill.dataset.state = recording.growing ? (player.following ? "following" : "behind") : recording.status;
    pill.disabled = !recording.growing || player.following;
    pill.title = recording.about.detail;
  };
  player.onChange(show);
  const stop = recording.onGrowth(() => {
    show();
    if (recording.growing) return;
    stop();
    if (recording.status !== "lost") setTimeout(() => pill.remove(), LAST);
  });
  root.append(pill);
  player.seek(player.end);
  player.play();
  keepInSight(app);
  show();
}

function textOf(recording: LiveRecording, following: boolean): string {
  if (recording.status !== "running") return WORDS[recording.status];
  if (!following) return "● Back to live";
  const done = recording.times[recording.frames - 1] / recording.duration;
  return `● Live, ${Math.floor(100 * Math.min(done, 1))} %`;
}
