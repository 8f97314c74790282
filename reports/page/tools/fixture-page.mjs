// node tools/fixture-page.mjs FILE.html: the made-up report with two runs, a study and finite elements, to look at.
import { makeReport } from "../test/support/fixture.mjs";
import { makeFem } from "../test/support/fixture-fem.mjs";
import { makeStudy } from "../test/support/fixture-study.mjs";
import { writePage } from "../test/support/pages.mjs";

const [file] = process.argv.slice(2);
if (!file) throw new Error("usage: npm run fixture -- FILE.html");
console.log(await writePage(makeReport({ second: true, study: makeStudy(), fem: makeFem() }), file));
