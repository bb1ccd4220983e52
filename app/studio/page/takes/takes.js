/** Takes of a line: the line as it was performed once, kept under a name beside how it is now. */

import { draftOf, OPENED, PROJECT } from "../state/project.js";
import { slice } from "../state/slice.js";
import { ChangeProject } from "../state/change_project.js";

/** @import { Store } from "../state/store.js" */
/** @import { Draft } from "../state/project.js" */

/** @typedef {Readonly<{ id: string, name: string, draft: Draft }>} Take */

/** The takes that are kept, the first first. */
export const TAKES = slice(/** @type {readonly Take[]} */ ([]));

/**
 * Keeps the line as it is now; the take that has it is told, be it an earlier one.
 *
 * @param {Store} store
 * @returns {Take}
 */
export function keepTake(store) {
  const draft = draftOf(store.get(PROJECT));
  const takes = store.get(TAKES);
  const same = takeOf(takes, draft);
  const take = same ?? { id: `${store.get(OPENED).id}-${String(Date.now())}`, name: nextName(takes), draft };
  if (!same) {
    store.set(TAKES, [...takes, take]);
  }
  return take;
}

/**
 * Keeps the line and has it performed by another seed.
 *
 * @param {Store} store
 */
export function anotherTake(store) {
  const before = keepTake(store);
  const { options } = store.get(PROJECT);
  const seed = nextSeed([options.seed, ...store.get(TAKES).map(({ draft }) => draft.options.seed)]);
  store.history.execute(new ChangeProject(store, "New take", { options: { ...options, seed } }));
  return before;
}

/**
 * Has the line as it was in a take.
 *
 * @param {Store} store
 * @param {Take} take
 */
export function useTake(store, take) {
  store.history.execute(new ChangeProject(store, `Use ${take.name}`, take.draft));
}

/**
 * @param {Store} store
 * @param {Take} take
 */
export function forgetTake(store, take) {
  store.set(TAKES, store.get(TAKES).filter((each) => each !== take));
}

/**
 * The take that is the same as a line.
 *
 * @param {readonly Take[]} takes
 * @param {Draft} draft
 */
export function takeOf(takes, draft) {
  return takes.find((take) => JSON.stringify(take.draft) === JSON.stringify(draft));
}

/** @param {readonly (number | undefined)[]} seeds */
export function nextSeed(seeds) {
  return Math.max(...seeds.map((seed) => seed ?? 0)) + 1;
}

/**
 * The first number that no take has.
 *
 * @param {readonly Pick<Take, "name">[]} takes
 */
export function nextName(takes) {
  const numbers = takes.map(({ name }) => Number(/^Take (\d+)$/.exec(name)?.[1] ?? 0));
  return `Take ${String(Math.max(0, ...numbers) + 1)}`;
}
