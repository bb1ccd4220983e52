/** The forms of requests for a performance and its motion. */

/** @import { Performance, RealizeOptions } from "understudy-client" */
/** @import { PerformedLine } from "../state/performed.js" */
/** @import { Project } from "../state/project.js" */

/**
 * What `POST /perform` is sent.
 *
 * `heard` is what was made of the same recording and text, if there was one: its words are sent, so that they need not
 * be looked for again. Only where nothing was guessed in finding them: else the service would not say so again. Contours
 * are asked for once.
 *
 * @param {Project & { audio: File }} project
 * @param {PerformedLine | null} heard
 */
export function performForm(project, heard) {
  const form = new FormData();
  form.append("audio", project.audio, project.audio.name);
  form.append("text", project.text);
  form.append("options", JSON.stringify(heard ? project.options : { ...project.options, contours: true }));
  const words = project.words ?? (heard && wordsOf(heard.performance));
  appendFile(form, "words", words && { words });
  appendFile(form, "direction", project.direction);
  appendFile(form, "edits", project.edits);
  appendFile(form, "rules", project.rules && { files: project.rules });
  return form;
}

/**
 * What `POST /realize` is sent.
 *
 * @param {string} bml
 * @param {File} audio
 * @param {RealizeOptions} [options]
 */
export function realizeForm(bml, audio, options = {}) {
  const form = new FormData();
  form.append("bml", new Blob([bml], { type: "application/xml" }), "line.bml");
  form.append("audio", audio, audio.name);
  form.append("options", JSON.stringify(options));
  return form;
}

/**
 * The words in time, where nothing about them was guessed.
 *
 * @param {Performance} heard
 */
function wordsOf({ words, fillers, warnings }) {
  const isCertain = fillers.length === 0 && warnings.length === 0 && words.every(({ spread }) => !spread);
  return isCertain ? words : null;
}

/**
 * @param {FormData} form
 * @param {string} name
 * @param {object | null} content
 */
function appendFile(form, name, content) {
  if (content !== null) {
    form.append(name, new Blob([JSON.stringify(content)], { type: "application/json" }), `${name}.json`);
  }
}
