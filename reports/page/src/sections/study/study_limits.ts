/** How far the other definitions of a contact are from the common normal's as the overlap vanishes, or the shape changes. */
import type { StudyLimit, StudyOrder } from "../../data";
import { type Child, fill, h, select } from "../../dom";
import { inOrder } from "../../methods";
import { count, error, number } from "../../numbers";
import { type Figure, figure } from "../../plot";
import { legend, methodName } from "../../swatch";
import { type Column, table } from "../../table";
import { limitScale, limitsDrawing } from "./study_plot";
import { describeLimits, QUANTITIES, type Quantity, quantityName, sweepName } from "./study_words";

interface LimitsView {
  quantity: Quantity;
  hidden: Set<string>;
}

const columnsOf = (sweep: string): Column<StudyLimit>[] => [
  { title: "System", head: true, cell: ({ system }) => methodName(system) },
  { title: sweepName(sweep), figure: true, cell: ({ x }) => number(x) },
  {
    title: "Angle, °: median / max",
    figure: true,
    cell: (row) => `${error(row.angle_deg)} / ${error(row.angle_max_deg)}`,
  },
  { title: "Points / size", figure: true, cell: ({ point }) => error(point) },
  { title: "Overlap, relative", figure: true, cell: ({ overlap }) => error(overlap) },
  {
    title: "Proved of the pairs",
    figure: true,
    cell: ({ certified, pairs }) => `${count(certified)} of ${count(pairs)}`,
  },
];

const ORDER_COLUMNS: Column<StudyOrder>[] = [
  { title: "Shape", head: true, cell: ({ shape }) => shape },
  { title: "System", cell: ({ system }) => methodName(system) },
  { title: "Angle", figure: true, cell: ({ angle }) => number(angle) },
  { title: "Points", figure: true, cell: ({ point }) => number(point) },
  { title: "Overlap", figure: true, cell: ({ overlap }) => number(overlap) },
  {
    title: "Angle left, °",
    hint: "At the least overlap ratio",
    figure: true,
    cell: ({ limit_deg }) => number(limit_deg),
  },
];

function grouped(limits: StudyLimit[]): StudyLimit[][] {
  const groups = new Map<string, StudyLimit[]>();
  for (const row of limits) {
    const key = `${row.sweep}|${row.shape}`;
    groups.set(key, [...(groups.get(key) ?? []), row]);
  }
  return [...groups.values()];
}

function panel(all: StudyLimit[], rows: StudyLimit[], view: LimitsView): Figure {
  const { sweep, shape } = rows[0] as StudyLimit;
  const shown = () => rows.filter(({ system }) => !view.hidden.has(system));
  return figure({
    caption: sweep === "ratio" ? shape : `By ${sweepName(sweep)}: ${shape}`,
    describe: () => describeLimits(shown(), view.quantity),
    height: (width) => Math.min(330, Math.max(260, 0.8 * width)),
    draw: () => limitsDrawing(shown(), view.quantity, limitScale(all, view.quantity)),
    table: () =>
      table({ caption: `${sweepName(sweep)}, ${shape}`, columns: columnsOf(sweep), rows, hideCaption: true }),
    zoom: false,
  });
}

export function limitsBlock(limits: StudyLimit[]): Child[] {
  if (limits.length === 0) return [];
  const view: LimitsView = { quantity: "angle_deg", hidden: new Set() };
  const panels = grouped(limits).map((rows) => panel(limits, rows, view));
  const redraw = () => panels.forEach((one) => one.redraw());
  const pickQuantity = (quantity: string) => {
    view.quantity = quantity as Quantity;
    note.textContent = `Median ${quantityName(view.quantity)}, each against the certified common normal.`;
    redraw();
  };
  const note = h("p", { class: "note" });
  const grid = h("div", { class: "panels" });
  fill(grid, ...panels.map(({ element }) => element));
  const systems = inOrder(limits.map(({ system }) => system));
  pickQuantity(view.quantity);
  return [
    h("h3", {}, "Do the definitions agree in the limit?"),
    h(
      "div",
      { id: "study-limits" },
      h("div", { class: "controls" }, select("Difference", QUANTITIES, view.quantity, pickQuantity)),
      legend("Systems", systems, methodName, view.hidden, redraw),
      grid,
    ),
    note,
  ];
}

export function ordersBlock(orders: StudyOrder[]): Child[] {
  if (orders.length === 0) return [];
  const caption = "The power of the overlap ratio with which each difference vanishes, and the angle that is left";
  return [h("h3", {}, "Orders"), table({ caption, columns: ORDER_COLUMNS, rows: orders })];
}
