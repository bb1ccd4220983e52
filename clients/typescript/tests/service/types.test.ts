/** The types of requests are those of the service: what is right compiles, and each mistake that is expected is one. */

import type { operations } from "../../src/service/schema.js";
import type { Direction, Performed, PerformOptions, PerformRequest, RealizeAvatarRequest } from "../../src/service/types.js";

type PerformForm = operations["perform"]["requestBody"]["content"]["multipart/form-data"];
type RealizeForm = operations["realize"]["requestBody"]["content"]["multipart/form-data"];
type Same<A, B> = [A] extends [B] ? ([B] extends [A] ? true : never) : never;

export const formsHaveTheSameParts: [
  Same<keyof PerformRequest, keyof PerformForm>,
  Same<keyof RealizeAvatarRequest, keyof RealizeForm>,
] = [true, true];

export const options: PerformOptions = { agitation: "high", seed: 7, listener: ["bob"], mode: "semantic", lead_in_s: 1 };

// @ts-expect-error: a misspelt option
export const misspelt: PerformOptions = { agitatoin: "high" };

// @ts-expect-error: a level that is none
export const loud: PerformOptions = { agitation: "loud" };

// @ts-expect-error: a note without words
export const direction: Direction = { notes: [{}] };

export function gestures(performed: Performed): string[] {
  const kept = performed.performance.behaviors.filter((behavior) => behavior.kind === "gesture" && behavior.kept);
  return kept.map((behavior) => `${behavior.lexeme} at ${behavior.sync["stroke"] ?? 0} s`);
}
