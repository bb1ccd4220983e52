/** The multipart forms of requests. Each attempt gets a form of its own. */

import type { Bytes, PerformRequest, RealizeAvatarRequest } from "./types.js";

export function performForm(line: PerformRequest): FormData {
  const form = new FormData();
  if (line.audio) {
    form.append("audio", blob(line.audio), "audio");
  }
  form.append("text", line.text);
  appendJson(form, "options", line.options);
  appendJson(form, "functions", line.functions);
  appendJson(form, "direction", line.direction);
  appendJson(form, "edits", line.edits);
  appendJson(form, "rules", line.rules);
  for (const name of ["words", "reference", "profile"] as const) {
    const file = line[name];
    if (file) {
      form.append(name, blob(file.content), file.name);
    }
  }
  return form;
}

export function realizeForm(request: RealizeAvatarRequest): FormData {
  const form = new FormData();
  form.append("bml", new Blob([request.bml], { type: "application/xml" }), "line.bml");
  if (request.audio) {
    form.append("audio", blob(request.audio), "audio");
  }
  if (request.avatar) {
    form.append("avatar", blob(request.avatar), "avatar.glb");
  }
  appendJson(form, "options", request.options);
  for (const name of ["motion_model", "scenario"] as const) {
    const value = request[name];
    if (value !== undefined) {
      form.append(name, value);
    }
  }
  return form;
}

function blob(content: Bytes): Blob {
  return content instanceof Blob ? content : new Blob([content]);
}

function appendJson(form: FormData, name: string, value: unknown): void {
  if (value !== undefined) {
    form.append(name, JSON.stringify(value));
  }
}
