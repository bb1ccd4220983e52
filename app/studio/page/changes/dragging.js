/**
 * What is dragged on the timeline is moved: a behaviour with everything (and with whatever moves along), a mark, or an edge of a word. While it goes on the
 * line is performed again as soon as the service is free; all of one drag counts from where the behaviour was before it.
 */

import { BUSY, PERFORMED } from "../state/performed.js";
import { DRAG } from "../timeline/pointing.js";
import { behaviorOf, madeOf } from "./behaviors.js";
import { changeEdits, editsOf } from "./change_edits.js";
import { movedWith, withAllMoved, withMoved } from "./moving.js";
import { withWordMoved, wordOf } from "./words.js";

/** @import { Edits } from "understudy-client" */
/** @import { Drag } from "../timeline/pointing.js" */
/** @import { Store } from "../state/store.js" */

/** What was there as the drag began. @typedef {(drag: Drag) => Edits} Dragging */

/** @param {Store} store */
export function moveWhatIsDragged(store) {
  /** @type {{ label: string, editsAt: Dragging } | null} */
  let held = null;
  store.watch(DRAG, (drag) => {
    held = drag && (held ?? begun(store, drag));
    if (!drag || !held) {
      return;
    }
    if (drag.ended || !store.get(BUSY)) {
      changeEdits(store, held.label, held.editsAt(drag));
    }
    if (drag.ended) {
      held = null;
      store.set(DRAG, null);
    }
  });
}

/**
 * @param {Store} store
 * @param {Drag} drag
 */
function begun(store, { id, mark }) {
  const editsAt = movingBehavior(store, id, mark) ?? movingWord(store, id);
  return editsAt && { label: `Move ${mark ?? "all"} of ${id}`, editsAt };
}

/**
 * @param {Store} store
 * @param {string} id
 * @param {string | null} mark
 * @returns {Dragging | null}
 */
function movingBehavior(store, id, mark) {
  const [made, now] = [madeOf(store), editsOf(store)];
  const behavior = behaviorOf(made, id);
  if (!made || !behavior?.kept) {
    return null;
  }
  const moved = mark === null || mark === "stroke" ? movedWith(store, [behavior]) : [behavior];
  return moved.length > 1
    ? ({ from_s, to_s }) => withAllMoved(now, made, moved, to_s - from_s)
    : ({ from_s, to_s }) => withMoved(now, made, behavior, mark, to_s - from_s);
}

/**
 * @param {Store} store
 * @param {string} id
 * @returns {Dragging | null}
 */
function movingWord(store, id) {
  const [performance, now, word] = [store.get(PERFORMED)?.performance, editsOf(store), wordOf(id)];
  return performance && word !== null
    ? ({ mark, from_s, to_s }) => withWordMoved(store, now, performance, word, { mark, later_s: to_s - from_s })
    : null;
}
