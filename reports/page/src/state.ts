import type { Report, Run } from "./data";
import { fill } from "./dom";
import type { Watched } from "./watched";

/** What all sections share: the document, and the run that the reader has chosen. */
export interface State {
  report: Report;
  run: Watched<Run>;
}

/** A place that is made anew for every run that is chosen. */
export function perRun(state: State, place: HTMLElement, make: (run: Run) => (Node | null)[]): HTMLElement {
  const refill = (run: Run) => fill(place, ...make(run));
  state.run.watch(refill);
  refill(state.run.value);
  return place;
}
