/** The sections in their order: all that the page, its navigation and its head know of each. */
import type { Report } from "../data";
import { fold } from "../dom";
import type { State } from "../state";
import { answerSection } from "./answer";
import { atlasSection } from "./atlas";
import { compareSection } from "./compare/compare";
import { familiesSection } from "./families";
import { femSection } from "./fem/fem";
import { femLine } from "./fem/fem_words";
import { gallerySection } from "./gallery";
import { laddersSection } from "./ladders/ladders";
import { machineSection } from "./machine";
import { playbackLines, playbackSection } from "./playback";
import { precisionSection } from "./precision";
import { studySection } from "./study/study";
import { studyLine } from "./study/study_words";

interface Section {
  /** In the navigation. */
  name: string;
  /** Without it there is always something to show. */
  shows?: (report: Report) => unknown;
  make: (state: State) => HTMLElement | null;
  /** Open from the start; of a campaign's page the others are folded. */
  isOpen?: boolean;
  /** It says where the others come from, and is nothing by itself. */
  isAbout?: boolean;
  /** What the head says of its data. */
  lines?: (report: Report) => string[];
  /** What the head calls it where Ctrl-C cut it short. */
  cutShort?: (report: Report) => string | false | undefined;
}

const isCampaign = ({ runs }: Report): boolean => runs.length > 0;

export const SECTIONS: Section[] = [
  { name: "Answer", shows: isCampaign, make: answerSection, isOpen: true },
  { name: "Failures", shows: isCampaign, make: gallerySection, isOpen: true },
  { name: "Compare", make: compareSection },
  { name: "Families", shows: isCampaign, make: familiesSection },
  { name: "Ladders", make: laddersSection },
  { name: "Atlas", shows: isCampaign, make: atlasSection },
  { name: "Precision", make: precisionSection },
  {
    name: "Study",
    make: ({ report }) => studySection(report),
    lines: ({ study }) => (study ? [studyLine(study)] : []),
    cutShort: ({ study }) => study?.interrupted && "study",
  },
  {
    name: "Elements",
    make: ({ report }) => femSection(report),
    lines: ({ fem }) => (fem ? [femLine(fem)] : []),
    cutShort: ({ fem }) => fem?.interrupted && "finite element study",
  },
  { name: "Playback", make: ({ report }) => playbackSection(report), lines: playbackLines },
  { name: "Machine", make: machineSection, isAbout: true },
];

export interface Part {
  name: string;
  element: HTMLElement;
  isAbout: boolean;
}

/** Those that have something to show. */
export const partsOf = (state: State): Part[] =>
  SECTIONS.flatMap(({ name, shows, make, isOpen = false, isAbout = false }) => {
    const element = !shows || shows(state.report) ? make(state) : null;
    if (!element) return [];
    if (isCampaign(state.report) && !isOpen) fold(element);
    return [{ name, element, isAbout }];
  });
