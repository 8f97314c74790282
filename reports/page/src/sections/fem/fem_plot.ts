/** The angle of the finite elements' force to each method's normal, by overlap ratio: a mark for each geometry and method. */
import type { Data, Shape } from "plotly.js";
import type { Fem, FemAnswer } from "../../data";
import { logAxis, logScale, marginLabels, marginShapes } from "../../log_scale";
import { colourOf, symbolOf } from "../../methods";
import { error, number } from "../../numbers";
import { type Drawing, plain } from "../../plot";
import { ink } from "../../theme";
import { angleTo, isMarked, methodsOf } from "./fem_words";
import { valueAxis } from "../study/study_plot";

/** In powers of ten: marks of one ratio stand side by side, in the order of the methods. */
const BESIDE = 0.022;

function words(answer: FemAnswer, method: string): string {
  const angle = angleTo(answer, method);
  const value = angle === null ? "no answer" : `${error(angle)}°`;
  const mark = isMarked(answer, method) ? " ✗" : "";
  return `<b>${plain(answer.geometry)}</b>, ${plain(method)}<br>overlap ratio ${number(answer.ratio)}: ${value}${mark}`;
}

/** Dashes where an angle to CN is asked for. */
const bounds = ({ asked, answers }: Fem): Partial<Shape>[] =>
  asked.cn.map(({ above, ratio, below_deg }) => {
    const rim = 10 ** (4 * BESIDE);
    const least = Math.min(...answers.map((answer) => answer.ratio));
    const [x0, x1] = [above > 0 ? above * rim : Math.min(least, ratio) / rim, ratio * rim];
    const line = { color: ink().bad, width: 1.4, dash: "dash" };
    return { type: "line", x0, x1, y0: below_deg, y1: below_deg, layer: "below", line } as Partial<Shape>;
  });

export function femDrawing(fem: Fem, hidden: Set<string>): Drawing {
  const { answers } = fem;
  const all = methodsOf(answers);
  const y = logScale(answers.flatMap((answer) => all.map((method) => angleTo(answer, method))));
  const marks = (method: string): Data => {
    const aside = 10 ** (BESIDE * (all.indexOf(method) - (all.length - 1) / 2));
    return {
      type: "scatter",
      mode: "markers",
      x: answers.map(({ ratio }) => ratio * aside),
      y: answers.map((answer) => y.place(angleTo(answer, method))),
      marker: { color: colourOf(method), symbol: symbolOf(method), size: 8.5, opacity: 0.8 },
      cliponaxis: false,
      hovertext: answers.map((answer) => words(answer, method)),
      hovertemplate: "%{hovertext}<extra></extra>",
    } as Data;
  };
  return {
    data: all.filter((method) => !hidden.has(method)).map(marks),
    layout: {
      xaxis: valueAxis(
        answers.map(({ ratio }) => ratio),
        "overlap ratio",
      ),
      yaxis: logAxis(y, "angle to the force, °", 6),
      margin: { l: 76, r: 12, t: 8, b: 44 },
      shapes: [...marginShapes(y, "y"), ...bounds(fem)],
      annotations: marginLabels(y, "y", "no answer"),
    },
  };
}
