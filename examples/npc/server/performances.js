/** What the game needs of the service: figures, how they stand idle, and how a line is performed and listened to. */

import { eyesSeenBy, readRecording } from "./dialogue.js";

/** @import { UnderstudyClient, ClipJson, Behavior } from "understudy-client" */
/** @import { Cache } from "./cache.js" */
/** @import { Dialogue, Line, Npc } from "./dialogue.js" */

/** @type {30} */
const FPS = 30;
const IDLE_S = 8;
const PLAYER = "player";
const ATTENDED = "listener";

/**
 * @typedef {object} PerformedLine
 * @property {ClipJson} speaker
 * @property {ClipJson} listener
 * @property {Pick<Behavior, "id" | "kind" | "lexeme" | "rule">[]} behaviors of the speaker, by BML id
 */

/** Asks the service once for each thing, and keeps the answers. */
export class Performances {
  /** @type {UnderstudyClient} */
  #client;
  /** @type {Cache} */
  #cache;
  /** @type {Dialogue} */
  #dialogue;

  /**
   * @param {UnderstudyClient} client
   * @param {Cache} cache
   * @param {Dialogue} dialogue
   */
  constructor(client, cache, dialogue) {
    this.#client = client;
    this.#cache = cache;
    this.#dialogue = dialogue;
  }

  /**
   * The figure of an NPC: the mannequin of its character as GLB.
   *
   * @param {Npc} npc
   */
  body({ character }) {
    const request = { bml: idleBml(character), options: { character, fps: FPS } };
    return this.#cache.kept(["body", JSON.stringify(request)], async () => {
      const { content } = await this.#client.realizeGlb(request);
      return new Uint8Array(content);
    });
  }

  /**
   * A clip (JSON) of an NPC that stands, breathes and looks: the speaker at the player, the listener at the speaker.
   *
   * @param {Npc} npc
   */
  idle(npc) {
    const { player, speaker } = this.#dialogue;
    const targets = { [ATTENDED]: eyesSeenBy(npc, npc === speaker ? player : speaker) };
    const { character } = npc;
    const request = { bml: idleBml(character), options: { character, fps: FPS, targets } };
    return this.#cache.kept(["idle", JSON.stringify(request)], async () => json(await this.#client.realize(request)));
  }

  /**
   * A line as it is spoken and listened to: a `PerformedLine` as JSON.
   *
   * @param {Line} line
   */
  async line(line) {
    const audio = await readRecording(line);
    const { player, speaker, listener } = this.#dialogue;
    const options = {
      character: speaker.character,
      seed: line.seed,
      listener: [PLAYER, listener.character],
      targets: { [PLAYER]: eyesSeenBy(speaker, player), [listener.character]: eyesSeenBy(speaker, listener) },
    };
    const parts = ["line", audio, line.text, JSON.stringify([options, this.#dialogue])];
    return this.#cache.kept(parts, async () => {
      const { bml, listeners, performance } = await this.#client.perform({ audio, text: line.text, options });
      const behaviors = performance.behaviors.map(({ id, kind, lexeme, rule }) => ({ id, kind, lexeme, rule }));
      const spoken = { bml, audio, options: { character: speaker.character, fps: FPS } };
      const listened = this.#listened(listeners?.[listener.character] ?? "");
      return json({
        speaker: await this.#client.realize(spoken),
        listener: await this.#client.realize(listened),
        behaviors,
      });
    });
  }

  /** @param {string} bml */
  #listened(bml) {
    const { speaker, listener } = this.#dialogue;
    const targets = { [speaker.character]: eyesSeenBy(listener, speaker) };
    return { bml, options: { character: listener.character, fps: FPS, targets } };
  }
}

/** @param {string} character */
function idleBml(character) {
  return (
    `<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="idle" characterId="${character}">` +
    `<gaze id="look" target="${ATTENDED}" start="0" end="${IDLE_S}"/></bml>`
  );
}

/** @param {unknown} value */
function json(value) {
  return new TextEncoder().encode(JSON.stringify(value));
}
