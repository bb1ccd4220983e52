/**
 * Puts the packages that the studio page carries into app/studio/page/vendor: minified, one by one, with their licences
 * and a list of versions. Ours is there too: the client of clients/typescript, which decodes clips and plays them.
 *
 *     node scripts/vendor.js [--check]
 *
 * With --check nothing is written, and the exit code is 1 where a file is not what would be written.
 */

import { build, transform } from "esbuild";
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { dirname } from "node:path";
import { fileURLToPath } from "node:url";

const here = (/** @type {string} */ path) => fileURLToPath(new URL(path, import.meta.url));
const MODULES = here("../node_modules/");
const VENDOR = here("../../../app/studio/page/vendor/");
const CLIENT = here("../../../clients/typescript/src/index.ts");
const ADDONS = ["controls/OrbitControls.js", "loaders/GLTFLoader.js", "utils/BufferGeometryUtils.js", "utils/SkeletonUtils.js"];

/** Files of packages by where they go. */
const SOURCES = {
  "three/three.core.js": "three/build/three.core.js",
  "three/three.module.js": "three/build/three.module.js",
  ...Object.fromEntries(ADDONS.map((name) => [`three/addons/${name}`, `three/examples/jsm/${name}`])),
  "three-vrm/three-vrm.js": "@pixiv/three-vrm/lib/three-vrm.module.js",
  "fflate/fflate.js": "fflate/esm/browser.js",
};
const LICENCES = {
  "three/LICENSE": "three/LICENSE",
  "three-vrm/LICENSE": "@pixiv/three-vrm/LICENSE",
  "fflate/LICENSE": "fflate/LICENSE",
};
const PACKAGES = ["three", "@pixiv/three-vrm", "fflate"];

const read = (/** @type {string} */ path) => readFileSync(path, "utf8");

/** @param {string} path */
async function minified(path) {
  return (await transform(read(MODULES + path), { minify: true, format: "esm", target: "es2022" })).code;
}

async function bundledClient() {
  const built = await build({ entryPoints: [CLIENT], bundle: true, minify: true, format: "esm", target: "es2022", write: false });
  return built.outputFiles[0]?.text ?? "";
}

/** @param {string} name */
function described(name) {
  const { version, license } = JSON.parse(read(`${MODULES}${name}/package.json`));
  return [name, { version, license }];
}

/** @returns {Promise<Map<string, string>>} what lies there, by path */
async function contents() {
  /** @type {Map<string, string>} */
  const found = new Map();
  for (const [target, source] of Object.entries(SOURCES)) {
    found.set(target, await minified(source));
  }
  for (const [target, source] of Object.entries(LICENCES)) {
    found.set(target, read(MODULES + source));
  }
  found.set("understudy-client.js", await bundledClient());
  found.set("vendor.json", `${JSON.stringify(Object.fromEntries(PACKAGES.map(described)), null, 2)}\n`);
  return found;
}

/** @param {Map<string, string>} wanted */
function differences(wanted) {
  const present = readdirSync(VENDOR, { recursive: true, withFileTypes: true })
    .filter((entry) => entry.isFile())
    .map((entry) => `${entry.parentPath}/${entry.name}`.slice(VENDOR.length).replace(/^\//, ""));
  const changed = [...wanted].filter(([path, content]) => !present.includes(path) || read(VENDOR + path) !== content);
  return [...changed.map(([path]) => path), ...present.filter((path) => !wanted.has(path))];
}

/** @param {Map<string, string>} wanted */
function write(wanted) {
  rmSync(VENDOR, { recursive: true, force: true });
  for (const [path, content] of wanted) {
    mkdirSync(dirname(VENDOR + path), { recursive: true });
    writeFileSync(VENDOR + path, content);
  }
}

const wanted = await contents();
if (!process.argv.includes("--check")) {
  write(wanted);
} else {
  for (const path of differences(wanted)) {
    console.error(`app/studio/page/vendor/${path} is not what the packages say; run: npm run vendor`);
    process.exitCode = 1;
  }
}
