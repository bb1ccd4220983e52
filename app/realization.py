"""From a schedule to motion and its files (paper §3.8): ours straight from a performance, anybody's from BML.

BML of the core says no words' times, no phones and no agitation. Ours has them in the record of its speech, so that
realizing it makes the very motion of the performance; of others they are heard in the recording, without which the lips
stay shut, and a Notice says so.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

from .bml.choice.characters.characters import DEFAULT_CHARACTER
from .bml.choice.speech.delivery import emphases_s, phrases
from .bml.choice.speech.lead_in import later_s
from .bml.choice.speech.visemes import visemes
from .bml.choice.stillness import check_stillness, stilled
from .bml.markup.documents import Document
from .bml.markup.speech import speech_of
from .bml.reading.pawns import scene_of
from .bml.reading.reader import read_bml
from .bml.reading.record import Record, read_record
from .bml.reading.resolving import Resolved, resolve
from .editorial.annotations import to_elan, to_textgrid
from .editorial.events import timeline_events, tracks_of
from .editorial.table import to_event_table
from .editorial.timeline import to_otio
from .model import Behavior, Channel, FloatArray, Level, Notice, Performance, Schedule, Target, Word
from .motion_formats import EDITORIAL, SCENES, AudioFile, FileOptions, Keys, MotionFormat, format_of
from .motion_limits import MotionLimits
from .progress import Progress, no_progress
from .realizer.body.motion import Motion
from .realizer.exporting.arkit_csv import to_arkit_csv
from .realizer.exporting.avatar import to_avatar_glb
from .realizer.exporting.bvh import to_bvh
from .realizer.exporting.clip_json import to_clip_json
from .realizer.exporting.extras import require_usd
from .realizer.exporting.fbx.conversion import to_fbx
from .realizer.exporting.glb import to_glb
from .realizer.exporting.mpeg4.bap import to_bap
from .realizer.exporting.mpeg4.fap import TABLE, FapTable, to_fap
from .realizer.exporting.viseme_list import to_viseme_text
from .realizer.exporting.vrma import to_vrma
from .realizer.face.diphthongs import with_glides
from .realizer.face.lips import viseme_weights
from .realizer.gestures.library import LAST_RESORT
from .realizer.pictures.contact_sheet import draw_sheet, moments_of
from .realizer.pictures.speed_plot import draw_speeds
from .realizer.realizing import Realizer, realize
from .resources import resource_folder
from .targets import check_targets
from .transcript import read_transcript
from .yaml_files import did_you_mean

if TYPE_CHECKING:
    from .hearing import AcousticModels

__all__ = [
    "AvatarOptions",
    "BmlInput",
    "FileOptions",
    "Keys",
    "MotionFormat",
    "PreparedSchedule",
    "Realized",
    "Realizer",
    "format_of",
    "prepare_schedule",
    "realize",
    "realize_prepared",
    "schedule_of",
    "write_motion",
]


VRM, MIXAMO = "vrm", "mixamo"
_RIGS: Mapping[MotionFormat, str] = MappingProxyType({MotionFormat.BVH: MIXAMO})
"""Whose names joints go by where nobody says; others than these VRM's, as ours are."""


@dataclass(frozen=True, slots=True)
class AvatarOptions:
    """Who is to wear the motion: the rig whose names joints go by in BVH and the clip, and the avatar, a GLB or VRM
    file, that a GLB has instead of our mannequin."""

    rig: str | None = None
    avatar: bytes | None = None


OURS = AvatarOptions()
USUAL = FileOptions()


@dataclass(frozen=True, slots=True, eq=False)
class Realized:
    """A schedule and its motion."""

    schedule: Schedule
    motion: Motion


@dataclass(frozen=True, slots=True)
class BmlInput:
    """A BML file that is to be played: its content, its name in messages, the recording of its speech, and what limits
    the number of its behaviours, if anything does."""

    bml: bytes
    name: Path
    audio: bytes | None = None
    limits: MotionLimits | None = None


@dataclass(frozen=True, slots=True)
class PreparedSchedule:
    """A schedule ready for the realizer, what was guessed or left out on the way, and the seed of all chance."""

    schedule: Schedule
    notices: tuple[Notice, ...]
    seed: int = 0

    @classmethod
    def of(cls, performance: Performance) -> PreparedSchedule:
        """What a performance has the body do."""
        return cls(schedule_of(performance), performance.notices, performance.seed)


