/** Text to copy or to keep as a file. */
import { button, h } from "./dom";

function selectText(element: Element): void {
  getSelection()?.selectAllChildren(element);
}

async function copy(text: string, source: Element): Promise<boolean> {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    selectText(source);
    return document.execCommand("copy");
  }
}

export function copyButton(text: string, source: Element, what: string): HTMLButtonElement {
  const told = button("Copy", async () => {
    told.textContent = (await copy(text, source)) ? "Copied" : "Selected";
    setTimeout(() => {
      told.textContent = "Copy";
    }, 1500);
  });
  told.className = "quiet copy";
  told.setAttribute("aria-label", `Copy ${what}`);
  return told;
}

export function command(text: string, what = "the command"): HTMLElement {
  const code = h("code", {}, text);
  return h(
    "div",
    { class: "command" },
    h("pre", { tabindex: 0, "aria-label": what }, code),
    copyButton(text, code, what),
  );
}

export function downloadButton(text: string, file: string): HTMLButtonElement {
  return button(
    "Download",
    () => {
      const url = URL.createObjectURL(new Blob([text], { type: "application/json" }));
      h("a", { href: url, download: file }).click();
      setTimeout(() => URL.revokeObjectURL(url), 1000);
    },
    { class: "quiet", "aria-label": `Download ${file}` },
  );
}
