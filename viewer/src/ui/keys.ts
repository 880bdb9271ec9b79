// Keyboard shortcuts: one table for what they do and for the help that lists them.

export interface Shortcut {
  /** As KeyboardEvent.key gives them, letters in lower case. */
  keys: readonly string[];
  /** As people read them. */
  print: string;
  does: string;
  group: "Play" | "View" | "Show" | "Panels";
  act: (key: string) => void;
}

const NAMES_OF_TYPING = new Set(["INPUT", "TEXTAREA", "SELECT"]);

/** Runs shortcuts on key presses that nobody else wants: not while typing, not with Ctrl, Alt or the command key. */
export function listenToKeys(shortcuts: readonly Shortcut[]): void {
  const byKey = new Map(shortcuts.flatMap((one) => one.keys.map((key) => [key, one] as const)));
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || event.ctrlKey || event.metaKey || event.altKey) return;
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (isTaken(event.target, key)) return;
    const found = byKey.get(key);
    if (!found) return;
    event.preventDefault();
    found.act(key);
  });
}

/** Fields take all keys, the slider of time its own but those of the table, buttons Space and Enter. */
function isTaken(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest("dialog[open]") && key !== "?" && key !== "h") return true;
  if (target instanceof HTMLInputElement && target.type === "range") return !target.classList.contains("time");
  if (target instanceof HTMLInputElement && target.type === "checkbox") return key === " ";
  if (NAMES_OF_TYPING.has(target.tagName)) return true;
  return (target.tagName === "BUTTON" || target.tagName === "SUMMARY") && (key === " " || key === "Enter");
}
