"""The Python interface, which `import understudy` re-exports, for programs that need neither command line nor service.

Models are loaded once (`load`) and shared by threads. Audio, BML and words timed elsewhere are given as the name of a
file or as its content; every `write_…` returns the content of a file. Times are seconds from the start of the audio. A
mistake of the caller's raises an `InputError` with a stable code (docs/errors.md), a file that cannot be opened an
OSError. docs/python.md has examples.
"""

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path, PurePath
from typing import Any, Literal, TypedDict, Unpack

from .acoustic.alignment.timings import to_ctm, to_textgrid
from .acoustic.stage import AcousticModels, analyze_signal
from .acoustic.stage import align as _align
from .acoustic.stage import make_reference as _make_reference
from .bml.writing.writer import write_bml as _write_bml
from .bml.writing.writer import write_bml_json as _write_bml_json
from .bml.writing.writer import write_listener as _write_listener
from .bml.writing.writer import write_speech_file as _write_speech_file
from .errors import InputError
from .model import (
    AlignedLine,
    Analysis,
    Direction,
    GivenFunction,
    Level,
    Line,
    Mode,
    Performance,
    Timings,
    Tone,
)
from .model.edits import NO_EDITS, Edits
from .model.formats.bml_form import BmlForm, DialectName, TimeForm, VisemeNames
from .model.formats.motion_formats import AudioFile, BapVersion
from .model.lead_in import with_lead_in
from .model.targets import targets_of
from .model.voice.speaker_reference import SpeakerReference
from .models import LanguageModels, Understudy
from .performance import analyze as _analyze
from .performance import perform as _perform
from .realization import (
    AvatarOptions,
    BmlInput,
    Keys,
    MotionFormat,
    PreparedSchedule,
    Realized,
    Realizer,
    format_of,
    prepare_schedule,
    realize_prepared,
)
from .realization import write_motion as _write_motion
from .rules.stage import find_functions as _find_functions
from .schemas.edits import read_edits
from .schemas.options import RealizeOptions, check_options, check_realize_options
from .schemas.requests import read_timings
from .schemas.response_model import ResponseModel
from .schemas.responses import AlignResponse, AnalysisResponse, FunctionsResponse, PerformanceResponse
from .schemas.spoken_lines import spoken_line
from .settings import Settings, read_settings

FileSource = bytes | str | os.PathLike[str]
"""A file: its content, or its name."""

LevelName = Level | Literal["low", "medium", "high"]


AffectName = Tone | Literal["neutral", "happy", "sad", "angry", "afraid", "disgusted", "surprised"]


class PerformKeywords(TypedDict, total=False):
    """How a line is to be performed; for what is left out, the defaults of `Options` hold.

    `character` names the performer (lexicon/characters), `agitation` overrides the measured level, `affect` the feeling
    that is heard: a tone, activation, valence and dominance (-1 to 1), or rows of a time and these; `seed` draws
    other takes among movements that are nearly as good, `choice` is `terms` or the paper's `priority`, `mode` says
    where gestures come from, `listener` has the names of the listeners, and `reference` is how the speaker usually
    sounds (`make_reference`). The performance begins `lead_in_s` (0 to 3) before the recording; `stillness` (0 to 1)
    reduces all movement. `targets` are the positions of things and listeners, [x, y, z] in metres by name: Y up, the
    character at the origin facing +Z, its left +X. `profile` names a
    gesture profile (docs/profiles.md).
    """

    character: str
    agitation: LevelName | None
    affect: AffectName | Sequence[float] | Sequence[Sequence[float]] | None
    seed: int
    choice: Literal["terms", "priority"] | None
    mode: Mode | Literal["semantic", "prosody", "random"]
    listener: Sequence[str]
    reference: SpeakerReference | None
    lead_in_s: float
    stillness: float
    targets: Mapping[str, Sequence[float]]
    profile: str | None


class RealizeKeywords(TypedDict, total=False):
    """How BML is to be played: `agitation` overrides the measured level, `character` the one named in the file; `fps`
    is 30 or 60, `seed` varies idle movement, `stillness` (0 to 1) reduces all movement, `targets` are the positions of
    things (as for performances), `tail_s` (0 to 10) is how long the motion goes on after the recording; `physics`
    simulates a body with mass."""

    agitation: LevelName | None
    character: str | None
    fps: Literal[30, 60]
    seed: int
    stillness: float
    targets: Mapping[str, Sequence[float]]
    tail_s: float
    physics: bool


