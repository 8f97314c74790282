/** Elements made without markup in strings: all text of the data goes through text nodes. */

export type Child = Node | string | null | undefined | false;
type Attributes = Record<string, string | number | boolean | ((event: Event) => void) | undefined>;

export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== undefined) element.setAttribute(name, String(value));
  }
  append(element, children);
  return element;
}

export function append(parent: Node, children: Child[]): void {
  for (const child of children) {
    if (child === null || child === undefined || child === false) continue;
    parent.appendChild(typeof child === "string" ? document.createTextNode(child) : child);
  }
}

export function fill(parent: Element, ...children: Child[]): void {
  parent.replaceChildren();
  append(parent, children);
}

let last = 0;
export const freshId = (stem: string): string => `${stem}-${++last}`;

/** A section with a heading and, in one line, the question that it answers. */
export function section(id: string, title: string, question: string, ...children: Child[]): HTMLElement {
  const heading = h("h2", { id: `${id}-title` }, title);
  return h(
    "section",
    { id, "aria-labelledby": heading.id },
    heading,
    h("p", { class: "question" }, question),
    ...children,
  );
}

/** Of a section only the heading and the question are seen until it is opened. */
export function fold(element: HTMLElement): void {
  const [heading, question, ...rest] = [...element.children];
  const asked = h("span", { class: "question" }, question?.textContent ?? "");
  element.replaceChildren(h("details", { class: "fold" }, h("summary", {}, heading ?? null, asked), ...rest));
}

/** Opens what a link leads to. */
export function unfold(element: Element | null): void {
  const closed = element?.querySelector<HTMLDetailsElement>(":scope > details.fold");
  if (closed) closed.open = true;
}

/** A labelled select; `values` as [value, text]. */
export function select(
  label: string,
  values: [string, string][],
  chosen: string,
  changed: (value: string) => void,
): HTMLElement {
  const control = h("select", { change: () => changed(control.value) });
  for (const [value, text] of values) control.append(h("option", { value, selected: value === chosen }, text));
  return h("label", { class: "field" }, h("span", {}, label), control);
}

export function checkbox(label: Child, checked: boolean, changed: (checked: boolean) => void): HTMLElement {
  const control = h("input", { type: "checkbox", checked, change: () => changed(control.checked) });
  return h("label", { class: "check" }, control, label);
}

export function button(label: string, pressed: () => void, attributes: Attributes = {}): HTMLButtonElement {
  return h("button", { type: "button", click: pressed, ...attributes }, label);
}

/** Built when it is opened first; `print: "closed"` keeps it shut on paper. */
export function details(summary: Child, content: () => Child, attributes: Attributes = {}): HTMLDetailsElement {
  const element = h("details", attributes, h("summary", {}, summary));
  let built = false;
  element.addEventListener("toggle", () => {
    if (!element.open || built) return;
    built = true;
    append(element, [content()]);
  });
  return element;
}

export const unique = (words: string[]): string[] => [...new Set(words)].sort();

/** A name that may be broken after its underscores. */
export const breakable = (name: string): string => name.replaceAll("_", "_\u200b");
