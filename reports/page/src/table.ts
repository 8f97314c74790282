/** Tables that scroll inside a region of their own, which the keyboard can reach. */
import { append, type Child, freshId, h } from "./dom";

export interface Column<Row> {
  title: Child;
  /** Read aloud and shown on hover where the title is short. */
  hint?: string;
  cell: (row: Row) => Child | Child[];
  /** Figures stand right. */
  figure?: boolean;
  /** Names the row. */
  head?: boolean;
  /** Too wide for paper. */
  screenOnly?: boolean;
}

export interface TableOptions<Row> {
  caption: string;
  columns: Column<Row>[];
  rows: Row[];
  rowClass?: (row: Row) => string;
  /** The caption is for the screen reader only. */
  hideCaption?: boolean;
}

const classOf = <Row>({ figure, screenOnly }: Column<Row>): string =>
  [figure && "figure", screenOnly && "screen-only"].filter(Boolean).join(" ");

function headCell<Row>(column: Column<Row>): HTMLElement {
  if (!column.title) return h("td", { class: classOf(column) });
  return h("th", { scope: "col", class: classOf(column), title: column.hint }, column.title);
}

function bodyCell<Row>(column: Column<Row>, row: Row): HTMLElement {
  const cell = column.head ? h("th", { scope: "row" }) : h("td", { class: classOf(column) });
  const content = column.cell(row);
  append(cell, Array.isArray(content) ? content : [content]);
  return cell;
}

export function table<Row>({ caption, columns, rows, rowClass, hideCaption }: TableOptions<Row>): HTMLElement {
  const captionElement = h(
    "caption",
    { id: freshId("caption"), class: hideCaption ? "unseen" : "" },
    h("span", {}, caption),
  );
  const body = h("tbody");
  for (const row of rows)
    body.append(h("tr", { class: rowClass?.(row) ?? "" }, ...columns.map((column) => bodyCell(column, row))));
  const head = h("thead", {}, h("tr", {}, ...columns.map(headCell)));
  const region = { class: "scroll", role: "region", tabindex: 0, "aria-labelledby": captionElement.id };
  return h("div", region, h("table", {}, captionElement, head, body));
}

/** Pairs of a name and a value. */
export function definitions(pairs: [string, Child][]): HTMLElement {
  const list = h("dl");
  for (const [name, value] of pairs) list.append(h("div", {}, h("dt", {}, name), h("dd", {}, value)));
  return list;
}
