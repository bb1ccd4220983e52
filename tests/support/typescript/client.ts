/** A client of the generated types: what is right compiles, and each mistake that is expected is one. */

import type { components, operations } from "./api";

type Options = components["schemas"]["PerformOptions"];
type Performed = operations["perform"]["responses"][200]["content"]["application/json"];
type Problem = operations["perform"]["responses"][422]["content"]["application/problem+json"];
type Clip = operations["realize"]["responses"][200]["content"]["application/json"];
type Text = operations["find_functions"]["requestBody"]["content"]["application/json"];

export const options: Options = { agitation: "high", seed: 7, listener: ["bob"], mode: "semantic", lead_in_s: 1 };

// @ts-expect-error: a misspelt option
export const misspelt: Options = { agitatoin: "high" };

// @ts-expect-error: a level that is none
export const loud: Options = { agitation: "loud" };

export const text: Text = { text: "No." };

export function gestures(performed: Performed): string[] {
  const kept = performed.performance.behaviors.filter((behavior) => behavior.kind === "gesture" && behavior.kept);
  return kept.map((behavior) => `${behavior.lexeme} at ${behavior.sync["stroke"] ?? 0} s`);
}

export function told(problem: Problem): string {
  return problem.code === "text_empty" ? "say something" : `${problem.code} in ${problem.field ?? "it"}: ${problem.detail}`;
}

export function hips(clip: Clip): number[] | undefined {
  return clip.bones["hips"]?.[0];
}