def load(settings: Settings | None = None, *, lexicon: Sequence[str | os.PathLike[str]] = ()) -> Understudy:
    """Loads models, rules, words and gestures, which takes seconds; threads may share them. Use the result in a `with`
    block, or `close` it: the aligner has a process of its own.

    `lexicon` are an author's folders of words, rules, gestures, characters and profiles, laid over the bundled ones
    (docs/authoring.md) besides those of the settings.

    Without `settings` those of the environment hold (docs/settings.md). Raises InputError `setting_wrong`,
    AuthoringError with every mistake in rules, words and gestures, ServiceError for a model that does not load.
    """
    settings = settings or read_settings()
    folders = (*settings.lexicon_folders, *map(Path, lexicon))
    return Understudy.load(settings.model_copy(update={"lexicon": os.pathsep.join(map(str, folders)) or None}))


def perform(
    models: Understudy,
    audio: FileSource,
    text: str,
    *,
    words: FileSource | Timings | None = None,
    functions: Sequence[GivenFunction] = (),
    direction: Direction | None = None,
    edits: FileSource | Edits = NO_EDITS,
    **options: Unpack[PerformKeywords],
) -> Performance:
    """The performance of a recorded line, with the reason for each movement (Marsella et al. 2013, §3).

    `audio` is a WAV, FLAC or OGG file, `text` what is said in it. `words` are timings made elsewhere (the name of a
    .json, .TextGrid or .ctm file, or `Timings`), which replace the alignment. `functions` are communicative functions
    that the caller already knows, `direction` is a director's notes (docs/directing.md), `edits` are an author's
    changes (docs/edits.md). Raises InputError for input that cannot be used.
    """
    fields: dict[str, Any] = {**options}
    reference = fields.pop("reference", None)
    line = replace(_line(audio, text, words, functions), direction=direction)
    made = edits if isinstance(edits, Edits) else read_edits(_content(edits))
    return _perform(models, line, replace(check_options(fields), reference=reference).with_edits(made))


def say(
    models: Understudy,
    text: str,
    *,
    words: FileSource | Timings | None = None,
    functions: Sequence[GivenFunction] = (),
    direction: Direction | None = None,
    edits: FileSource | Edits = NO_EDITS,
    **options: Unpack[PerformKeywords],
) -> Performance:
    """The performance of a line without a recording, timed as it is usually spoken (Hartmann, Mancini & Pelachaud 2002,
    §5, with a synthesizer's times in `words`).

    `text` may mark *emphasis*, or be XML with the tags of SSML, APML and our own (docs/say.md). The other arguments are
    those of `perform`; agitation is medium and the feeling neutral unless given. Raises InputError as `perform` does,
    and `tags_wrong`.
    """
    fields: dict[str, Any] = {**options}
    reference = fields.pop("reference", None)
    line = spoken_line(text, _timings(words), tuple(functions), direction)
    made = edits if isinstance(edits, Edits) else read_edits(_content(edits))
    return _perform(models, line, replace(check_options(fields), reference=reference).with_edits(made))


def analyze(
    models: Understudy,
    audio: FileSource,
    text: str,
    *,
    words: FileSource | Timings | None = None,
    functions: Sequence[GivenFunction] = (),
    reference: SpeakerReference | None = None,
) -> Analysis:
    """The analysis of a line before any movement is chosen: prosody, words, communicative functions (§3.1 to §3.3).
    Arguments and errors are those of `perform`."""
    return _analyze(models, _line(audio, text, words, functions), reference=reference)


def align(models: Understudy | AcousticModels, audio: FileSource, text: str) -> AlignedLine:
    """The times of a line's words and phones, and of the fillers ("um") between them (§3.1). `AcousticModels` suffice.

    Raises InputError for audio or text that cannot be used.
    """
    acoustic = models.acoustic if isinstance(models, Understudy) else models
    return _align(acoustic, _line(audio, text))


def find_functions(models: Understudy | LanguageModels, text: str) -> Analysis:
    """The communicative functions of the words alone (§3.2, §3.3); without a recording, nothing has a time.
    `LanguageModels` suffice.

    Raises InputError for a text that is too long or not well formed.
    """
    return _find_functions(models.language if isinstance(models, Understudy) else models, text)


def make_reference(models: Understudy | AcousticModels, recordings: Sequence[FileSource]) -> SpeakerReference:
    """How the speaker of these recordings, one or more, usually sounds: the baseline for the speaker's agitation
    (§3.1.4).

    Raises InputError for audio that cannot be used, and `value_wrong` when there is none.
    """
    if not recordings:
        raise InputError("value_wrong", "recordings: give one at least", field="recordings")
    acoustic = models.acoustic if isinstance(models, Understudy) else models
    return _make_reference(acoustic, [analyze_signal(acoustic, _content(each)) for each in recordings])