def schedule_of(performance: Performance) -> Schedule:
    """What a performance has the body do."""
    utterance = performance.utterance
    behaviors = tuple(behavior for behavior in performance.behaviors if behavior.kept)
    return Schedule(
        behaviors=behaviors,
        duration_s=utterance.duration_s or _last_s(behaviors),
        words=utterance.words,
        visemes=performance.visemes,
        phrases=phrases(utterance.words),
        emphases_s=emphases_s(utterance.words),
        agitation=utterance.agitation.level if utterance.agitation else Level.MEDIUM,
        character=performance.character,
        lead_in_s=utterance.lead_in_s,
        stillness=performance.stillness,
        targets=performance.targets,
        functions=tuple(function for function in performance.functions if function.kept),
    )


def prepare_schedule(
    acoustic: AcousticModels | None,
    sheet: BmlInput,
    *,
    agitation: Level | None = None,
    character: str | None = None,
    stillness: float = 0.0,
    targets: tuple[Target, ...] = (),
    seed: int | None = None,
    progress: Progress = no_progress,
) -> PreparedSchedule:
    """What a BML file has the body do, in the time of its recording.

    `agitation` overrides what the voice says, `character` who is named in the file, and `seed` the one it records;
    `stillness` (0 to 1) is how much less than it says moves; `targets` are where things are, beside and before the
    file's own; `acoustic` may be None where there is no recording to hear. Raises WrongBmlError, TooLargeError, and
    InputError for audio, words, targets or a stillness that cannot be used, and for too many behaviours before their
    times are sought.
    """
    check_stillness(stillness)
    check_targets(targets)
    document, notices = _read(sheet)
    record = read_record(document)
    speech = _speech(acoustic, sheet.audio, document, record, progress)
    progress("resolve")
    resolved = resolve(document, speech.words)
    schedule, lip_notices = _schedule(resolved, speech)
    behaviors = tuple(map(record.completed, schedule.behaviors)) if record else schedule.behaviors
    prepared = replace(
        schedule,
        behaviors=stilled(behaviors, stillness),
        agitation=agitation or schedule.agitation,
        character=character or resolved.character or DEFAULT_CHARACTER,
        stillness=_together(record.stillness if record else 0.0, stillness),
        targets=scene_of(behaviors, targets, resolved.targets),
    )
    told = (*notices, *speech.notices, *resolved.notices, *lip_notices)
    recorded = record.seed if record and record.seed is not None else 0
    return PreparedSchedule(prepared, told, recorded if seed is None else seed)


def _read(sheet: BmlInput) -> tuple[Document, tuple[Notice, ...]]:
    """The document, if it has no more behaviours than its limits allow."""
    document, notices = read_bml(sheet.bml, sheet.name)
    if sheet.limits is not None:
        sheet.limits.check_count(sum(1 for _ in document.root.children))
    return document, notices


def realize_prepared(
    realizer: Realizer,
    prepared: PreparedSchedule,
    *,
    frame_rate_hz: int = 60,
    tail_s: float = 0.0,
    physics: bool = False,
) -> Realized:
    """The motion of a schedule, whose notices tell also which gestures are not those that were asked for."""
    schedule, seed = prepared.schedule, prepared.seed
    motion = realize(realizer, schedule, frame_rate_hz=frame_rate_hz, seed=seed, tail_s=tail_s, physics=physics)
    notices = (*prepared.notices, *_unknown_gestures(realizer, schedule), *_unplayed_gestures(motion, schedule))
    return Realized(schedule, replace(motion, notices=notices))


def _unknown_gestures(realizer: Realizer, schedule: Schedule) -> Iterator[Notice]:
    library = realizer.library
    for gesture in _gestures(schedule):
        if library.nearest(gesture.lexeme) == LAST_RESORT and gesture.lexeme != LAST_RESORT:
            hint = did_you_mean(gesture.lexeme, library.categories)
            message = f"{gesture.id} is played as a {LAST_RESORT}: no gesture is called {gesture.lexeme!r}{hint}"
            yield Notice("gesture_unknown", message)


