/** A language with all directions and a few of the other words, as the service tells it; made from what they mean. */

/** @import { GestureLanguage } from "understudy-client" */

const VECTORS = /** @type {const} */ ({ Up: [0, 1, 0], Down: [0, -1, 0], Inwards: [-1, 0, 0], Outwards: [1, 0, 0], Away: [0, 0, 1], Towards: [0, 0, -1] });
const AXES = [[null, "Up", "Down"], [null, "Inwards", "Outwards"], [null, "Away", "Towards"]];

/** @param {readonly string[]} directions */
function vectorOf(directions) {
  return [0, 1, 2].map((axis) => directions.reduce((sum, name) => sum + (/** @type {Record<string, readonly number[]>} */ (VECTORS)[name]?.[axis] ?? 0), 0));
}

const SUMS = AXES.reduce(
  (sums, axis) => sums.flatMap((sum) => axis.map((name) => (name ? [...sum, name] : sum))),
  /** @type {string[][]} */ ([[]]),
);

export const LANGUAGE = /** @type {GestureLanguage} */ (
  /** @type {unknown} */ ({
    x: [["XEP", 0.54], ["XC", 0.2], ["XOppC", -0.06]].map(([name, place_m]) => ({ name, place_m })),
    y: [["YUpperP", 0.43], ["YCC", 0.2], ["YLowerP", 0.02]].map(([name, place_m]) => ({ name, place_m })),
    z: [["ZNear", 0.2], ["ZFar", 0.42]].map(([name, place_m]) => ({ name, place_m })),
    out_of_reach: [["XEP", "YUpperP", "ZFar"]],
    forms: [
      { name: "form_flat", thumbs: ["default", "open", "out", "across"] },
      { name: "symbol_pinch", thumbs: ["default"] },
    ],
    orientations: SUMS.map((directions) => {
      const vector = vectorOf(directions);
      const dot = (/** @type {string[]} */ other) => vectorOf(other).reduce((sum, part, axis) => sum + part * (vector[axis] ?? 0), 0);
      return { directions, vector, partners: [...SUMS.keys()].filter((index) => dot(SUMS[index] ?? []) === 0) };
    }),
    track_forms: ["held", "curved", "circling"],
    track_joints: ["chest", "LowerArm"],
    ranges: { track_degrees: [-45, 45], track_turns: [0.25, 6], track_phase_deg: [-360, 360] },
    frame_types: ["start", "preparation", "ready", "stroke_start", "stroke", "stroke_end", "hold", "relax", "retraction", "end"].map(
      (name) => ({ name, once: !["preparation", "stroke", "hold", "retraction"].includes(name) }),
    ),
  })
);
