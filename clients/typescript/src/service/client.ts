/** The requests of the service as methods. Every method may be called again and at the same time; nothing is kept. */

import { warningCodes } from "./answers.js";
import { performForm, realizeForm } from "./forms.js";
import { DEFAULT_POLICY, type RetryPolicy } from "./retrying.js";
import { called, type Call, type Transport } from "./transport.js";
import type {
  CallOptions,
  Characters,
  ClipJson,
  FoundFunctions,
  Gestures,
  Performed,
  PerformRequest,
  RealizeAvatarRequest,
  RealizeRequest,
  Rules,
  Status,
} from "./types.js";

const JSON_TYPE = "application/json";
const XML = "application/xml";
const GLB = "model/gltf-binary";
const BVH = "text/x-bvh";

/** Where the service is and how it is called. */
export interface ClientOptions {
  /** As `http://127.0.0.1:8000`; a path before the service's own is kept. */
  readonly baseUrl: string;
  readonly apiKey?: string | undefined;
  /** For each call with all its attempts; 60,000 unless given. */
  readonly timeoutMs?: number;
  readonly retry?: Partial<RetryPolicy>;
  /** In place of the global `fetch`. */
  readonly fetch?: typeof fetch;
}

/** Something that was answered as text, and the codes of what was degraded, dropped or guessed. */
export interface Warned<Content> {
  readonly content: Content;
  readonly warnings: readonly string[];
}

/** A client of one service. Methods reject with an UnderstudyError, or with the reason of the signal given. */
export class UnderstudyClient {
  readonly #transport: Transport;

  constructor(options: ClientOptions) {
    this.#transport = {
      baseUrl: options.baseUrl.replace(/\/+$/, ""),
      apiKey: options.apiKey,
      timeoutMs: options.timeoutMs ?? 60_000,
      policy: { ...DEFAULT_POLICY, ...options.retry },
      fetch: options.fetch ?? ((url, request) => fetch(url, request)),
    };
  }

  /** Performs a line: BML, the performance with its reasons, and the BML of listeners. */
  perform(line: PerformRequest, call?: CallOptions): Promise<Performed> {
    return this.#json({ path: "/perform", accept: JSON_TYPE, body: () => performForm(line) }, call);
  }

  /** Performs a line of one speaker: the BML alone. */
  performBml(line: PerformRequest, call?: CallOptions): Promise<Warned<string>> {
    return this.#warned({ path: "/perform", accept: XML, body: () => performForm(line) }, (answer) => answer.text(), call);
  }

  /** The motion of BML as a clip. */
  realize(request: RealizeRequest, call?: CallOptions): Promise<ClipJson> {
    return this.#json({ path: "/realize", accept: JSON_TYPE, body: () => realizeForm(request) }, call);
  }

  /** The motion of BML as a GLB file: of the built-in mannequin, or of an avatar. */
  realizeGlb(request: RealizeAvatarRequest, call?: CallOptions): Promise<Warned<ArrayBuffer>> {
    const asked = { path: "/realize", accept: GLB, body: () => realizeForm(request) };
    return this.#warned(asked, (answer) => answer.arrayBuffer(), call);
  }

  /** The motion of BML as a BVH file. */
  realizeBvh(request: RealizeRequest, call?: CallOptions): Promise<Warned<string>> {
    const asked = { path: "/realize", accept: BVH, body: () => realizeForm(request) };
    return this.#warned(asked, (answer) => answer.text(), call);
  }

  /** The communicative functions of words alone. */
  findFunctions(text: string, call?: CallOptions): Promise<FoundFunctions> {
    return this.#json({ path: "/functions", accept: JSON_TYPE, body: () => JSON.stringify({ text }) }, call);
  }

  listCharacters(call?: CallOptions): Promise<Characters> {
    return this.#json({ path: "/characters", accept: JSON_TYPE }, call);
  }

  listGestures(call?: CallOptions): Promise<Gestures> {
    return this.#json({ path: "/gestures", accept: JSON_TYPE }, call);
  }

  listRules(call?: CallOptions): Promise<Rules> {
    return this.#json({ path: "/rules", accept: JSON_TYPE }, call);
  }

  listWords(call?: CallOptions): Promise<Rules> {
    return this.#json({ path: "/lexicon", accept: JSON_TYPE }, call);
  }

  /** Whether lines can be performed; while they cannot, the service is asked again as the retry policy says. */
  status(call?: CallOptions): Promise<Status> {
    return this.#json({ path: "/readyz", accept: JSON_TYPE }, call);
  }

  #json<Answer>(asked: Call, call?: CallOptions): Promise<Answer> {
    return called(this.#transport, asked, (answer) => answer.json() as Promise<Answer>, call);
  }

  #warned<Content>(
    asked: Call,
    read: (answer: Response) => Promise<Content>,
    call?: CallOptions,
  ): Promise<Warned<Content>> {
    const readAll = async (answer: Response): Promise<Warned<Content>> => ({
      content: await read(answer),
      warnings: warningCodes(answer),
    });
    return called(this.#transport, asked, readAll, call);
  }
}
