// npm run playback -- FILE.html [BODIES] [FRAMES]: made-up scenes, one that ended and one that did not, to look at.
import { makePlayback, makeSceneReport } from "../test/support/fixture-playback.mjs";
import { writePage } from "../test/support/pages.mjs";

const [file, bodies = "200", frames = "201"] = process.argv.slice(2);
if (!file) throw new Error("usage: npm run playback -- FILE.html [BODIES] [FRAMES]");
const pile = makePlayback({ bodies: Number(bodies), frames: Number(frames) });
const short = makePlayback({ name: "cut-short", scene: "hopper", bodies: 12, frames: 9, ended: false });
console.log(await writePage(makeSceneReport(pile, short), file));
