/** Light or dark: the reader's system decides until the reader does. Paper is light. */
import { button } from "./dom";
import { Watched } from "./watched";

export type Theme = "light" | "dark";

export interface Ink {
  text: string;
  muted: string;
  grid: string;
  paper: string;
  band: string;
  front: string;
  good: string;
  bad: string;
}

const INKS: Record<Theme, Ink> = {
  light: {
    text: "#1c2127",
    muted: "#59636e",
    grid: "#e3e7eb",
    paper: "#ffffff",
    band: "rgba(89,99,110,0.10)",
    front: "rgba(240,190,20,0.38)",
    good: "#00795a",
    bad: "#b3400a",
  },
  dark: {
    text: "#e8ebee",
    muted: "#a5b0bb",
    grid: "#2c343d",
    paper: "#14181d",
    band: "rgba(165,176,187,0.13)",
    front: "rgba(245,200,60,0.34)",
    good: "#3ecba0",
    bad: "#ff9256",
  },
};

const STORE = "plumb-theme";
const systemIsDark = matchMedia("(prefers-color-scheme: dark)");
let chosen: Theme | null = null;
let printing = false;

export const theme = new Watched<Theme>("light");
export const ink = (): Ink => INKS[theme.value];

function settle(): void {
  const screen = chosen ?? (systemIsDark.matches ? "dark" : "light");
  document.documentElement.dataset.theme = screen;
  const next = printing ? "light" : screen;
  if (next !== theme.value) theme.value = next;
}

export function setPrinting(on: boolean): void {
  printing = on;
  settle();
}

function remembered(): Theme | null {
  try {
    const stored = localStorage.getItem(STORE);
    return stored === "light" || stored === "dark" ? stored : null;
  } catch {
    return null;
  }
}

function choose(next: Theme): void {
  chosen = next;
  try {
    localStorage.setItem(STORE, next);
  } catch {
    // Storage is refused to some pages from disk; the choice then lasts as long as the page.
  }
  settle();
}

export function startTheme(): void {
  chosen = remembered();
  systemIsDark.addEventListener("change", settle);
  settle();
}

export function themeButton(): HTMLButtonElement {
  const toggle = button("", () => choose(theme.value === "dark" ? "light" : "dark"), { class: "quiet", id: "theme" });
  const name = () => {
    toggle.textContent = theme.value === "dark" ? "Light" : "Dark";
    toggle.setAttribute("aria-label", `Switch to ${theme.value === "dark" ? "light" : "dark"} colours`);
  };
  theme.watch(name);
  name();
  return toggle;
}
