// Building the page: elements with text that is never read as markup.

type Child = Node | string;
type Attributes = Record<string, string | number | boolean>;

const SVG = "http://www.w3.org/2000/svg";

/** An element with attributes and children; strings become text. `true` sets a bare attribute, `false` none. */
export function element<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const made = document.createElement(tag);
  setAttributes(made, attributes);
  made.append(...children);
  return made;
}

function setAttributes(target: Element, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (value !== false) target.setAttribute(name, value === true ? "" : String(value));
  }
}

/** Sets the text if it changed, so that a page that stands still costs nothing. */
export function setText(target: Element, text: string): void {
  if (target.firstChild instanceof Text && target.childNodes.length === 1) {
    if (target.firstChild.data !== text) target.firstChild.data = text;
  } else target.textContent = text;
}

/** An icon of 24 by 24 from path data; decoration only, the button carries the name. */
export function icon(...paths: string[]): SVGSVGElement {
  const svg = document.createElementNS(SVG, "svg");
  setAttributes(svg, { viewBox: "0 0 24 24", "aria-hidden": "true", focusable: "false", class: "icon" });
  for (const data of paths) {
    const path = document.createElementNS(SVG, "path");
    path.setAttribute("d", data);
    svg.append(path);
  }
  return svg;
}

/** A straight line of an SVG picture, dashed as the plot draws it. */
export function svgLine(width: number, height: number, colour: string, dash: readonly number[]): SVGSVGElement {
  const svg = document.createElementNS(SVG, "svg");
  setAttributes(svg, { width, height, viewBox: `0 0 ${width} ${height}`, "aria-hidden": "true" });
  const line = document.createElementNS(SVG, "line");
  setAttributes(line, { x1: 0, x2: width, y1: height / 2, y2: height / 2, stroke: colour, "stroke-width": 2 });
  if (dash.length) line.setAttribute("stroke-dasharray", dash.join(" "));
  svg.append(line);
  return svg;
}

/** A button that its own text names. */
export function textButton(act: () => void, ...children: Child[]): HTMLButtonElement {
  const made = element("button", { type: "button" }, ...children);
  made.addEventListener("click", act);
  return made;
}

/** A button with an icon, a name for those who do not see it, and the key that does the same. */
export function button(name: string, content: Child, key: string, act: () => void): HTMLButtonElement {
  const title = key ? `${name} (${key})` : name;
  const made = element("button", { type: "button", "aria-label": name, title }, content);
  if (key) made.setAttribute("aria-keyshortcuts", key);
  made.addEventListener("click", act);
  return made;
}
