/** Where to start: the study's four groups, and the simplest failures. Each says what is to be seen, and of whom. */
import type { Plumb } from "../../plumb-contact/plumb_contact.mjs";
import type { Vec } from "../../page/src/data";
import { judgeAll, type Kind, touchDistance } from "./judge";
import type { Setting, Solid } from "./pair";

export interface Preset {
  name: string;
  /** What is to be seen, in a sentence. */
  says: string;
  /** The same for a test: what the method's row must be. */
  shows: { method: string; kind: Kind };
  setting: (plumb: Plumb) => Setting;
}

/** Lines of reports/results/study.jsonl. */
interface Group {
  group: string;
  fails: "signs" | "z" | "both" | "nothing";
  aspect: number;
  theta_L_deg: number;
  phi_L_deg: number;
  euler_deg: Vec;
}

/** Lines of failures.jsonl. */
interface Failure {
  name: string;
  says: string;
  method: string;
  kind: Kind;
  solids: [Solid, Solid];
  line_deg: [number, number];
  distance: number;
}

/** Put in by build.mjs. */
declare const PRESET_DATA: { groups: Group[]; failures: Failure[] };

const RATIO = 0.01;

/** At an overlap ratio, whatever the distance was. */
export function placed(plumb: Plumb, setting: Setting, ratio: number): Setting {
  const apart = {
    ...setting,
    distance: 1.05 * (Math.max(...setting.solids[0].axes) + Math.max(...setting.solids[1].axes)),
  };
  const touch = touchDistance(apart, judgeAll(plumb, apart));
  return { ...setting, distance: touch * (1 - ratio) };
}

const FAILS: Record<Group["fails"], [Kind, string]> = {
  signs: ["signs", "original_cn's answer is no common normal: an absolute value in its equations has lost a sign."],
  z: ["z", "original_cn's answer is no common normal: nothing in its equations asks for z."],
  both: ["both", "original_cn's answer is no common normal: a sign is lost, and z is not asked for."],
  nothing: ["right", "here original_cn finds the common normal."],
};

function ofGroup({ group, fails, aspect, theta_L_deg, phi_L_deg, euler_deg }: Group): Preset {
  const solid = (euler: Vec): Solid => ({ axes: [1, 1, aspect], exponents: [2, 2], euler });
  const [kind, says] = FAILS[fails];
  const bed: Setting = { solids: [solid([0, 0, 0]), solid(euler_deg)], line: [theta_L_deg, phi_L_deg], distance: 0 };
  return {
    name: group,
    says: `${group} of the study, overlap ratio ${RATIO}: ${says}`,
    shows: { method: "original_cn", kind },
    setting: (plumb) => placed(plumb, bed, RATIO),
  };
}

const ofFailure = ({ name, says, method, kind, solids, line_deg, distance }: Failure): Preset => ({
  name,
  says,
  shows: { method, kind },
  setting: () => ({ solids, line: line_deg, distance }),
});

export const presets: Preset[] = [...PRESET_DATA.failures.map(ofFailure), ...PRESET_DATA.groups.map(ofGroup)];