def _unplayed_gestures(motion: Motion, schedule: Schedule) -> Iterator[Notice]:
    names = {gesture.id for gesture in _gestures(schedule)}
    for told in motion.decisions:
        if told.behavior in names and told.action == "dropped":
            yield Notice("gesture_not_played", f"{told.behavior} is not played: {told.reason}")


def _gestures(schedule: Schedule) -> Iterator[Behavior]:
    return (each for each in schedule.behaviors if each.kept and each.kind is Channel.GESTURE)


@dataclass(frozen=True, slots=True)
class _Speech:
    """What is known of a speech: its words from the start of the recording, how long that is and how agitated, and
    whether the notices tell of its lips too."""

    words: tuple[Word, ...] = ()
    duration_s: float | None = None
    agitation: Level | None = None
    notices: tuple[Notice, ...] = ()
    complete: bool = False


def _speech(
    acoustic: AcousticModels | None,
    audio: bytes | None,
    document: Document,
    record: Record | None,
    progress: Progress,
) -> _Speech:
    """The speech as the file records it, unless its words or the recording are others; then as it is heard."""
    recorded = _recorded(record) if record else _Speech()
    if audio is None or acoustic is None:
        spoken = speech_of(document) is not None and not recorded.words
        return replace(recorded, notices=recorded.notices + (_lips_unheard() if spoken else ()))
    if recorded.words and recorded.duration_s == _duration_s(acoustic, audio):
        return recorded
    found = speech_of(document)
    return _heard(acoustic, audio, found.text if found else "", progress)


def _recorded(record: Record) -> _Speech:
    return _Speech(record.words, record.duration_s, record.agitation, record.notices, complete=True)


def _duration_s(acoustic: AcousticModels, audio: bytes) -> float:
    from .acoustic.signal.decoding import decode
    from .hearing import audio_limits

    return decode(audio, audio_limits(acoustic.settings))[0].duration_s


def _heard(acoustic: AcousticModels, audio: bytes, text: str, progress: Progress) -> _Speech:
    """What the recording says, and the words of the speech where it has them."""
    from .hearing import align_words, analyze_signal  # what hears takes long to import, and only recordings need it

    heard = analyze_signal(acoustic, audio, progress)
    speech = _Speech((), heard.audio.duration_s, heard.agitation.level, heard.notices)
    if not text:
        message = "the BML says no words to look for in the recording; give its <speech> a <text>"
        return replace(speech, notices=(*speech.notices, Notice("speech_missing", message)))
    transcript = read_transcript(text, max_characters=acoustic.settings.max_text_characters)
    timed, _thresholds = align_words(acoustic, heard, transcript, None, progress)
    return replace(speech, words=timed.words, notices=speech.notices + timed.notices)


def _schedule(resolved: Resolved, speech: _Speech) -> tuple[Schedule, tuple[Notice, ...]]:
    spoken_s = [word.interval.end_s for word in resolved.words if word.interval]
    heard_s = later_s(speech.duration_s, resolved.speech_start_s) if speech.duration_s else 0.0
    lips, notices = visemes(resolved.words, heard_s) if heard_s else ((), ())
    schedule = Schedule(
        behaviors=resolved.behaviors,
        duration_s=heard_s or max([_last_s(resolved.behaviors), *spoken_s]),
        words=resolved.words,
        visemes=resolved.visemes or lips,
        phrases=phrases(resolved.words),
        emphases_s=emphases_s(resolved.words),
        agitation=resolved.agitation or speech.agitation or Level.MEDIUM,
        lead_in_s=resolved.speech_start_s,
    )
    return schedule, () if speech.complete else notices


def _together(recorded: float, stillness: float) -> float:
    """How still a body is that was made so still twice."""
    return 1 - (1 - recorded) * (1 - stillness) if stillness else recorded


def _last_s(behaviors: tuple[Behavior, ...]) -> float:
    return max((behavior.sync.end for behavior in behaviors), default=0.0)


def _lips_unheard() -> tuple[Notice, ...]:
    return (Notice("lips_unheard", "there is no recording to take the lips from; send the audio with the BML"),)


