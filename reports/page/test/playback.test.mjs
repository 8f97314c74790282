// Scenes played back, in Chromium and without: where bodies are between frames, what the player moves, what a reader is told.
import assert from "node:assert/strict";
import { test } from "node:test";
import { bring } from "./support/browser.mjs";
import { makeReport } from "./support/fixture.mjs";
import {
  makePlayback,
  makeSceneReport,
  playbackLines,
  playbackOf,
  withShapedWalls,
} from "./support/fixture-playback.mjs";
import { load } from "./support/modules.mjs";
import { withPage } from "./support/tab.mjs";

const pixels = (page) => page.$eval("#playback canvas", (canvas) => canvas.toDataURL());
const status = (page) => page.$eval("#playback .player-status", (line) => line.textContent);
const frameOf = async (page) => Number(/frame (\d+)/.exec(await status(page))[1]);
const changed = (page, old) =>
  page.waitForFunction(
    (was) => document.querySelector("#playback canvas").toDataURL() !== was,
    { timeout: 10000 },
    old,
  );

test("unpacked, a scene is where its lines say, to six digits", async () => {
  const { Frames } = await load("playback/frames.ts");
  const lines = playbackLines({ bodies: 12, frames: 9 });
  const playback = playbackOf(lines);
  const frames = new Frames(playback);
  const frame = 6;
  const { position, orientation, contacts } = lines[1 + frame];
  const x = new Float32Array(position.length);
  const q = new Float32Array(orientation.length);
  frames.positions({ frame, part: 0 }, x);
  frames.orientations({ frame, part: 0 }, q);
  position.forEach((value, i) => assert.ok(Math.abs(playback.origin[i % 3] + playback.size * x[i] - value) < 1e-5));
  orientation.forEach((value, i) => assert.ok(Math.abs(q[i] - value) < 1e-4));
  assert.equal(frames.contacts(frame), contacts.length);
  const at = { first: 0, second: 0, point: new Float32Array(3), normal: new Float32Array(3), force: 0 };
  contacts.forEach((contact, index) => {
    frames.contact(frame, index, at);
    assert.deepEqual([at.first, at.second], contact.slice(0, 2));
    const near = [...at.point].map((value, axis) => playback.origin[axis] + playback.size * value);
    near.forEach((value, axis) => assert.ok(Math.abs(value - contact[2 + axis]) < 1e-3));
    assert.ok(Math.abs(at.force * playback.contacts.largest_force - contact[9]) < 1e-2);
  });
});

test("between two frames a body goes straight and turns the shorter way", async () => {
  const { Frames } = await load("playback/frames.ts");
  const lines = playbackLines({ bodies: 1, frames: 2 });
  lines[1] = { ...lines[1], time: 1, position: [0, 0, 0], orientation: [1, 0, 0, 0] };
  const half = Math.sqrt(0.5);
  lines[2] = { ...lines[2], time: 3, position: [4, 0, 2], orientation: [-half, 0, 0, -half] };
  const playback = playbackOf(lines);
  const frames = new Frames(playback);
  const moment = frames.at(1.5);
  assert.deepEqual(moment, { frame: 0, part: 0.25 });
  const [x, q] = [new Float32Array(3), new Float32Array(4)];
  frames.positions(moment, x);
  frames.orientations(moment, q);
  assert.ok(Math.abs(x[0] * playback.size - 1) < 1e-6 && Math.abs(x[2] * playback.size - 0.5) < 1e-6);
  const angle = Math.PI / 4 / 4;
  [Math.cos(angle), 0, 0, Math.sin(angle)].forEach((part, i) => assert.ok(Math.abs(q[i] - part) < 1e-4, `${q}`));
  assert.deepEqual(
    [frames.at(0), frames.at(3), frames.at(9)].map(({ frame }) => frame),
    [0, 1, 1],
  );
});

test("a body that flies off does not make the others small", async () => {
  const { Frames } = await load("playback/frames.ts");
  const { extentOf } = await load("playback/extent.ts");
  const lines = playbackLines({ bodies: 200, frames: 5 });
  const far = lines.at(-2);
  far.position = far.position.map((value, i) => (i === 4 ? 1e9 : value));
  const playback = playbackOf(lines);
  const { half } = extentOf(playback, new Frames(playback));
  assert.ok(Math.max(...half) * playback.size < 100, `${half}`);
});

