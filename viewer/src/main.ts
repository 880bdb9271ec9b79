// Opens the page: head and sections become a recording, which is drawn and played.

import { apiOf } from "./api";
import type { App, Ui } from "./app";
import { Clock } from "./clock";
import { recordingOf } from "./decode";
import { graphicsFor } from "./graphics";
import type { Head } from "./head";
import { followAddress } from "./link";
import { keepLive } from "./live/pill";
import { LiveRecording, watched, type LiveHead } from "./live/recording";
import type { Recording } from "./recording";
import { DocumentSections } from "./sections";
import { Stage } from "./stage";
import { mountUi } from "./ui/index";
import "./page.css";

const TOO_OLD = "This browser is too old for the page: Chrome or Edge 94, Firefox 113, Safari 16.4 and newer show it.";
const NO_WEBGL =
  "This browser cannot draw in three dimensions here (it has no WebGL 2). Often it helps to allow hardware acceleration in its settings, or to open the page in another browser.";

async function open(): Promise<{ app: App; ui: Ui }> {
  const root = document.getElementById("physsim");
  const text = document.getElementById("head")?.textContent;
  if (!root || !text) throw new Error("The page is incomplete.");
  if (!("DecompressionStream" in window)) throw new Error(TOO_OLD);
  const recording = await recordingIn(JSON.parse(text) as Head | LiveHead);
  const graphics = graphicsFor(recording.placed.length);
  if (!graphics) throw new Error(NO_WEBGL);

  // The clock asks for pictures of a world that is made after it.
  let stage: Stage | null = null;
  const clock = new Clock(recording, () => stage?.redraw());
  root.replaceChildren(graphics.renderer.domElement);
  const world = (stage = new Stage(graphics.renderer, recording, clock, graphics.software));
  const app = { recording, player: clock, world, root };
  const ui = mountUi(app);
  if (recording instanceof LiveRecording) keepLive(app, recording);
  followAddress(app, ui);
  return { app, ui };
}

function recordingIn(head: Head | LiveHead): Promise<Recording> {
  const sections = new DocumentSections(head.sections);
  return "live" in head ? watched(head, sections) : recordingOf(head, sections);
}

/** In place of "Opening the recording". */
function tell(error: unknown): void {
  const message = document.getElementById("message");
  if (!message) return;
  const line = document.createElement("p");
  line.textContent = error instanceof Error ? error.message : String(error);
  message.replaceChildren(line);
}

const opening = open();
window.physsim = apiOf(opening);
window.physsim.ready.catch(tell);
