import assert from "node:assert/strict";
import { test } from "node:test";

import type { Clip, Pose } from "../../src/motion/clip.js";
import { Performer } from "../../src/playing/performer.js";
import { clip, track } from "../support/clips.js";

/** A clip whose hips are at Z = `from` + the seconds that have passed. */
function walking(from: number, parts: Partial<Clip> = {}): Clip {
  return clip({ hips: track(3, [0, 1, from], [0, 1, from + 1], [0, 1, from + 2]), ...parts });
}

class Stage {
  timeS = 0;
  shown: Pose | undefined;
  readonly performer: Performer;

  constructor(idle?: Clip) {
    this.performer = new Performer({ show: (pose) => (this.shown = pose) }, idle, () => this.timeS);
  }

  /** Where the hips are after an update at this time of the world. */
  at(timeS: number): number {
    this.timeS = timeS;
    this.performer.update();
    return Math.round((this.shown?.hipsM[2] ?? Number.NaN) * 1000) / 1000;
  }
}

test("a clip follows the clock of its recording, not the frames that are drawn", () => {
  const stage = new Stage();
  let audioS = 0.5;
  stage.performer.play(walking(0, { audioOffsetS: -1 }), { clock: () => audioS });
  assert.equal(stage.at(40), 1.5);
  audioS = -0.25;
  assert.equal(stage.at(41), 0.75);
});

test("without a clock it is played from the moment it was given", () => {
  const stage = new Stage();
  stage.at(7);
  stage.performer.play(walking(0));
  assert.equal(stage.at(7.5), 0.5);
});

test("the next clip is faded to from what was shown", () => {
  const stage = new Stage();
  stage.performer.play(walking(0));
  assert.equal(stage.at(1), 1);
  stage.performer.play(walking(10), { fadeS: 1 });
  assert.equal(stage.at(1), 1);
  assert.equal(stage.at(1.5), 5.75);
  assert.equal(stage.at(2), 11);
});

test("the end is told once, after the last frame was shown, and the idle clip follows to and fro", () => {
  const stage = new Stage(walking(100));
  let ended = 0;
  assert.equal(stage.at(0), 100);
  stage.performer.play(walking(0), { fadeS: 0, onEnd: () => (ended += 1) });
  assert.ok(stage.performer.isPlaying);
  assert.equal(stage.at(2.1), 2);
  assert.deepEqual([ended, stage.performer.isPlaying], [1, false]);
  assert.equal(stage.at(3), 2);
  assert.equal(stage.at(4), 101);
  assert.equal(stage.at(6), 101);
  assert.equal(ended, 1);
});

test("each sync point is told once as it is passed, those before the start of the fade too", () => {
  const stage = new Stage();
  const events = [
    { behavior: "b1", point: "start", timeS: 0 },
    { behavior: "b1", point: "stroke", timeS: 1 },
    { behavior: "b1", point: "end", timeS: 1.9 },
  ];
  const told: string[] = [];
  stage.performer.play(walking(0, { events }), { onEvent: ({ point }) => told.push(point) });
  stage.at(0);
  stage.at(0.5);
  assert.deepEqual(told, ["start"]);
  stage.at(1.5);
  stage.at(1.2);
  stage.at(1.6);
  assert.deepEqual(told, ["start", "stroke"]);
  stage.at(2.5);
  assert.deepEqual(told, ["start", "stroke", "end"]);
});
