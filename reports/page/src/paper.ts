/** On paper: light, figures at the paper's width, everything open that is not the case's JSON or a licence. */
import { drawForPaper } from "./plot";
import { stillsForPaper } from "./sections/playback";
import { setPrinting } from "./theme";
import { drawCardsForPaper } from "./view3d/cards";

const opened: HTMLDetailsElement[] = [];

function openDetails(): void {
  for (const element of document.querySelectorAll("details:not([data-print=closed])")) {
    const closed = element as HTMLDetailsElement;
    if (closed.open) continue;
    closed.open = true;
    closed.dispatchEvent(new Event("toggle"));
    opened.push(closed);
  }
}

export function preparePaper(): void {
  addEventListener("beforeprint", () => {
    setPrinting(true);
    openDetails();
    drawForPaper(true);
    drawCardsForPaper();
    stillsForPaper(true);
  });
  addEventListener("afterprint", () => {
    setPrinting(false);
    for (const element of opened.splice(0)) element.open = false;
    drawForPaper(false);
    stillsForPaper(false);
  });
}
