/** A line over a figure: it moves without the figure being drawn anew. */
import { h } from "./dom";

interface Drawn {
  _fullLayout?: {
    xaxis: { range: [number, number]; _offset: number; _length: number };
    _size: { t: number; h: number };
  };
}

export class Mark {
  readonly line = h("div", { class: "plot-mark", hidden: true });
  private x: number | null = null;
  constructor(private readonly plot: HTMLElement) {}

  to(x: number): void {
    this.x = x;
    this.place();
  }

  /** Where its value is now, which zooming changes. */
  place(): void {
    const drawn = (this.plot as Drawn)._fullLayout;
    if (this.x === null || !drawn) return;
    const { range, _offset, _length } = drawn.xaxis;
    const part = (this.x - Number(range[0])) / (Number(range[1]) - Number(range[0]));
    this.line.hidden = !(part >= 0 && part <= 1);
    if (this.line.hidden) return;
    this.line.style.cssText = `left: ${_offset + part * _length}px; top: ${drawn._size.t}px; height: ${drawn._size.h}px`;
  }
}
