/** Counts the solves of each frame, so that a test can see that none waits for more than one of each method. */
import type { Plumb } from "../../plumb-contact/plumb_contact.mjs";

export class Counted {
  private frame = new Map<string, number>();
  private frames = 0;
  private most = 0;
  readonly plumb: Plumb;

  constructor(plumb: Plumb) {
    this.plumb = {
      methods: plumb.methods,
      describeInput: (pair) => plumb.describeInput(pair),
      bounds: (pair, contact, options) => plumb.bounds(pair, contact, options),
      solve: (pair, options) => {
        const name = options?.method ?? "auto";
        this.frame.set(name, (this.frame.get(name) ?? 0) + 1);
        return plumb.solve(pair, options);
      },
    };
  }

  /** What was solved since the last end was this frame's. */
  endFrame(milliseconds: number): void {
    this.most = Math.max(this.most, ...this.frame.values());
    this.frames++;
    this.frame.clear();
    Object.assign(document.documentElement.dataset, {
      frames: String(this.frames),
      mostSolves: String(this.most),
      solveMs: milliseconds.toFixed(3),
    });
  }

  /** A preset is placed first: that is no frame. */
  forget(): void {
    this.frame.clear();
  }
}