def realize(
    models: Understudy | Realizer,
    performance: Performance,
    *,
    fps: Literal[30, 60] = 60,
    seed: int | None = None,
    tail_s: float = 0.0,
    physics: bool = False,
) -> Realized:
    """The motion of a performance (§3.8), frame by frame, as long as its recording plus `tail_s`, in which the hands
    come to rest; `seed` is the performance's own unless given. `physics` simulates a body with mass (ServiceError
    `physics_missing` without understudy[physics]). `Realizer` suffices.

    `realized.motion.decisions` says what could not be played as it was asked for, and why.
    """
    checked = check_realize_options({"fps": fps, "seed": seed, "tail_s": tail_s, "physics": physics})
    prepared = PreparedSchedule.of(performance)
    return _played(models, prepared if seed is None else replace(prepared, seed=seed), checked)


def realize_bml(
    models: Understudy, bml: FileSource, audio: FileSource | None = None, **options: Unpack[RealizeKeywords]
) -> Realized:
    """The motion of BML, ours or others'. With the recording the lips move, and marks of the speech fall where its
    words are heard; without it `realized.motion.notices` says what was missing.

    Raises WrongBmlError with every mistake in the BML, InputError for audio, words and options that cannot be used.
    """
    checked = check_realize_options({**options})
    heard = None if audio is None else _content(audio)
    name = Path("BML") if isinstance(bml, bytes) else Path(bml)
    prepared = prepare_schedule(
        models.acoustic,
        BmlInput(_content(bml), name, heard),
        agitation=checked.agitation,
        character=checked.character,
        stillness=checked.stillness,
        targets=targets_of(checked.targets),
        seed=checked.seed,
    )
    return _played(models, prepared, checked)


def write_bml(
    performance: Performance,
    *,
    dialect: DialectName | Literal["bml", "smartbody"] = DialectName.BML,
    timing: TimeForm | Literal["absolute", "sync"] = TimeForm.ABSOLUTE,
    audio_name: str | None = None,
    bmlt_audio: bool = False,
    listener: str | None = None,
) -> bytes:
    """The schedule as BML, XML in UTF-8 (docs/bml.md), in BML 1.0 or SmartBody's dialect.

    With `timing` "sync", times refer to sync points of the speech instead of being seconds; `audio_name` is the name of
    the recording's file, by which SmartBody (`write_speech_file`) and, with `bmlt_audio`, ASAP find it. With `listener`
    the result is that listener's behaviour instead. Raises InputError `value_wrong`.
    """
    form = replace(_bml_form(dialect, timing, audio_name), bmlt_audio=bmlt_audio)
    if listener is None:
        return _write_bml(performance, form)
    for listening in performance.listeners:
        if listening.name == listener:
            return _write_listener(performance, listening, form)
    known = ", ".join(each.name for each in performance.listeners) or "nobody"
    raise InputError("value_wrong", f"no listener is called {listener!r}; {known} listens", field="listener")


def write_speech_file(
    performance: Performance,
    audio_name: str,
    *,
    visemes: VisemeNames | Literal["smartbody", "facefx"] = VisemeNames.SMARTBODY,
) -> bytes:
    """NAME.bml, which SmartBody needs beside NAME.wav: the times of words and visemes, the visemes named as in
    SmartBody's own characters or in FaceFX. `audio_name` is NAME. Raises InputError `value_wrong`."""
    form = check_options({"dialect": DialectName.SMARTBODY, "visemes": visemes}).form
    found = _write_speech_file(performance, replace(form, audio_file=audio_name))
    return found.content if found else b""


def write_bml_json(
    performance: Performance,
    *,
    dialect: DialectName | Literal["bml", "smartbody"] = DialectName.BML,
    timing: TimeForm | Literal["absolute", "sync"] = TimeForm.ABSOLUTE,
    audio_name: str | None = None,
) -> bytes:
    """The same document as JSON (docs/bml-json.md)."""
    return _write_bml_json(performance, _bml_form(dialect, timing, audio_name))


def write_json(found: Performance | Analysis | AlignedLine, *, indent: int | None = None) -> bytes:
    """All of a performance, an analysis or an alignment as JSON, in the schemas of the command line and the service."""
    return _response(found).to_json(indent)


