/** The table read before a scene is open: where its folder is dropped, and how somebody who has none comes to one. */

import { el, fileButton } from "../dom.js";
import { sceneFiles } from "./scene_files.js";

/** @import { SceneFiles } from "./scene_files.js" */

const SCRIPT = "id,character,text\none,ELIZA,Have you seen those lights?\ntwo,HENRY,\"No, never.\"";
const COMMAND = "understudy batch scene.csv --audio recordings --out scene --fps 30 --format clip.json --format wav";

/** @param {(files: Promise<SceneFiles>) => void} open */
export function chooser(open) {
  const take = (/** @type {File[]} */ files) => open(sceneFiles(files));
  const folder = fileButton("Choose the folder…", { id: "scene-folder", webkitdirectory: true, class: "primary" }, take);
  const zip = fileButton("Choose a zip of it…", { id: "scene-zip", accept: ".zip" }, take);
  const drop = el("div", { class: "drop" }, [
    el("strong", {}, ["Drop the folder of a performed scene here"]),
    el("div", { class: "row" }, [folder, zip]),
    el("p", { class: "quiet" }, ["It stays in this browser."]),
  ]);
  return el("section", { class: "chooser", "aria-label": "Open a scene" }, [intro(), drop, steps()]);
}

function intro() {
  return el("div", { class: "intro" }, [
    el("h2", {}, ["Read a scene at the table"]),
    el("p", { class: "quiet" }, ["Everybody of a scene stands on a mark and says their lines, in turn or from any line on. You choose the camera, take notes, and open a line to work on it."]),
  ]);
}

function steps() {
  return el("div", { class: "steps" }, [
    el("h3", {}, ["No scene yet?"]),
    el("ol", {}, [
      el("li", {}, ["Write the script as a table (CSV or Excel), a row for each line, or take a screenplay (.fountain, .fdx):", copied("script", SCRIPT)]),
      el("li", {}, ["Put the recordings into a folder, each under the id of its line: ", el("code", {}, ["recordings/one.wav"]), "."]),
      el("li", {}, ["Have all of it performed in a terminal, then drop the folder ", el("code", {}, ["scene"]), " above:", copied("command", COMMAND)]),
    ]),
  ]);
}

/**
 * A text to be taken elsewhere.
 *
 * @param {string} name
 * @param {string} text
 */
function copied(name, text) {
  const copy = el("button", { type: "button", "aria-label": `Copy the ${name}` }, ["Copy"]);
  copy.addEventListener("click", () => void navigator.clipboard.writeText(text).then(() => (copy.textContent = "Copied")));
  return el("div", { class: "copied" }, [el("pre", {}, [text]), copy]);
}
