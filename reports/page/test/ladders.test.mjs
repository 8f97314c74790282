// The hard cases, ladder by ladder, in Chromium: what a strip shows is what the document holds.
import assert from "node:assert/strict";
import { test } from "node:test";
import { makeReport } from "./support/fixture.mjs";
import { withPage as withReport } from "./support/tab.mjs";

const report = makeReport({ failures: 1, cases: 1000, precision: false });
const { ladders } = report.runs[0];

const withPage = (use) => withReport(report, {}, use);

const plain = (text) => text.replaceAll("\u200b", "");
const texts = async (page, selector) =>
  (await page.$$eval(selector, (all) => all.map((one) => one.textContent))).map(plain);
const wordsOf = (row, steps) =>
  row.lets_go === null ? /^holds / : new RegExp(`step ${row.lets_go} of ${steps.length}(misaligned|nonconverged)$`);

test("every strip has a rung for each step, and says where its method lets go", () =>
  withPage(async (page, noticed) => {
    const shown = await page.$$eval("#ladders .ladder", (all) =>
      all.map((ladder) => ({
        name: ladder.querySelector("h4").firstChild.textContent,
        rows: [...ladder.querySelectorAll("tbody tr")].map((row) => ({
          words: row.querySelector("td").textContent,
          rungs: [...row.querySelectorAll(".rung")].map((rung) => rung.getAttribute("aria-label")),
          first: [...row.querySelectorAll(".rung")].findIndex((rung) => rung.classList.contains("first")),
        })),
      })),
    );
    assert.deepEqual(
      shown.map(({ name }) => plain(name)),
      ladders.map(({ name }) => name),
    );
    shown.forEach(({ rows }, i) => {
      const { steps, methods } = ladders[i];
      rows.forEach(({ words, rungs, first }, k) => {
        assert.match(words, wordsOf(methods[k], steps));
        assert.equal(rungs.length, steps.length);
        assert.equal(first, (methods[k].lets_go ?? 0) - 1);
        rungs.forEach((rung, step) => assert.match(rung, new RegExp(`\\(step ${step + 1} of ${steps.length}\\)`)));
      });
    });
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));

test("wrong and lost are two colours and two figures", () =>
  withPage(async (page) => {
    const both = ladders
      .flatMap(({ methods }) => methods)
      .flatMap((row) => row.judged.map((_, step) => row.wrong[step] > 0 && row.lost[step] > 0))
      .filter(Boolean).length;
    const rungs = await page.$$eval(
      "#ladders .ladder .rung",
      (all) => all.filter((rung) => rung.querySelector("i") && rung.querySelector("span")).length,
    );
    assert.equal(rungs, both);
  }));

test("a method's box hides its strips, and the order follows a method", () =>
  withPage(async (page) => {
    const before = (await texts(page, "#ladders .ladder tbody th")).filter((name) => name.startsWith("new_cn")).length;
    assert.equal(before, ladders.length);
    await page.$eval("#ladders .legend label:nth-of-type(2) input", (box) => box.click());
    const after = (await texts(page, "#ladders .ladder tbody th")).filter((name) => name.startsWith("new_cn")).length;
    assert.equal(after, 0);
    await page.select("#ladders .controls select", "corrected_cn");
    const held = ({ methods, steps }) =>
      (methods.find(({ method }) => method === "corrected_cn").lets_go - 1) / steps.length;
    const least = Math.min(...ladders.map(held));
    const [first] = await texts(page, "#ladders .ladder h4");
    assert.equal(held(ladders.find(({ name }) => first.startsWith(`${name} `))), least);
  }));

test("the other arithmetics say of how many cases auto is right, and flag where it is not", () =>
  withPage(async (page) => {
    const verdict = await page.$eval("#ladders .verdict", (line) => line.textContent);
    for (const { method, arithmetic, right, cases } of report.stability.totals)
      if (method === "auto") assert.ok(verdict.includes(`in ${arithmetic} ${right} of ${cases}`), verdict);
    const wrong = report.stability.ladders
      .flatMap(({ rows }) => rows)
      .filter((row) => row.method === "auto" && row.wrong.some((n) => n > 0)).length;
    assert.ok(wrong > 0);
    assert.equal((await texts(page, "#ladders .flag.wrong")).length, wrong);
  }));
