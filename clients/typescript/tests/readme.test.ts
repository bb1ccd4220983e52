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
declare const microphone: { onsamples: (samples: Float32Array) => void };
declare function pose(joints: readonly string[], rotations: readonly number[], hips_m: readonly number[]): void;
import type { Object3D, WebGLRenderer, Scene, Camera } from "three";
declare const gltf: { scene: Object3D }, renderer: WebGLRenderer, scene: Scene, camera: Camera;
declare const bml: string, sound: HTMLAudioElement, audio: Uint8Array<ArrayBuffer>, script: { audio: Uint8Array<ArrayBuffer>; text: string }[];
void [microphone, pose, readFile, gltf, renderer, scene, camera, bml, sound, audio, script];
`;

const README = readFileSync(here("../../README.md"), "utf8");

/** What the compiler says of a file with this content, which imports the package as it was built. */
function mistakesOf(name: string, content: string, changed: object): string[] {
  const path = here(`../${name}`);
  writeFileSync(path, content.replaceAll('"understudy-client"', '"./src/index.js"'));
  const { config } = ts.readConfigFile(here("../../tsconfig.json"), (file) => ts.sys.readFile(file)) as {
    config: { compilerOptions: object };
  };
  const { options } = ts.convertCompilerOptionsFromJson(config.compilerOptions, here("../.."));
  const all = { ...options, noEmit: true, noUnusedLocals: false, rootDir: here(".."), ...changed };
  const mistakes = ts.getPreEmitDiagnostics(ts.createProgram([path], all));
  return mistakes.map(({ messageText }) => ts.flattenDiagnosticMessageText(messageText, "\n"));
}

test("all examples compile, one after another", () => {
  const examples = Array.from(README.matchAll(/```ts\n(.*?)```/gs), ([, code = ""]) => code);
  assert.ok(examples.length >= 4);
  assert.deepEqual(mistakesOf("readme_examples.mts", [GIVEN, ...examples].join("\n"), {}), []);
});

test("the whole page's script uses what the package and three.js have", () => {
  const [, script = ""] = /<script type="module">\n(.*?)<\/script>/s.exec(README) ?? [];
  assert.ok(script.includes("new Performer"));
  const loose = { strict: false, exactOptionalPropertyTypes: false, allowJs: true, checkJs: true, noImplicitAny: false, rootDir: here("../..") };
  const mistakes = mistakesOf("readme_page.mjs", script, loose);
  assert.deepEqual(mistakes, []);
});
