/** The TypeScript of README.md compiles. */

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import { test } from "node:test";
import { fileURLToPath } from "node:url";
import ts from "typescript";

const here = (path: string): string => fileURLToPath(new URL(path, import.meta.url));

/** What the examples take for granted. */
const GIVEN = `
import { readFile } from "node:fs/promises";
import type { Object3D, WebGLRenderer, Scene, Camera } from "three";
declare const gltf: { scene: Object3D }, renderer: WebGLRenderer, scene: Scene, camera: Camera;
declare const bml: string, sound: HTMLAudioElement, audio: Uint8Array<ArrayBuffer>, script: { audio: Uint8Array<ArrayBuffer>; text: string }[];
void [readFile, gltf, renderer, scene, camera, bml, sound, audio, script];
`;

test("all examples compile, one after another", () => {
  const readme = readFileSync(here("../../README.md"), "utf8");
  const examples = Array.from(readme.matchAll(/```ts\n(.*?)```/gs), ([, code = ""]) => code);
  assert.ok(examples.length >= 3);
  const path = here("../readme_examples.mts");
  writeFileSync(path, [GIVEN, ...examples].join("\n").replaceAll('"understudy-client"', '"./src/index.js"'));
  const { config } = ts.readConfigFile(here("../../tsconfig.json"), (file) => ts.sys.readFile(file)) as {
    config: { compilerOptions: object };
  };
  const { options } = ts.convertCompilerOptionsFromJson(config.compilerOptions, here("../.."));
  const program = ts.createProgram([path], { ...options, noEmit: true, noUnusedLocals: false, rootDir: here("..") });
  const mistakes = ts.getPreEmitDiagnostics(program);
  assert.deepEqual(mistakes.map(({ messageText }) => ts.flattenDiagnosticMessageText(messageText, "\n")), []);
});
