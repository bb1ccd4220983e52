/** What the service takes and answers, by short names; all of it is generated from its OpenAPI document. */

import type { components } from "./schema.js";

type Schemas = components["schemas"];

export type PerformOptions = Schemas["PerformOptions"];
export type RealizeOptions = Schemas["RealizeOptions"];
export type GivenFunction = Schemas["GivenFunctionRequest"];
export type Direction = Schemas["DirectionRequest"];
export type Edits = Schemas["EditsForm"];
export type BehaviorEdit = Schemas["BehaviorEditForm"];
export type BehaviorReference = Schemas["BehaviorReferenceForm"];
export type Marks = Schemas["MarksForm"];
export type WordEdit = Schemas["WordEditForm"];
export type Performed = Schemas["PerformResponse"];
export type Performance = Schemas["PerformanceResponse"];
export type Behavior = Schemas["BehaviorResponse"];
export type FoundFunctions = Schemas["FunctionsResponse"];
export type ClipJson = Schemas["ClipResponse"];
export type Characters = Schemas["CharactersResponse"];
export type Gestures = Schemas["GesturesResponse"];
export type Rules = Schemas["RulesResponse"];
export type GestureValues = Schemas["GestureValues"];
export type GestureFrame = Schemas["FrameValues"];
export type GestureArm = Schemas["ArmValues"];
export type GestureTrack = Schemas["TrackValues"];
export type GestureLanguage = Schemas["GestureLanguageResponse"];
export type CheckedGestures = Schemas["GestureCheckResponse"];
export type PlacedMistake = Schemas["PlacedMistakeResponse"];
export type AvatarPose = Schemas["AvatarPoseResponse"];
export type RuleEdits = Schemas["RuleEditsRequest"];
export type RuleFile = Schemas["RuleFileResponse"];
export type RuleFiles = Schemas["RuleFilesResponse"];
export type RuleMistakes = Schemas["RuleCheckResponse"];
export type RuleExplanations = Schemas["RuleExplanationsResponse"];
export type RuleComparison = Schemas["RuleComparisonResponse"];
export type Status = Schemas["StatusResponse"];
export type Problem = Schemas["Problem"];

/** Bytes of a file: a Blob or File of a browser, or what Node reads. */
export type Bytes = Blob | Uint8Array<ArrayBuffer> | ArrayBuffer;

/** Words in time that were made elsewhere; the name's extension (.json, .TextGrid, .ctm) says their format. */
export interface NamedFile {
  readonly name: string;
  readonly content: Bytes;
}

/** A line: its recording (WAV, FLAC or OGG) and the words that are spoken, and what else is known of it. */
export interface PerformRequest {
  readonly audio?: Bytes;
  readonly text: string;
  readonly options?: PerformOptions;
  readonly words?: NamedFile;
  readonly functions?: readonly GivenFunction[];
  readonly direction?: Direction;
  /** What an author changed (docs/edits.md). */
  readonly edits?: Edits;
  /** Edited files of rules and words; they hold for this request only. */
  readonly rules?: RuleEdits;
  /** What `understudy reference` writes (.json), or another recording of the speaker. */
  readonly reference?: NamedFile;
  /** A gesture profile's file (docs/profiles.md), under whose name its gestures are made. */
  readonly profile?: NamedFile;
}

/** BML, and what it is played with. */
export interface RealizeRequest {
  readonly bml: string;
  /** The recording of the speech, for lips and words. */
  readonly audio?: Bytes;
  readonly options?: RealizeOptions;
  /** The motion model that moves the body to the recording: `default`, or one of the service's own lexicon (docs/motion-models.md). */
  readonly motion_model?: string;
  /** What drives the motion model: `S1` to `S6`, or `RTS`. */
  readonly scenario?: string;
}

/** BML for a GLB file: on the built-in mannequin, or on an `avatar` (GLB or VRM) of your own. */
export interface RealizeAvatarRequest extends RealizeRequest {
  readonly avatar?: Bytes;
}

/** How one request is made. */
export interface CallOptions {
  /** Ends the request, and waiting for the next attempt; the call then rejects with the signal's reason. */
  readonly signal?: AbortSignal;
  /** For all attempts together; the client's own unless given. */
  readonly timeoutMs?: number;
}