const shapedScene = (options) => playbackOf(withShapedWalls(playbackLines(options)));

test("a wall with a shape turns the shorter way, and planes alone have no orientations", async () => {
  const { Frames } = await load("playback/frames.ts");
  const scene = shapedScene({ bodies: 5, frames: 3 });
  const q = new Float32Array(4 * scene.walls.length);
  new Frames(scene).wallOrientations({ frame: 0, part: 0.5 }, q);
  const last = [...q.slice(-4)];
  [Math.cos(0.25), 0, 0, Math.sin(0.25)].forEach((part, i) => assert.ok(Math.abs(last[i] - part) < 1e-4, `${last}`));
  q.fill(7);
  new Frames(makePlayback({ bodies: 5, frames: 3 })).wallOrientations({ frame: 0, part: 0 }, q);
  assert.ok(q.every((part) => part === 7));
});

test("the view holds walls with a shape, but none beside which bodies are small", async () => {
  const { Frames } = await load("playback/frames.ts");
  const { extentOf } = await load("playback/extent.ts");
  const endsOf = (playback) => {
    const { centre, half } = extentOf(playback, new Frames(playback));
    const end = (sign) => centre.map((x, i) => playback.origin[i] + playback.size * (x + sign * half[i]));
    return [end(-1), end(1)];
  };
  const scene = shapedScene({ bodies: 5, frames: 3 });
  const [low, high] = endsOf(scene);
  const near = (x, y) => assert.ok(Math.abs(x - y) < 1e-3, `${x}, not ${y}`);
  near(low[2], -1);
  near(low[0], -2);
  // The box's corner after 0.4 rad.
  near(high[0], 4 + 0.5 * Math.cos(0.4) + Math.sin(0.4));
  scene.wall_shapes = scene.wall_shapes.map((shape) => shape && { half_extents: [100, 100, 100] });
  assert.ok(Math.max(...endsOf(scene)[1]) < 20);
});

test("round walls are closed where they say, and all surfaces reach as far as their numbers", async () => {
  const { linesOf, surfaceOf } = await load("view3d/wall_surface.ts");
  const { size, wall_shapes } = shapedScene({ bodies: 5, frames: 3 });
  const boxes = wall_shapes.slice(-4).map((shape) => {
    const surface = surfaceOf(shape);
    assert.ok(linesOf(shape, surface).getAttribute("position").count >= 8);
    surface.computeBoundingBox();
    const { min, max } = surface.boundingBox;
    return [min, max].map((end) => end.toArray().map((x) => Math.round(1e3 * size * x) / 1e3 + 0));
  });
  assert.deepEqual(boxes, [
    [
      [-2, -2, -1.5],
      [2, 2, 1.5],
    ],
    [
      [-2, -2, 0],
      [2, 2, 1],
    ],
    [
      [-0.5, -1, -0.25],
      [0.5, 1, 0.25],
    ],
    [
      [-1, 0, 0],
      [1, 0, 1],
    ],
  ]);
  const rows = (closed) => surfaceOf({ radii: [1, 2], heights: [0, 3], closed }).getAttribute("position").count / 97;
  assert.deepEqual([rows([false, false]), rows([true, false]), rows([true, true])], [2, 3, 4]);
});

