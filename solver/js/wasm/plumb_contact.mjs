// Loads plumb's methods and puts words to the block of doubles that block.hpp describes.
import { wasm } from "./plumb_wasm.mjs";

const PER_BODY = 12;
const INPUTS = 2 * PER_BODY + 3;
const OUTPUTS = 34;
const NORMAL = 3;
const BOUNDS = 32;
const MOST_CELLS = 10_000;
const FAILS = ["signs", "z", "both", "nothing"];
const FIELDS = ["name", "problem", "published_by", "summary", "light", "dark", "symbol"];

const bytesOf = (base64) => Uint8Array.from(atob(base64), (letter) => letter.charCodeAt(0));

function numbersOf(values, count, name) {
  if (values?.length !== count) throw new TypeError(`${name} must be ${count} numbers`);
  return [...values];
}

function writeBody(block, index, { semi_axes, exponents = [2, 2], position = [0, 0, 0], quaternion = [1, 0, 0, 0] }) {
  const name = `bodies[${index}]`;
  const all = [
    ...numbersOf(semi_axes, 3, `${name}.semi_axes`),
    ...numbersOf(exponents, 2, `${name}.exponents`),
    ...numbersOf(position, 3, `${name}.position`),
    ...numbersOf(quaternion, 4, `${name}.quaternion`),
  ];
  block.set(all, index * PER_BODY);
}

function writePair(block, { bodies, motion = [0, 0, 0] }) {
  if (bodies?.length !== 2) throw new TypeError("bodies must be two");
  bodies.forEach((body, index) => writeBody(block, index, body));
  block.set(numbersOf(motion, 3, "motion"), 2 * PER_BODY);
}

const three = (block, from) => [block[from], block[from + 1], block[from + 2]];

const diagnosisOf = (out) => ({
  residues: [...out.subarray(17, 22)],
  angles_deg: { d_n1: out[22], d_n2: out[23], n1_n2: out[24] },
  normals: [three(out, 25), three(out, 28)],
  fails: FAILS[out[31]],
});

class Plumb {
  #door;
  #block;
  #index;

  constructor(door) {
    this.#door = door;
    this.#block = new Float64Array(door.memory.buffer, door.plumb_js_block(), INPUTS + OUTPUTS);
    this.methods = Array.from({ length: door.plumb_js_count() }, (_, index) =>
      Object.fromEntries(FIELDS.map((field, at) => [field, this.#text(door.plumb_js_text(index, at))])),
    );
    this.#index = new Map(this.methods.map(({ name }, index) => [name, index]));
  }

  #text(from) {
    const bytes = new Uint8Array(this.#door.memory.buffer);
    return new TextDecoder().decode(bytes.subarray(from, bytes.indexOf(0, from)));
  }

  solve(pair, { method = "auto", diagnosed = false, iteration_limit = 100, tolerance = 0 } = {}) {
    const index = this.#index.get(method);
    if (index === undefined) throw new RangeError(`there is no method ${method}`);
    if (!(Number.isInteger(iteration_limit) && iteration_limit > 0 && iteration_limit < 2 ** 31))
      throw new RangeError("iteration_limit must be a whole number above 0");
    if (!(tolerance >= 0 && tolerance < Infinity)) throw new RangeError("tolerance must be finite and not below 0");
    writePair(this.#block, pair);
    this.#door.plumb_js_solve(index, diagnosed ? 1 : 0, iteration_limit, tolerance);
    const out = this.#block.subarray(INPUTS);
    const contact = {
      method,
      status: this.#text(this.#door.plumb_js_status(out[0])),
      verdict: this.#text(this.#door.plumb_js_verdict(out[1])),
      overlap: out[2],
      normal: three(out, 3),
      points: [three(out, 6), three(out, 9)],
      contact_point: three(out, 12),
      iterations: out[15],
      evaluations: out[16],
    };
    if (diagnosed && out[0] === 0) contact.diagnosis = diagnosisOf(out);
    return contact;
  }

  bounds(pair, { status, normal, points }, { cells = 2000 } = {}) {
    if (!(Number.isInteger(cells) && cells > 0 && cells <= MOST_CELLS))
      throw new RangeError(`cells must be a whole number from 1 to ${MOST_CELLS}`);
    if (status !== "converged") throw new RangeError("bounds are about a contact that converged");
    const wrong = this.describeInput(pair);
    if (wrong !== "") throw new RangeError(wrong);
    const out = this.#block.subarray(INPUTS);
    out.set([...normal, ...points.flat()], NORMAL);
    this.#door.plumb_js_bound(cells);
    return { lower: out[BOUNDS], upper: out[BOUNDS + 1] };
  }

  describeInput(pair) {
    writePair(this.#block, pair);
    const reason = this.#text(this.#door.plumb_js_input_error(1));
    if (reason === "") return "";
    const body = this.#door.plumb_js_input_body();
    const field = this.#text(this.#door.plumb_js_input_error(0));
    return `${body < 0 ? "" : `bodies[${body}].`}${field}: ${reason}`;
  }
}

let loaded;

async function instantiate() {
  const module = await WebAssembly.compile(bytesOf(wasm));
  // What the C library would ask a system for; no method ever calls it.
  const missing = () => {
    throw new Error("plumb asked for a system call");
  };
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = missing;
  const { exports } = await WebAssembly.instantiate(module, imports);
  exports._initialize?.();
  return new Plumb(exports);
}

export const load = () => (loaded ??= instantiate());
