/** One WebGL context for all cards; each card gets a copy of the picture, and its labels, on a canvas of its own. */
import { type PerspectiveCamera, Vector3, WebGLRenderer } from "three";
import { ink } from "../theme";
import type { Label, Pictured } from "./scene";

let renderer: WebGLRenderer | null = null;
let refused = false;

export function hasWebGl(): boolean {
  if (renderer || refused) return !refused;
  try {
    // three reports a missing context on the console; asking first keeps that quiet.
    const probe = document.createElement("canvas").getContext("webgl2");
    if (!probe) throw new Error("no WebGL 2");
    probe.getExtension("WEBGL_lose_context")?.loseContext();
    renderer = new WebGLRenderer({ antialias: true, alpha: true, preserveDrawingBuffer: true });
    renderer.setPixelRatio(1);
  } catch {
    refused = true;
  }
  return !refused;
}

interface Box {
  x: number;
  y: number;
  width: number;
}

const LINE = 15;

const collides = (a: Box, b: Box): boolean =>
  Math.abs(a.y - b.y) < LINE && a.x < b.x + b.width + 4 && b.x < a.x + a.width + 4;

/** Near its point, above or below where others already stand. */
function freeBox(context: CanvasRenderingContext2D, label: Label, x: number, y: number, taken: Box[]): Box {
  const width = context.measureText(label.text).width;
  const { clientWidth, clientHeight } = context.canvas;
  const wanted = label.side === "left" ? x - 10 - width : x + 10;
  const left = Math.max(3, Math.min(clientWidth - width - 3, wanted));
  for (const shift of [0, -LINE, LINE, -2 * LINE, 2 * LINE, -3 * LINE, 3 * LINE]) {
    const box = { x: left, y: Math.max(LINE, Math.min(clientHeight - 8, y + shift)), width };
    if (!taken.some((other) => collides(box, other))) return box;
  }
  return { x: left, y, width };
}

function drawLabels(context: CanvasRenderingContext2D, labels: Label[], camera: PerspectiveCamera): void {
  const { clientWidth, clientHeight } = context.canvas;
  const taken: Box[] = [];
  context.font = "600 12.5px system-ui, sans-serif";
  context.textBaseline = "middle";
  context.lineJoin = "round";
  context.lineWidth = 3.5;
  context.strokeStyle = ink().paper;
  for (const label of labels) {
    const seen = new Vector3(...label.at).project(camera);
    if (seen.z > 1 || Math.abs(seen.x) > 1.02 || Math.abs(seen.y) > 1.02) continue;
    const box = freeBox(context, label, ((seen.x + 1) / 2) * clientWidth, ((1 - seen.y) / 2) * clientHeight, taken);
    taken.push(box);
    context.strokeText(label.text, box.x, box.y);
    context.fillStyle = label.colour;
    context.fillText(label.text, box.x, box.y);
  }
}

/** To set a size clears and allocates, even where it is the same. */
function resize(canvas: HTMLCanvasElement, width: number, height: number, set: () => void): void {
  if (canvas.width !== width || canvas.height !== height) set();
}

export function renderTo(
  canvas: HTMLCanvasElement,
  { scene, labels }: Pick<Pictured, "scene" | "labels">,
  camera: PerspectiveCamera,
): void {
  const context = canvas.getContext("2d");
  const { clientWidth, clientHeight } = canvas;
  if (!renderer || !context || clientWidth === 0) return;
  const shared = renderer;
  const density = Math.min(2, Math.max(1, devicePixelRatio));
  const [width, height] = [Math.round(clientWidth * density), Math.round(clientHeight * density)];
  resize(canvas, width, height, () => Object.assign(canvas, { width, height }));
  resize(shared.domElement, width, height, () => shared.setSize(width, height, false));
  camera.aspect = clientWidth / clientHeight;
  camera.updateProjectionMatrix();
  shared.render(scene, camera);
  context.setTransform(1, 0, 0, 1, 0, 0);
  context.clearRect(0, 0, width, height);
  context.drawImage(shared.domElement, 0, 0);
  context.scale(density, density);
  drawLabels(context, labels, camera);
}
