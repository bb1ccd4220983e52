/** The hand: one of the twelve forms or the relaxed hand, the thumb that it leaves free, and single fingers' bends. */

import { choice, el, labelled } from "../dom.js";
import { plain } from "../naming/movements.js";
import { possibleHand, withArm } from "./frames.js";
import { ARM, changeGesture, EDITED, FRAME, gestureOf, LANGUAGE } from "./gestures.js";
import { thumbsOf } from "./possible.js";
import { redraw } from "../redrawing.js";

/** @import { GestureArm, GestureLanguage } from "understudy-client" */
/** @import { Store } from "../state/store.js" */

/** @typedef {NonNullable<GestureArm["hand"]>} Hand */

const OPEN = "";
/** What forms are called whose names in the language are no words. @type {Readonly<Record<string, string>>} */
const FORMS = Object.freeze({
  symbol_1: "One finger", symbol_2: "Two fingers together", symbol_2apart: "Two fingers apart",
  symbol_pinch: "Pinch, other fingers closed", symbol_pinchall: "Pinch, all fingers", symbol_pinchopen: "Pinch, other fingers open",
  symbol_cee: "C, other fingers closed", symbol_ceeall: "C, all fingers", symbol_ceeopen: "C, other fingers open",
});

/** @type {Readonly<Record<string, string>>} */
const THUMBS = Object.freeze({ default: "Auto", open: "Beside the index finger", out: "Out", across: "Across" });

/** @param {Store} store */
export function handForm(store) {
  const element = el("fieldset", { id: "hand" });
  const show = () => {
    const language = store.get(LANGUAGE);
    const arm = gestureOf(store.get(EDITED)).frames[store.get(FRAME)]?.[store.get(ARM)] ?? {};
    redraw(element, language ? [el("legend", {}, ["Hand"]), shape(store, language, arm), fingers(store, language, arm)] : []);
  };
  for (const of of [EDITED, FRAME, ARM, LANGUAGE]) {
    store.watch(/** @type {typeof FRAME} */ (of), show);
  }
  return element;
}

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 * @param {GestureArm} arm
 */
function shape(store, language, { hand }) {
  const put = (/** @type {Hand | null | undefined} */ made) => change(store, "Form of the hand", { hand: made ? possibleHand(language, made) : undefined });
  const forms = /** @type {[string, string][]} */ ([[OPEN, "Not set"], ...language.forms.map(({ name }) => [name, FORMS[name] ?? readable(name)])]);
  const form = choice(forms, hand?.form ?? OPEN, (name) =>
    put(name === OPEN ? undefined : /** @type {Hand} */ ({ thumb: "default", ...hand, form: name })),
  );
  form.id = "hand-form";
  form.title = hand ? `${hand.form} in the gesture’s text` : "The form of the hand";
  const free = hand ? thumbsOf(language, hand.form) : [];
  const thumb = choice(free.map((name) => [name, THUMBS[name] ?? name]), hand?.thumb ?? "default", (name) =>
    put(hand && /** @type {Hand} */ ({ ...hand, thumb: name })),
  );
  thumb.id = "hand-thumb";
  thumb.disabled = free.length < 2;
  return el("div", { class: "row" }, [labelled("Form", form), labelled("Thumb’s place", thumb)]);
}

/**
 * @param {Store} store
 * @param {GestureLanguage} language
 * @param {GestureArm} arm
 */
function fingers(store, language, arm) {
  const bends = /** @type {[string, string][]} */ ([[OPEN, "Auto"], ...language.bends.map((name) => [name, readable(name)])]);
  const selects = language.fingers.map((finger) => {
    const bend = choice(bends, arm.fingers?.[finger] ?? OPEN, (name) => {
      const kept = Object.entries(arm.fingers ?? {}).filter(([other]) => other !== finger);
      const made = name === OPEN ? kept : [...kept, [finger, name]];
      const sorted = language.fingers.flatMap((each) => made.filter(([other]) => other === each));
      change(store, `Bend of the ${finger}`, { fingers: Object.fromEntries(sorted) });
    });
    bend.dataset["finger"] = finger;
    return labelled(plain(finger), bend);
  });
  return el("div", { class: "row" }, selects);
}

/**
 * @param {Store} store
 * @param {string} label
 * @param {{ [Part in keyof GestureArm]: GestureArm[Part] | undefined }} parts
 */
function change(store, label, parts) {
  changeGesture(store, label, (gesture) => withArm(gesture, store.get(FRAME), store.get(ARM), parts));
}

/** @param {string} name */
function readable(name) {
  return plain(name.replace(/^(form|symbol|bend)_/, ""));
}
