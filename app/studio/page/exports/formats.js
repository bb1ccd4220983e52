/** The files that a line is taken away as, which the service writes: their endings, and how they are asked for. */

import { performForm, realizeForm } from "../service/requests.js";

/** @import { Service } from "../service/service.js" */
/** @import { PerformedLine } from "../state/performed.js" */
/** @import { Line } from "../service/performing.js" */

/**
 * What is exported: the line, what was made of it, and the body that was dropped in place of ours.
 *
 * @typedef {Readonly<{ line: Line, performed: PerformedLine, avatar: File | null }>} Exported
 */

/**
 * A file's content.
 *
 * @typedef {(service: Service, exported: Exported) => Promise<Blob>} Writer
 */

/** Motion formats: ending, what it is called, media type. @type {readonly (readonly [string, string, string])[]} */
const MOTION = Object.freeze([
  [".glb", "GLB", "model/gltf-binary"],
  [".bvh", "BVH", "text/x-bvh"],
  [".vrma", "VRM animation", "model/vnd.vrm-animation"],
  [".clip.json", "Clip (JSON)", "application/json"],
  [".fbx", "FBX", "application/vnd.autodesk.fbx"],
  [".usda", "USD, text", "model/vnd.usda"],
  [".usdc", "USD, binary", "model/vnd.usdc"],
  [".usdz", "USDZ", "model/vnd.usdz+zip"],
  [".csv", "Face (Live Link CSV)", "text/x-arkit-csv"],
  [".visemes.txt", "Visemes", "text/x-visemes"],
  [".bap", "MPEG-4 body", "text/x-bap"],
  [".fap", "MPEG-4 face", "text/x-fap"],
  [".otio", "OpenTimelineIO", "application/vnd.pixar.opentimelineio+json"],
  [".TextGrid", "Praat TextGrid", "text/praat-textgrid"],
  [".eaf", "ELAN", "text/x-eaf+xml"],
  [".events.csv", "Events (CSV)", "text/csv"],
]);

/** Every format by its ending, in the order in which they are offered. @type {ReadonlyMap<string, { name: string, write: Writer }>} */
export const FORMATS = new Map([
  [".bml", { name: "BML", write: (_service, { performed }) => Promise.resolve(xml(performed.bml)) }],
  [".smartbody.bml", { name: "BML for SmartBody", write: smartBody }],
  [".json", { name: "Performance (JSON)", write: (_service, { performed }) => Promise.resolve(json(performed.performance)) }],
  ...MOTION.map(([ending, name, mediaType]) => /** @type {const} */ ([ending, { name, write: motion(mediaType) }])),
]);

/** @type {Writer} */
async function smartBody(service, { line, performed }) {
  const options = { ...line.options, dialect: /** @type {const} */ ("smartbody") };
  const body = performForm({ ...line, options }, performed);
  const answer = await service.fetch("perform", { method: "POST", headers: { accept: "application/json" }, body });
  return xml((await answer.json()).bml);
}

/**
 * @param {string} accept
 * @returns {Writer}
 */
function motion(accept) {
  return async (service, { line, performed, avatar }) => {
    const body = realizeForm(performed.bml, line.audio);
    if (avatar && accept === "model/gltf-binary") {
      body.append("avatar", avatar, avatar.name);
    }
    return (await service.fetch("realize", { method: "POST", headers: { accept }, body })).blob();
  };
}

/** @param {string} text */
function xml(text) {
  return new Blob([text], { type: "application/xml" });
}

/** @param {object} value */
function json(value) {
  return new Blob([JSON.stringify(value, null, 2)], { type: "application/json" });
}
