/** Takes a pose from a GLB or VRM file as angles of joints, and shows which joints a frame overrides so. */

import { el, fileButton, labelled } from "../dom.js";
import { problemOf } from "../service/service.js";
import { PROBLEM } from "../state/performed.js";
import { withPose } from "./arms.js";
import { withArm } from "./frames.js";
import { ARM, changeGesture, EDITED, FRAME, gestureOf } from "./gestures.js";

/** @import { AvatarPose, GestureArm } from "understudy-client" */
/** @import { Service } from "../service/service.js" */
/** @import { Store } from "../state/store.js" */

/**
 * @param {Store} store
 * @param {Service} service
 */
export function poseForm(store, service) {
  const time = el("input", { type: "number", id: "pose-time", min: 0, step: 0.1, value: 0 });
  const told = el("p", { id: "pose-told", role: "status" });
  const chosen = ([file] = /** @type {File[]} */ ([])) => file && void take(store, service, { file, time_s: Number(time.value) });
  const taken = fileButton("Pose from a body…", { id: "pose-file", accept: ".glb,.vrm", title: "A GLB or VRM file" }, chosen);
  const clear = el("button", { type: "button", id: "pose-clear", click: () => put(store, {}) }, ["Remove"]);
  const show = () => {
    const joints = gestureOf(store.get(EDITED)).frames[store.get(FRAME)]?.[store.get(ARM)]?.joints ?? {};
    const names = Object.keys(joints);
    told.replaceChildren(names.length > 0 ? `Set by angles: ${names.join(", ")}` : "No joint is set by angles.");
    clear.disabled = names.length === 0;
  };
  for (const of of [EDITED, FRAME, ARM]) {
    store.watch(/** @type {typeof FRAME} */ (of), show);
  }
  const row = el("div", { class: "row" }, [labelled("Time in its animation, s", time), taken, clear]);
  return el("fieldset", { id: "pose" }, [el("legend", {}, ["Joints by angles"]), row, told]);
}

/**
 * @param {Store} store
 * @param {Service} service
 * @param {{ file: File, time_s: number }} asked
 */
async function take(store, service, { file, time_s }) {
  const form = new FormData();
  form.append("avatar", file, file.name);
  form.append("options", JSON.stringify({ time_s }));
  try {
    const answer = await service.fetch("gestures/pose", { method: "POST", body: form });
    const { arms } = /** @type {AvatarPose} */ (await answer.json());
    changeGesture(store, "Pose from a file", (gesture) => withPose(gesture, store.get(FRAME), arms));
  } catch (error) {
    store.set(PROBLEM, problemOf(error));
  }
}

/**
 * @param {Store} store
 * @param {NonNullable<GestureArm["joints"]>} joints
 */
function put(store, joints) {
  changeGesture(store, "Joints by angles", (gesture) => withArm(gesture, store.get(FRAME), store.get(ARM), { joints }));
}
