/** The forms of requests for a performance and its motion. */

import { isRecorded } from "../state/project.js";

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
  appendRecording(form, project.audio);
  form.append("text", project.text);
  form.append("options", JSON.stringify(heard || !isRecorded(project.audio) ? project.options : { ...project.options, contours: true }));
  const known = heard && isCertain(heard.performance) ? inRecording(heard.performance) : null;
  appendFile(form, "words", project.words ? { words: project.words } : known);
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
  appendRecording(form, audio);
  form.append("options", JSON.stringify(options));
  return form;
}

/**
 * Words and fillers as they are in the recording, before which a performance may begin.
 *
 * @param {Performance} performance
 */
export function inRecording({ words, fillers, lead_in_s }) {
  /** @template {{ start_s?: number | null, end_s?: number | null }} Timed @param {Timed} timed @returns {Timed} */
  const earlier = (timed) => ({
    ...timed,
    ...(typeof timed.start_s === "number" ? { start_s: timed.start_s - lead_in_s } : {}),
    ...(typeof timed.end_s === "number" ? { end_s: timed.end_s - lead_in_s } : {}),
  });
  const spoken = words.map((word) => ({ ...earlier(word), phones: word.phones.map(earlier) }));
  return { words: spoken, fillers: fillers.map(earlier) };
}

/**
 * Whether nothing about the words was guessed; of edits and notes the service tells again.
 *
 * @param {Performance} heard
 */
function isCertain({ words, warnings }) {
  return warnings.every(({ code }) => /^(edit|direction)_/.test(code)) && words.every(({ spread }) => !spread);
}

/**
 * Without a recording the service performs the words alone.
 *
 * @param {FormData} form
 * @param {File} audio
 */
function appendRecording(form, audio) {
  if (isRecorded(audio)) {
    form.append("audio", audio, audio.name);
  }
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