def write_textgrid(found: Performance | Analysis | AlignedLine) -> bytes:
    """The times of words and phones as a Praat TextGrid with the tiers "words" and "phones"."""
    timed = _aligned(found)
    return to_textgrid(timed.words, timed.duration_s).encode()


def write_ctm(found: Performance | Analysis | AlignedLine, name: str = "audio") -> bytes:
    """The times of the words as CTM, one word a line; `name` is the recording's name in it."""
    return to_ctm(_aligned(found).words, name).encode()


class MotionFileKeywords(TypedDict, total=False):
    """How a motion's file is written; for what is left out, the defaults of `FileOptions` hold.

    With `t_pose` BVH begins with a T-pose, with `root_at_origin` its root has OFFSET zero; `keys` are those of GLB,
    `bap_version` says whose body parameters BAP has;
    `audio` is the recording's file, which USD refers to or contains (docs/motion-formats.md).
    """

    t_pose: bool
    root_at_origin: bool
    keys: Keys | Literal["baked", "sparse"]
    bap_version: BapVersion | Literal["3.1", "2.1"]
    audio: str | os.PathLike[str] | None


def write_motion(
    models: Understudy | Realizer,
    realized: Realized,
    form: MotionFormat | str,
    *,
    skeleton: str | None = None,
    avatar: FileSource | None = None,
    **written: Unpack[MotionFileKeywords],
) -> bytes:
    """The motion as `form`, a `MotionFormat` or the name of a file that ends in one ("line.glb", or "glb" alone).

    `skeleton` names the joints of BVH and JSON as another rig does, `avatar` is a GLB or VRM file to which the motion
    is applied in GLB. Raises InputError `motion_format`, `unknown_skeleton`, `unknown_avatar`, UndecodableError
    `avatar_undecodable`, ServiceError `usd_missing`, `blender_missing` and `blender_failed`, and ModuleNotFoundError
    for a picture without matplotlib.
    """
    motion_format = form if isinstance(form, MotionFormat) else format_of(f".{PurePath(form).name}")
    wearer = AvatarOptions(skeleton, None if avatar is None else _content(avatar))
    audio = written.pop("audio", None)
    options = check_realize_options(dict(written))
    recording = None if audio is None else AudioFile(os.fspath(audio), _content(audio))
    files = replace(options.files, audio=recording, blender=read_settings().blender)
    return _write_motion(realized, _realizer(models), motion_format, wearer, files)


def _line(
    audio: FileSource,
    text: str,
    words: FileSource | Timings | None = None,
    functions: Sequence[GivenFunction] = (),
) -> Line:
    return Line(_content(audio), text, _timings(words), tuple(functions))


def _content(source: FileSource) -> bytes:
    return source if isinstance(source, bytes) else Path(source).read_bytes()


def _timings(words: FileSource | Timings | None) -> Timings | None:
    if words is None or isinstance(words, Timings):
        return words
    if isinstance(words, bytes):
        message = "words: bytes do not tell their format; give the name of a file, or Timings(content, format)"
        raise InputError("timings_format", message, field="words")
    return read_timings(os.fspath(words), _content(words))


def _bml_form(dialect: str, timing: str, audio_name: str | None) -> BmlForm:
    checked = check_options({"dialect": dialect, "timing": timing}).form
    return replace(checked, audio_file=audio_name)


def _played(models: Understudy | Realizer, prepared: PreparedSchedule, options: RealizeOptions) -> Realized:
    return realize_prepared(
        _realizer(models),
        prepared,
        frame_rate_hz=options.fps,
        tail_s=options.tail_s,
        physics=bool(options.physics),
    )


def _realizer(models: Understudy | Realizer) -> Realizer:
    return models.realizer if isinstance(models, Understudy) else models


def _aligned(found: Performance | Analysis | AlignedLine) -> AlignedLine:
    """The words with their times in the recording; raises InputError `value_wrong` if there was no recording."""
    if isinstance(found, AlignedLine):
        return found
    utterance = with_lead_in(found.utterance, 0.0)
    if utterance.duration_s is None:
        raise InputError("value_wrong", "nothing was heard, so no word has a time; align or analyze the recording")
    return AlignedLine(utterance.words, utterance.duration_s, found.notices, utterance.fillers)


def _response(found: Performance | Analysis | AlignedLine) -> ResponseModel:
    match found:
        case Performance():
            return PerformanceResponse.of_performance(found)
        case AlignedLine():
            return AlignResponse.of(found)
        case Analysis() if found.utterance.duration_s is None:
            return FunctionsResponse.of(found)
        case Analysis():
            return AnalysisResponse.of(found)
