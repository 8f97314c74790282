import { load } from "../../plumb-contact/plumb_contact.mjs";
import type { Report, Vec } from "../../page/src/data";
import { button, fill, h, select } from "../../page/src/dom";
import { meetMethods } from "../../page/src/methods";
import { startTheme, theme, themeButton } from "../../page/src/theme";
import { Orbit } from "../../page/src/view3d/orbit";
import { hasWebGl, renderTo } from "../../page/src/view3d/renderer";
import { dispose, type Pictured } from "../../page/src/view3d/scene";
import { Answers } from "./answers";
import { Counted } from "./counted";
import { type Hold, Hands } from "./hands";
import { isWrong, type Judged, judgeAll, outside, touchDistance } from "./judge";
import { caseOf, copyOf, pairOf, type Setting, settingOf, wordOf } from "./pair";
import { picture } from "./picture";
import { type Preset, presets } from "./presets";
import { Sliders } from "./sliders";

const HOLDS: [Hold, string][] = [
  ["view", "Turn the view"],
  ["turn1", "Turn body 1"],
  ["turn2", "Turn body 2"],
  ["move2", "Move body 2"],
];
const START: Vec = [1.6, -3.9, 1.8];
/** A browser refuses many changes of the address in a row. */
const ADDRESS_DELAY_MS = 300;
/** The bounds wait until nothing moves: they take some milliseconds. */
const BOUNDS_DELAY_MS = 150;

class Playground {
  private setting: Setting;
  private judged: Judged[] = [];
  private pictured: Pictured | null = null;
  private isAsked = false;
  private addressTimer = 0;
  private boundsTimer = 0;

  private readonly canvas = h("canvas", {
    tabindex: 0,
    role: "application",
    "aria-label":
      "3-D view of both bodies. Arrow keys turn it, or what is chosen below; plus and minus zoom, 0 resets.",
  });
  private readonly sentence = h("p", { class: "sentence", role: "status" });
  private readonly summary = h("p", { class: "summary" });
  private readonly bounds = h("p", { class: "bounds" });
  private readonly json = h("textarea", {
    readonly: true,
    rows: 6,
    spellcheck: "false",
    "aria-label": "The case as JSON",
  });
  private readonly copied = h("span", { class: "muted", role: "status" });
  private readonly sliders = new Sliders((apply) => this.change(apply));
  private readonly answers = new Answers(() => this.draw());
  private readonly hands: Hands;
  private readonly orbit: Orbit;

  constructor(
    private readonly counted: Counted,
    start: Setting | null,
  ) {
    // Before the orbit: who listens first can keep the rest from hearing.
    this.hands = new Hands(
      this.canvas,
      () => this.orbit.camera,
      () => this.lengthOfPixel(),
      (apply) => this.change(apply),
    );
    this.orbit = new Orbit(this.canvas, START, () => this.paint());
    this.orbit.camera.up.set(0, 0, 1);
    this.orbit.reset();
    const first = presets[0] as Preset;
    this.setting = start ?? this.placed(first);
    if (!start) this.sentence.textContent = first.says;
    theme.watch(() => this.draw());
  }

  private placed(preset: Preset): Setting {
    const setting = copyOf(preset.setting(this.counted.plumb));
    this.counted.forget();
    return setting;
  }

  private choose(preset: Preset): void {
    this.setting = this.placed(preset);
    this.sentence.textContent = preset.says;
    this.ask();
  }

  private change(apply: (setting: Setting) => void): void {
    apply(this.setting);
    this.sentence.textContent = "";
    this.ask();
  }

  /** However many changes come, a frame solves each method once. */
  private ask(): void {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame(() => this.frame());
  }

  frame(): void {
    this.isAsked = false;
    const before = performance.now();
    this.judged = judgeAll(this.counted.plumb, this.setting);
    this.counted.endFrame(performance.now() - before);
    this.sliders.show(this.setting, touchDistance(this.setting, this.judged));
    this.answers.show(this.judged);
    this.summary.textContent = this.inWords();
    this.json.value = caseOf(this.setting);
    this.draw();
    this.writeAddress();
    this.bounds.textContent = "";
    clearTimeout(this.boundsTimer);
    this.boundsTimer = window.setTimeout(() => this.bound(), BOUNDS_DELAY_MS);
  }

  private bound(): void {
    const auto = this.judged.find(({ method }) => method.name === "auto")?.contact;
    if (auto?.status !== "converged") return;
    const found = this.counted.plumb.bounds(pairOf(this.setting), auto);
    const names = outside(this.judged, found, this.setting).join(", ");
    this.bounds.textContent =
      `Proved by interval arithmetic: the lowest overlap is between ${found.lower} and ${found.upper}.` +
      (names ? ` Not there, and so wrong for sure: ${names}.` : "");
  }

  private inWords(): string {
    const auto = this.judged.find(({ method }) => method.name === "auto");
    if (auto?.contact.status !== "converged")
      return "auto has no answer here: it cannot show which normal is the lowest.";
    const asked = this.judged.filter(({ method }) => method.problem === "common_normal");
    const wrong = asked.filter(isWrong);
    const names = wrong.map(({ method }) => method.name).join(", ");
    return wrong.length === 0 ? "No method that asks for the common normal is wrong." : `Wrong: ${names}.`;
  }

