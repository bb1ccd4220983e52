/** What the timeline shows of another version of the line: which items that lacks, and which it has beside them. */

import { slice } from "../state/slice.js";

/** @import { Behavior } from "understudy-client" */

/** The ids of movements that the other version has not; whoever compares sets it. */
export const DIFFERING = slice(/** @type {ReadonlySet<string>} */ (new Set()));

/** The movements that only the other version has. */
export const OTHERS = slice(/** @type {readonly Behavior[]} */ ([]));