def write_motion(
    realized: Realized,
    realizer: Realizer,
    form: MotionFormat,
    wearer: AvatarOptions = OURS,
    options: FileOptions = USUAL,
) -> bytes:
    """The motion in a format, for whoever wears it.

    Raises InputError `unknown_skeleton` and `unknown_avatar`, UndecodableError `avatar_undecodable`.
    """
    motion, schedule = realized.motion, realized.schedule
    performer = realizer.performer(schedule.character)
    skeleton, looks = performer.skeleton, performer.looks
    rig = realizer.rig(wearer.rig or _RIGS.get(form, VRM))
    writers: Mapping[MotionFormat, Callable[[], bytes]] = {
        MotionFormat.BVH: lambda: to_bvh(
            motion, skeleton, rig, t_pose=options.t_pose, root_at_origin=options.root_at_origin
        ),
        MotionFormat.GLB: lambda: _glb(realized, realizer, wearer.avatar, options.keys),
        MotionFormat.VRMA: lambda: to_vrma(motion, skeleton),
        **{form: partial(_usd, realized, realizer, form, options.audio) for form in SCENES},
        MotionFormat.FBX: lambda: to_fbx(
            _glb(realized, realizer, wearer.avatar, Keys.BAKED),
            len(motion.body.times_s),
            motion.frame_rate_hz,
            blender=options.blender,
        ),
        MotionFormat.JSON: lambda: to_clip_json(motion, skeleton, rig, visemes=_viseme_weights(realized, realizer)),
        MotionFormat.CSV: lambda: to_arkit_csv(motion, skeleton),
        MotionFormat.VISEMES: lambda: to_viseme_text(schedule.visemes, schedule.duration_s),
        MotionFormat.BAP: lambda: to_bap(motion, skeleton, options.bap),
        MotionFormat.FAP: lambda: to_fap(motion, skeleton, FapTable.load(resource_folder("lexicon") / TABLE)),
        **{form: partial(_editorial, realized, form, options.audio) for form in EDITORIAL},
        MotionFormat.SHEET: lambda: draw_sheet(motion, skeleton, moments_of(motion, schedule), looks=looks),
        MotionFormat.SPEEDS: lambda: draw_speeds(motion, skeleton, schedule),
    }
    return writers[form]()


def _glb(realized: Realized, realizer: Realizer, avatar: bytes | None, keys: Keys) -> bytes:
    """On the caller's avatar, or on the character's mannequin."""
    performer = realizer.performer(realized.schedule.character)
    sparse_for = realized.schedule.behaviors if keys is Keys.SPARSE else None
    if avatar is None:
        return to_glb(realized.motion, performer.skeleton, performer.looks, sparse_for=sparse_for)
    return to_avatar_glb(realized.motion, performer.skeleton, avatar, realizer.rigs, sparse_for=sparse_for)


def _usd(realized: Realized, realizer: Realizer, form: MotionFormat, audio: AudioFile | None) -> bytes:
    """Raises ServiceError `usd_missing`."""
    require_usd()
    from .realizer.exporting.usd.stage import UsdForm, to_usd  # an extra, which most do without

    performer = realizer.performer(realized.schedule.character)
    return to_usd(
        realized.motion,
        performer.skeleton,
        UsdForm(form.value.removeprefix(".")),
        performer.looks,
        behaviors=realized.schedule.behaviors,
        audio=audio,
    )


def _editorial(realized: Realized, form: MotionFormat, audio: AudioFile | None) -> bytes:
    """Functions and movements in time, for those who cut, annotate and count."""
    schedule, motion = realized.schedule, realized.motion
    events, lead_in_s = timeline_events(schedule, motion.realized), schedule.lead_in_s
    match form:
        case MotionFormat.OTIO:
            lasting = {"lead_in_s": lead_in_s, "duration_s": schedule.duration_s}
            return to_otio(events, motion.frame_rate_hz, audio=audio, **lasting)
        case MotionFormat.EVENTS:
            return to_event_table(events, clock_starts_s=lead_in_s)
    tracks = tracks_of(events, clock_starts_s=lead_in_s, words=schedule.words)
    if form is MotionFormat.EAF:
        return to_elan(tracks, audio.name if audio else "")
    return to_textgrid(tracks, schedule.duration_s - lead_in_s)


def _viseme_weights(realized: Realized, realizer: Realizer) -> FloatArray | None:
    """The weights (T, 15) of the speech's visemes; None when nothing is said."""
    schedule = realized.schedule
    spoken = with_glides(schedule.visemes, schedule.words)
    return viseme_weights(realizer.face.visemes, spoken, realized.motion.body.times_s) if spoken else None
