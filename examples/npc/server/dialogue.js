/** The dialogue: who is in the scene, and the lines that were recorded. */

import { readFile } from "node:fs/promises";

const FOLDER = new URL("../", import.meta.url);

/**
 * @typedef {object} Npc
 * @property {string} name what players call it
 * @property {string} character one of the service's characters
 * @property {[number, number, number]} place where it stands, metres
 * @property {number} faces_deg where it faces, from the camera to its left
 *
 * @typedef {object} Line
 * @property {string} id
 * @property {string} question what players ask
 * @property {string} text what is answered
 * @property {number} seed
 *
 * @typedef {object} Dialogue
 * @property {Pick<Npc, "place">} player where the camera is
 * @property {Npc} speaker
 * @property {Npc} listener
 * @property {Line[]} lines
 */

/** @returns {Promise<Dialogue>} */
export async function readDialogue() {
  return /** @type {Dialogue} */ (JSON.parse(await readFile(new URL("dialogue.json", FOLDER), "utf8")));
}

/**
 * The recording of a line.
 *
 * @param {Line} line
 * @returns {Promise<Uint8Array<ArrayBuffer>>}
 */
export async function readRecording({ id }) {
  return new Uint8Array(await readFile(new URL(`lines/${id}.flac`, FOLDER)));
}

/**
 * Where the eyes of another are, as the service wants targets: metres, the NPC at the origin facing +Z.
 *
 * @param {Npc} npc
 * @param {Pick<Npc, "place">} other
 * @returns {[number, number, number]}
 */
export function eyesSeenBy(npc, other) {
  const turn = (-npc.faces_deg * Math.PI) / 180;
  const x = other.place[0] - npc.place[0];
  const z = other.place[2] - npc.place[2];
  return [x * Math.cos(turn) + z * Math.sin(turn), EYES_M, z * Math.cos(turn) - x * Math.sin(turn)];
}

const EYES_M = 1.6;
