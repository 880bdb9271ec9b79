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
    if (key === "Escape" && isTyping(event.target)) (event.target as HTMLElement).blur();
    if (isTaken(event.target, key)) return;
    const found = byKey.get(key);
    if (!found) return;
    event.preventDefault();
    if (key === " " && event.target instanceof HTMLButtonElement) event.target.blur();
    found.act(key);
  });
}

function isTyping(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && NAMES_OF_TYPING.has(target.tagName);
}

/** Fields take all keys, the slider of time none; buttons take Space and Enter, unless it was a mouse that went there:
 *  who clicked on a button and then presses Space wants to play. */
function isTaken(target: EventTarget | null, key: string): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target.closest("dialog[open]") && key !== "?" && key !== "h") return true;
  if (target instanceof HTMLInputElement && target.type === "range") return false;
  const isBox = target instanceof HTMLInputElement && ["checkbox", "radio"].includes(target.type);
  if (isBox) return key === " " || key.startsWith("Arrow");
  if (isTyping(target)) return true;
  return target.tagName === "BUTTON" && (key === " " || key === "Enter") && target.matches(":focus-visible");
}
