/** The source's study: ways to define and to find a contact between two bodies. */
import { command } from "../../commands";
import type { Report, Study } from "../../data";
import { type Child, h, section } from "../../dom";
import { madeBy } from "../../made";
import { onMachine } from "../../numbers";
import { anglesBlock, groupsBlock } from "./study_groups";
import { limitsBlock, ordersBlock } from "./study_limits";
import { mapsBlock, sharesBlock } from "./study_maps";
import { costsBlock, rootsBlock } from "./study_roots";

const QUESTION =
  "Which contact do the published ways define, which do they find, and how far is it from the common normal?";

const WHAT =
  "Kildashti, Dong and Samali (Powder Technology, 2018) showed that the six equations by which Lin and Ng find the common normal of two bodies have solutions that are none: absolute values lose the signs, and the z components are never asked for. The residues R1 and R2 then vanish, R3 to R5 do not. Here that comparison is made again, and continued: every method on groups of spheroids (G) and superquadrics (S), each answer held against a certified common normal. The pairs are our own, in the source's terms: drawn until the original equations fail in the way of the group.";

function origin({ host, commit, interrupted, command: text }: Study): Child[] {
  return [
    h("p", { class: "note" }, `Made at commit ${commit}${onMachine(host)}${interrupted ? " (interrupted)" : ""}:`),
    command(text),
  ];
}

export function studySection({ study }: Report): HTMLElement | null {
  if (!study) return null;
  const parts = [
    h("p", { class: "what" }, WHAT),
    ...madeBy(study.command, [
      ["the groups", groupsBlock(study.groups)],
      ["the angles", anglesBlock(study.groups)],
      ["the maps", mapsBlock(study.maps)],
      ["the shares", sharesBlock(study.shares)],
      ["the limits", limitsBlock(study.limits)],
      ["the orders", ordersBlock(study.orders)],
      ["the roots", rootsBlock(study.roots)],
      ["the costs", costsBlock(study.costs)],
    ]),
    ...origin(study),
  ];
  return section("study", "The source's study", QUESTION, ...parts);
}