  private draw(): void {
    if (!hasWebGl()) return;
    if (this.pictured) dispose(this.pictured.scene);
    const shown = this.judged.filter(({ method }) => !this.answers.hidden.has(method.name));
    this.pictured = picture(this.setting, shown, theme.value);
    this.canvas.dataset.drawn = "true";
    this.paint();
  }

  private paint(): void {
    if (this.pictured) renderTo(this.canvas, this.pictured, this.orbit.camera);
  }

  private lengthOfPixel(): number {
    const { camera } = this.orbit;
    const height = 2 * camera.position.length() * Math.tan((camera.fov * Math.PI) / 360);
    return ((this.pictured?.radius ?? 1) * height) / Math.max(1, this.canvas.clientHeight);
  }

  private writeAddress(): void {
    clearTimeout(this.addressTimer);
    this.addressTimer = window.setTimeout(
      () => history.replaceState(null, "", `#${wordOf(this.setting)}`),
      ADDRESS_DELAY_MS,
    );
  }

  /** A link that was followed within the page. */
  readAddress(): void {
    const setting = settingOf(location.hash.slice(1));
    if (!setting || wordOf(setting) === wordOf(this.setting)) return;
    this.setting = setting;
    this.sentence.textContent = "";
    this.ask();
  }

  private async copy(text: string, what: string): Promise<void> {
    try {
      await navigator.clipboard.writeText(text);
      this.copied.textContent = `${what} copied`;
    } catch {
      this.json.value = text;
      this.json.select();
      this.copied.textContent = "this browser does not let the page copy: it is selected, press Ctrl+C";
    }
  }

  private tools(): HTMLElement {
    const buttons = HOLDS.map(([hold, label]) => {
      const press = () => {
        this.hands.choose(hold);
        buttons.forEach((other, index) => other.setAttribute("aria-pressed", String(HOLDS[index]?.[0] === hold)));
      };
      return button(label, press, { class: "quiet", "aria-pressed": String(hold === "view"), "data-hold": hold });
    });
    const reset = button("Reset the view", () => this.orbit.reset(), { class: "quiet" });
    return h(
      "div",
      { class: "tools", role: "group", "aria-label": "What dragging and arrow keys do" },
      ...buttons,
      reset,
    );
  }

  private presetChoice(): HTMLElement {
    const names: [string, string][] = presets.map(({ name }, index) => [String(index), name]);
    const chosen = (value: string) => {
      const preset = presets[Number(value)];
      if (preset) this.choose(preset);
    };
    return select("Start from", [["", "choose a pair"], ...names], "", chosen);
  }

  element(): HTMLElement {
    const link = () => this.copy(`${location.href.split("#")[0]}#${wordOf(this.setting)}`, "link");
    const stage = hasWebGl() ? this.canvas : h("p", {}, "No 3-D view: this browser offers no WebGL. All else works.");
    return h(
      "main",
      {},
      h(
        "header",
        {},
        h("h1", {}, "plumb playground"),
        h(
          "p",
          {},
          "Two bodies, every method's contact, live. Turn, move and reshape them, and see who is wrong, and why.",
        ),
        h("div", { class: "bar" }, this.presetChoice(), themeButton()),
        this.sentence,
      ),
      h("section", { class: "stage", "aria-label": "View" }, stage, this.tools()),
      h(
        "section",
        { class: "results", "aria-labelledby": "answers-title" },
        h("h2", { id: "answers-title" }, "Answers"),
        this.summary,
        this.bounds,
        this.answers.element,
        h("p", { class: "muted" }, BESIDE),
      ),
      h(
        "section",
        { class: "settings", "aria-labelledby": "settings-title" },
        h("h2", { id: "settings-title" }, "The pair"),
        this.sliders.element,
      ),
      h(
        "section",
        { class: "case", "aria-labelledby": "case-title" },
        h("h2", { id: "case-title" }, "The case"),
        h("p", {}, "Save it as case.json, then: ", h("code", {}, "plumb solve case.json --method all")),
        this.json,
        h(
          "div",
          { class: "tools" },
          button("Copy the case", () => this.copy(caseOf(this.setting), "case")),
          button("Copy a link to it", link),
          this.copied,
        ),
      ),
    );
  }
}

const BESIDE =
  "Degrees off are between a method's normal and auto's. auto answers only where its own bounds show that its normal is the lowest. " +
  "The interval bounds share no code with the methods; plumb certify case.json proves more: where the normal is, and whether it is the only one. " +
  "A ball is the point of body 1, a box the point of body 2; the arrow is the normal.";

async function start(): Promise<void> {
  startTheme();
  const counted = new Counted(await load());
  meetMethods({ methods: counted.plumb.methods, runs: [], comparisons: [] } as unknown as Report);
  const playground = new Playground(counted, settingOf(location.hash.slice(1)));
  fill(document.getElementById("page") as HTMLElement, playground.element());
  playground.frame();
  addEventListener("hashchange", () => playground.readAddress());
  // Tests ask for what each preset promises.
  document.documentElement.dataset.presets = JSON.stringify(
    presets.map(({ name, says, shows }) => ({ name, says, shows })),
  );
  document.documentElement.dataset.ready = "true";
}

void start();
