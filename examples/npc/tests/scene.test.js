/** The scene in Chromium, with a service of its own: who speaks moves in time with the voice, who listens nods. */

import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { mkdtemp } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { chromium } from "playwright-core";

import { optionsFrom, startGame } from "../server/game.js";

/** @import { Browser, Page } from "playwright-core" */

const FLAGS = [
  "--headless",
  "--no-sandbox",
  "--disable-gpu",
  "--disable-quic",
  "--no-first-run",
  "--disable-background-networking",
  "--use-angle=swiftshader",
  "--enable-unsafe-swiftshader",
];
const PATIENCE_MS = 120_000;

const executablePath = [process.env["CHROMIUM"], "/usr/bin/chromium", "/usr/bin/chromium-browser", "/usr/bin/google-chrome"].find(
  (path) => path !== undefined && existsSync(path),
);
const options = optionsFrom({ PORT: "0", ...process.env });
const missing =
  executablePath === undefined
    ? "no Chromium is installed, and CHROMIUM names none"
    : existsSync(options.command[0])
      ? false
      : "understudy is not installed: run make perform";

/**
 * @typedef {object} Sample what a frame shows
 * @property {number} voiceS
 * @property {number[]} hands
 * @property {number} jaw
 * @property {number} listenerPitch
 */

describe("the scene in a browser", { skip: missing }, () => {
  /** @type {Awaited<ReturnType<typeof startGame>>} */
  let game;
  /** @type {Browser} */
  let browser;
  /** @type {Page} */
  let page;
  /** @type {string[]} */
  const faults = [];
  /** @type {string[]} */
  const elsewhere = [];

  before(async () => {
    game = await startGame({ ...options, port: 0, cacheFolder: await mkdtemp(join(tmpdir(), "npc-scene-")) });
    browser = await chromium.launch({ executablePath: executablePath ?? "", args: FLAGS });
    page = await browser.newPage({ viewport: { width: 480, height: 300 } });
    page.setDefaultTimeout(PATIENCE_MS);
    page.on("pageerror", (error) => faults.push(error.message));
    page.on("request", (request) => {
      if (!request.url().startsWith(game.url) && !request.url().startsWith("blob:") && !request.url().startsWith("data:")) {
        elsewhere.push(request.url());
      }
    });
    await page.goto(game.url);
    await page.getByRole("button").first().waitFor();
  });
  after(async () => {
    await browser.close();
    await game.stop();
  });

  /** Asks, and returns what each frame shows from the first sound to the last. */
  async function asked(/** @type {string} */ question) {
    await page.evaluate(() => {
      const { figures } = /** @type {any} */ (globalThis);
      const voice = /** @type {HTMLAudioElement} */ (document.querySelector("#voice"));
      /** @type {Sample[]} */
      const samples = [];
      Object.assign(globalThis, { samples });
      const look = () => {
        if (!voice.paused) {
          const hands = [...figures.speaker.place("leftHand"), ...figures.speaker.place("rightHand")];
          const [jaw, listenerPitch] = [figures.speaker.weight("jawOpen"), figures.listener.pitch("head")];
          samples.push({ voiceS: voice.currentTime, hands, jaw, listenerPitch });
        }
        requestAnimationFrame(look);
      };
      look();
    });
    await page.getByRole("button", { name: question }).click();
    await page.waitForFunction(() => document.querySelector("#voice")?.matches(":not([src=''])"));
    await page.waitForFunction(() => /** @type {HTMLAudioElement} */ (document.querySelector("#voice")).ended);
    return page.evaluate(() => /** @type {Sample[]} */ (/** @type {any} */ (globalThis).samples));
  }

  const range = (/** @type {number[]} */ values) => Math.max(...values) - Math.min(...values);

  test("the speaker's hands and mouth move while the voice is heard, and the listener nods", async () => {
    const samples = await asked("Where does this road go?");
    assert.ok(samples.length > 5, `${samples.length} frames`);
    assert.ok(range(samples.map(({ voiceS }) => voiceS)) > 2, "the voice goes on");
    const reach = Math.max(...[0, 1, 2, 3, 4, 5].map((axis) => range(samples.map(({ hands }) => hands[axis] ?? 0))));
    assert.ok(reach > 0.15, `a hand moves ${reach} m`);
    assert.ok(Math.max(...samples.map(({ jaw }) => jaw)) > 0.05, "the mouth opens");
    const nod = range(samples.map(({ listenerPitch }) => listenerPitch));
    assert.ok(nod > 0.05, `the listener's head goes up and down by ${nod} rad`);
  });

  test("the page says what is said, and why the speaker moves", async () => {
    assert.match((await page.getByRole("status").textContent()) ?? "", /^Mara: It goes over the big hill/);
    assert.match((await page.getByRole("list").textContent()) ?? "", /(gesture|head|face) \w+ ← (?!by itself)\w+/);
  });

  test("when the answer has been given, something else can be asked", async () => {
    const button = page.getByRole("button", { name: "Thank you." });
    await page.waitForFunction(() => !document.querySelector("button")?.disabled);
    assert.ok(await button.isEnabled());
  });

  test("nothing went wrong in the page, and nothing was asked of another machine", () => {
    assert.deepEqual(faults, []);
    assert.deepEqual(elsewhere, []);
  });
});
