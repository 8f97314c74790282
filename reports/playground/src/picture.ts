/** Both bodies, and of each method its points and its normal, in its colour. The world's axes; a ball of radius 1 holds both bodies. */
import { BoxGeometry, SphereGeometry } from "three";
import type { Vec } from "../../page/src/data";
import { colourOf } from "../../page/src/methods";
import type { Theme } from "../../page/src/theme";
import { type Mapping, wholeMesh } from "../../page/src/view3d/mesh";
import { around, type Placed } from "../../page/src/view3d/placed";
import { arrow, bodyGroup, COLOURS, litScene, marker, type Pictured } from "../../page/src/view3d/scene";
import { add, divide, length, scale, subtract, turnOf, unit } from "../../page/src/view3d/vector";
import { isWrong, type Judged } from "./judge";
import { positionOf, type Setting } from "./pair";
import { quaternionOf } from "./rotation";

const NORMAL = 0.55;
const POINT = 0.022;
/** Shorter ones would be all head. */
const SHORTEST_LINK = 0.03;

export function solidsOf(setting: Setting): [Placed, Placed] {
  const centres: [Vec, Vec] = [[0, 0, 0], positionOf(setting)];
  return setting.solids.map(({ axes, exponents, euler }, index) => ({
    axes,
    exponents,
    turn: turnOf(quaternionOf(euler)),
    centre: centres[index] as Vec,
  })) as [Placed, Placed];
}

export function picture(setting: Setting, judged: Judged[], theme: Theme): Pictured {
  const bodies = solidsOf(setting);
  const { centre, radius } = around(bodies, []);
  const mapping: Mapping = { point: (x) => divide(subtract(x, centre), radius), direction: (x) => x };
  const scene = litScene();
  const labels: Pictured["labels"] = [];
  const { first, second, link } = COLOURS[theme];
  bodies.forEach((body, index) => {
    const colour = index === 0 ? first : second;
    scene.add(bodyGroup(wholeMesh(body, mapping), colour, index === 1));
    labels.push({
      text: `body ${index + 1}`,
      at: mapping.point(body.centre),
      colour,
      side: index === 0 ? "left" : "right",
    });
  });
  // Those that are right lie on each other: auto is drawn last, and alone of them has a name.
  for (const one of [...judged].reverse()) {
    const { contact, method } = one;
    if (contact.status !== "converged") continue;
    const colour = colourOf(method.name);
    const [p1, p2] = contact.points.map(mapping.point) as [Vec, Vec];
    scene.add(marker(new SphereGeometry(POINT, 14, 10), p1, colour));
    scene.add(marker(new BoxGeometry(1.6 * POINT, 1.6 * POINT, 1.6 * POINT), p2, colour));
    scene.add(arrow(p1, contact.normal, NORMAL, colour, 0.009));
    const d = subtract(p2, p1);
    if (length(d) > SHORTEST_LINK) scene.add(arrow(p1, unit(d), length(d), link, 0.005));
    if (isWrong(one) || method.name === "auto")
      labels.push({ text: method.name, at: add(p1, scale(contact.normal, NORMAL + 0.04)), colour, side: "right" });
  }
  return { scene, labels, radius };
}
