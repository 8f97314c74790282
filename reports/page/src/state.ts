import type { Report, Run } from "./data";
import { fill } from "./dom";
import type { Watched } from "./watched";

/** What all sections share: the document, and the run and accuracy that the reader has chosen; no run where there is none. */
export interface State {
  report: Report;
  run: Watched<Run> | null;
  accuracy: Watched<string>;
}

/** A place that is made anew for every run that is chosen; without a run, an empty one. */
export function perRun(state: State, place: HTMLElement, make: (run: Run) => (Node | string | null)[]): HTMLElement {
  if (!state.run) return place;
  const refill = (run: Run) => fill(place, ...make(run));
  state.run.watch(refill);
  refill(state.run.value);
  return place;
}

/** The same, and for every accuracy. */
export function perLevel(
  state: State,
  place: HTMLElement,
  make: (run: Run, level: string) => (Node | string | null)[],
): HTMLElement {
  const { run, accuracy } = state;
  perRun(state, place, (chosen) => make(chosen, accuracy.value));
  if (run) accuracy.watch((level) => fill(place, ...make(run.value, level)));
  return place;
}