test("walls of every shape are drawn, turn, and leave the bodies in sight", () =>
  withPage(makeSceneReport(shapedScene({ bodies: 8, frames: 5 })), {}, async (page, noticed) => {
    await bring(page, "#playback canvas");
    const first = await pixels(page);
    await page.click('#playback button[title="Last frame"]');
    await changed(page, first);
    await page.click("#playback .player-choices input");
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));

test("a wall whose file holds no numbers of it is not drawn, and the page says so", () => {
  const lines = withShapedWalls(playbackLines({ bodies: 5, frames: 3 }));
  const walls = lines[0].walls.map(({ normal, shape }) => (shape ? { normal, shape } : { normal }));
  const old = playbackOf([{ ...lines[0], walls }, ...lines.slice(1)]);
  assert.equal(old.wall_orientations, "");
  return withPage(makeSceneReport(old, makePlayback({ bodies: 5, frames: 3 })), {}, async (page, noticed) => {
    await bring(page, "#playback canvas");
    const captions = await page.$$eval("#playback .view-caption", (all) => all.map((line) => line.textContent));
    assert.match(captions[0], /Not drawn: 4 of 8 walls/);
    assert.doesNotMatch(captions[1], /Not drawn/);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});

test("it plays to the end and stops there", () =>
  withPage(makeSceneReport(makePlayback({ bodies: 5, frames: 5 })), {}, async (page, noticed) => {
    await bring(page, "#playback canvas");
    const first = await pixels(page);
    await page.select("#playback .player-choices label:nth-of-type(3) select", "4");
    await page.click('#playback button[title="Play"]');
    await changed(page, first);
    await page.waitForSelector('#playback button[title="Play"]', { timeout: 20000 });
    assert.equal(await frameOf(page), 5);
    const where = () => page.$eval("#playback .plot-mark", ({ hidden, style }) => (hidden ? null : style.left));
    await bring(page, "#playback .plot");
    const end = await where();
    await page.click('#playback button[title="First frame"]');
    assert.equal(await frameOf(page), 1);
    assert.notEqual(await where(), end);
    assert.deepEqual(noticed, { console: [], requests: [] });
  }));

test("keys step, play and turn", () =>
  withPage(makeSceneReport(makePlayback({ bodies: 5, frames: 21 })), {}, async (page) => {
    const canvas = await bring(page, "#playback canvas");
    await page.focus("#playback input[type=range]");
    const frames = [];
    for (const key of ["ArrowRight", "ArrowRight", "ArrowLeft", "PageUp", "End", "ArrowRight", "Home"]) {
      await page.keyboard.press(key);
      frames.push(await frameOf(page));
    }
    assert.deepEqual(frames, [2, 3, 2, 12, 21, 21, 1]);
    const text = await page.$eval("#playback input[type=range]", (slider) => slider.getAttribute("aria-valuetext"));
    assert.equal(text, "t = 0, frame 1 of 21");
    await canvas.focus();
    await page.keyboard.press(".");
    assert.equal(await frameOf(page), 2);
    const before = await pixels(page);
    await page.keyboard.press("ArrowLeft");
    await changed(page, before);
    await page.keyboard.press("Space");
    await page.waitForSelector('#playback button[title="Pause"]');
    await page.keyboard.press("Space");
    await page.waitForSelector('#playback button[title="Play"]');
  }));

test("contacts and colours are drawn, and the scale says what they mean", () =>
  withPage(makeSceneReport(makePlayback({ bodies: 30, frames: 11 })), {}, async (page) => {
    await bring(page, "#playback canvas");
    await page.click('#playback button[title="Last frame"]');
    const key = () => page.$eval("#playback .scale-key", (line) => line.textContent);
    for (const [colouring, words] of [
      ["speed", /^0\S+ and more$/],
      ["contacts", /^0\d+ contacts$/],
      ["body", /grey ones are fixed/],
    ]) {
      const before = await pixels(page);
      await page.select("#playback .player-choices select", colouring);
      await changed(page, before);
      assert.match(await key(), words);
    }
    const bare = await pixels(page);
    await page.click("#playback .player-choices input");
    await changed(page, bare);
  }));

test("a scene whose effects use the patch shows it, and no other does", () => {
  const plain = makePlayback({ bodies: 5, frames: 3 });
  const patched = { ...plain, effects: [{ name: "foundation", on: true, why: "asked for" }] };
  return withPage(makeSceneReport(patched, plain), {}, async (page, noticed) => {
    const captions = await page.$$eval("#playback .view-caption", (all) => all.map((line) => line.textContent));
    assert.deepEqual(
      captions.map((words) => /patch/.test(words)),
      [true, false],
    );
    await bring(page, "#playback canvas");
    await page.click('#playback button[title="Last frame"]');
    const bare = await pixels(page);
    await page.click("#playback .player-choices input");
    await changed(page, bare);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});

test("a scene's end, its effects and what a table says", () =>
  withPage(makeSceneReport(makePlayback({ bodies: 5, frames: 6 })), {}, async (page) => {
    const text = await page.$eval("#playback", (part) => part.textContent.replaceAll("\u202f", " "));
    assert.match(text, /0 of 1 234 567 solves failed/);
    assert.match(text, /0123456789abcdef/);
    assert.match(text, /rolling resistanceoffno coefficient is given/);
    assert.match(text, /slerp/);
    await page.$eval("#playback details", (closed) => {
      closed.open = true;
    });
    const rows = await page.waitForSelector("#playback details tbody");
    assert.equal(await rows.evaluate((body) => body.children.length), 6);
  }));

test("of scenes alone the page has no section of campaigns, and one that did not end is announced", () => {
  const report = makeSceneReport(makePlayback({ bodies: 5, frames: 3 }), makePlayback({ name: "cut", ended: false }));
  return withPage(report, {}, async (page, noticed) => {
    const sections = await page.$$eval("main > section", (all) => all.map(({ id }) => id));
    assert.deepEqual(sections, ["playback", "machine"]);
    assert.match(await page.$eval('[role="alert"]', (alarm) => alarm.textContent), /scene cut is incomplete/);
    assert.match(
      await page.$eval("#playback article:nth-of-type(2) .verdict", (line) => line.textContent),
      /Incomplete/,
    );
    assert.equal(await page.$eval(".files", (list) => list.children.length), 2);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});

test("beside campaigns it is one section more", () =>
  withPage(
    makeReport({ failures: 2, cases: 100, second: true, playbacks: [makePlayback({ bodies: 5, frames: 3 })] }),
    {},
    async (page, noticed) => {
      await bring(page, "#playback canvas");
      const sections = await page.$$eval("main > section", (all) => all.map(({ id }) => id));
      assert.ok(sections.includes("answer") && sections.includes("playback") && sections.includes("compare"));
      assert.deepEqual(noticed, { console: [], requests: [] });
    },
  ));

test("a scene that writes bulk has a figure of its packing, and no other has", () => {
  const lines = playbackLines({ bodies: 5, frames: 6 });
  const bare = playbackOf(
    lines.map(({ bulk, ...line }) => line),
    "bare",
  );
  return withPage(makeSceneReport(playbackOf(lines), bare), {}, async (page, noticed) => {
    const figures = (nth) =>
      page.$$eval(`#playback article:nth-of-type(${nth}) figcaption`, (all) =>
        all.map((caption) => caption.textContent),
      );
    assert.deepEqual(await figures(2), ["Energy against time"]);
    assert.deepEqual(await figures(1), ["Energy against time", "Packing against time"]);
    await bring(page, "#playback article:nth-of-type(1) figure:nth-of-type(2) .plot");
    const words = await page.$eval("#playback article:nth-of-type(1)", (part) => part.innerHTML);
    assert.match(words, /packing fraction from 0\D?2 to 0\D?6/);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});

test("a single frame of one body, without walls, contacts or energy", () => {
  const lines = playbackLines({ bodies: 1, frames: 1 });
  Object.assign(lines[0], { walls: [], effects: [] });
  Object.assign(lines[1], { wall: [], contacts: [], energy: {}, bulk: {} });
  return withPage(makeSceneReport(playbackOf(lines)), {}, async (page, noticed) => {
    await bring(page, "#playback canvas");
    await page.click('#playback button[title="Play"]');
    await page.click("#playback .player-choices input");
    assert.equal(await frameOf(page), 1);
    assert.deepEqual(noticed, { console: [], requests: [] });
  });
});

test("paper shows the last frame, the screen then the one before", () =>
  withPage(makeSceneReport(makePlayback({ bodies: 5, frames: 7 })), {}, async (page) => {
    await bring(page, "#playback canvas");
    await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
    assert.equal(await frameOf(page), 7);
    await page.evaluate(() => dispatchEvent(new Event("afterprint")));
    assert.equal(await frameOf(page), 1);
  }));
