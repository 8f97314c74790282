import type { Report, Run } from "./data";
import { fill } from "./dom";
import type { Watched } from "./watched";

/** What all sections share: the document, and the run that the reader has chosen; null where there is none. */
export interface State {
  report: Report;
  run: Watched<Run> | null;
}

/** A place that is made anew for every run that is chosen; without a run, an empty one. */
export function perRun(state: State, place: HTMLElement, make: (run: Run) => (Node | null)[]): HTMLElement {
  if (!state.run) return place;
  const refill = (run: Run) => fill(place, ...make(run));
  state.run.watch(refill);
  refill(state.run.value);
  return place;
}
