// Live numbers with names: a heading with its unit, and a cell for each component.

import { button, element, icon, setText } from "./dom";
import { number, unitInPrint } from "./format";
import { PLOTS } from "./icons";

/** Digits while everything moves; more could not be read. */
const DIGITS_PLAYING = 5;
const DIGITS_STANDING = 10;

/** As wide as a digit: points stand below each other where some components are known better than others. */
const FIGURE_SPACE = "\u2007";

function decimalsOf(text: string): number {
  return /^[^.]*\.(\d+)$/.exec(text)?.[1].length ?? 0;
}

export class Reading {
  readonly element: HTMLElement;
  private readonly cells: HTMLElement[];

  /** `plot` is called when its plot is wanted; null: there is none to make. */
  constructor(name: string, unit: string, components: readonly string[], plot: (() => void) | null) {
    this.cells = (components.length ? components : [""]).map(() => element("output", { "aria-live": "off" }));
    const shown = this.cells.map((cell, i) =>
      element("span", { class: "cell" }, components[i] ? element("i", {}, components[i]) : "", cell));
    const heading = element("h4", {}, name, " ", element("span", { class: "unit" }, unitInPrint(unit)));
    const head = element("header", {}, heading);
    if (plot) head.append(button(`Plot ${name}`, icon(...PLOTS), "", plot));
    this.element = element("div", { class: `reading parts-${this.cells.length}` }, head,
      element("div", { class: "cells" }, ...shown));
  }

  /** `error(i)`: no number is off by more. */
  print(values: ArrayLike<number>, playing: boolean, error: (i: number) => number): void {
    const digits = playing ? DIGITS_PLAYING : DIGITS_STANDING;
    const texts = this.cells.map((_, i) => number(values[i], digits, error(i)));
    const most = Math.max(...texts.map(decimalsOf));
    this.cells.forEach((cell, i) => setText(cell, texts[i] + FIGURE_SPACE.repeat(most - decimalsOf(texts[i]))));
  }
}
