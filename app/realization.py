"""From a schedule to motion and its files (paper §3.8): ours straight from a performance, anybody's from BML.

BML of the core says no words' times, no phones and no agitation: with the recording these are heard; without it the
lips stay shut, and a Notice says so.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

from .bml.choice.characters import DEFAULT_CHARACTER
from .bml.choice.delivery import emphases_s, phrases
from .bml.choice.stillness import check_stillness, stilled
from .bml.choice.visemes import visemes
from .bml.markup.speech import speech_of
from .bml.reading.pawns import scene_of
from .bml.reading.reader import read_bml
from .bml.reading.resolving import Resolved, resolve
from .model import Behavior, FloatArray, Level, Notice, Performance, Schedule, Target, Word
from .motion_formats import FileOptions, Keys, MotionFormat, format_of
from .progress import Progress, no_progress
from .realizer.body.motion import Motion
from .realizer.exporting.arkit_csv import to_arkit_csv
from .realizer.exporting.avatar import to_avatar_glb
from .realizer.exporting.bvh import to_bvh
from .realizer.exporting.clip_json import to_clip_json
from .realizer.exporting.glb import to_glb
from .realizer.exporting.viseme_list import to_viseme_text
from .realizer.exporting.vrma import to_vrma
from .realizer.face.diphthongs import with_glides
from .realizer.face.lips import viseme_weights
from .realizer.pictures.contact_sheet import draw_sheet, moments_of
from .realizer.pictures.speed_plot import draw_speeds
from .realizer.realizing import Realizer, realize
from .targets import check_targets
from .transcript import read_transcript

if TYPE_CHECKING:
    from .analysis import SignalAnalysis
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
    """A BML file that is to be played: its content, its name in messages, and the recording of its speech."""

    bml: bytes
    name: Path
    audio: bytes | None = None


@dataclass(frozen=True, slots=True)
class PreparedSchedule:
    """A schedule ready for the realizer, and what was guessed or left out on the way."""

    schedule: Schedule
    notices: tuple[Notice, ...]


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
    )


def prepare_schedule(
    acoustic: AcousticModels | None,
    sheet: BmlInput,
    *,
    agitation: Level | None = None,
    character: str | None = None,
    stillness: float = 0.0,
    targets: tuple[Target, ...] = (),
    progress: Progress = no_progress,
) -> PreparedSchedule:
    """What a BML file has the body do, in the time of its recording.

    `agitation` overrides what the voice says, and `character` who is named in the file; `stillness` (0 to 1) is how
    much less than it says moves; `targets` are where things are, beside and before the file's own; `acoustic` may be
    None where there is no recording to hear. Raises WrongBmlError, TooLargeError, and InputError for audio, words,
    targets or a stillness that cannot be used.
    """
    check_stillness(stillness)
    check_targets(targets)
    document, notices = read_bml(sheet.bml, sheet.name)
    speech = speech_of(document)
    heard, words, word_notices = _heard(acoustic, sheet.audio, speech.text if speech else "", progress)
    progress("resolve")
    resolved = resolve(document, words)
    level = agitation or resolved.agitation or (heard.agitation.level if heard else Level.MEDIUM)
    schedule, lip_notices = _schedule(resolved, heard, level)
    named = replace(
        schedule,
        behaviors=stilled(schedule.behaviors, stillness),
        character=character or resolved.character or DEFAULT_CHARACTER,
        stillness=stillness,
        targets=scene_of(resolved.behaviors, targets, resolved.targets),
    )
    unheard_lips = _lips_unheard() if speech and not heard and not schedule.visemes else ()
    heard_notices = heard.notices if heard else ()
    return PreparedSchedule(
        named, (*notices, *heard_notices, *word_notices, *resolved.notices, *lip_notices, *unheard_lips)
    )


def _heard(
    acoustic: AcousticModels | None, audio: bytes | None, text: str, progress: Progress
) -> tuple[SignalAnalysis | None, tuple[Word, ...], tuple[Notice, ...]]:
    """What the recording says, and the words of the speech where it has them."""
    if audio is None or acoustic is None:
        return None, (), ()
    from .hearing import align_words, analyze_signal  # what hears takes long to import, and only recordings need it

    heard = analyze_signal(acoustic, audio, progress)
    if not text:
        message = "the BML says no words to look for in the recording; give its <speech> a <text>"
        return heard, (), (Notice("speech_missing", message),)
    transcript = read_transcript(text, max_characters=acoustic.settings.max_text_characters)
    timed, _thresholds = align_words(acoustic, heard, transcript, None, progress)
    return heard, timed.words, timed.notices


def _schedule(resolved: Resolved, heard: SignalAnalysis | None, level: Level) -> tuple[Schedule, tuple[Notice, ...]]:
    spoken_s = [word.interval.end_s for word in resolved.words if word.interval]
    heard_s = resolved.speech_start_s + heard.audio.duration_s if heard else 0.0
    lips, notices = visemes(resolved.words, heard_s) if heard else ((), ())
    schedule = Schedule(
        behaviors=resolved.behaviors,
        duration_s=heard_s or max([_last_s(resolved.behaviors), *spoken_s]),
        words=resolved.words,
        visemes=resolved.visemes or lips,
        phrases=phrases(resolved.words),
        emphases_s=emphases_s(resolved.words),
        agitation=level,
        lead_in_s=resolved.speech_start_s,
    )
    return schedule, notices


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
        MotionFormat.JSON: lambda: to_clip_json(motion, skeleton, rig, visemes=_viseme_weights(realized, realizer)),
        MotionFormat.CSV: lambda: to_arkit_csv(motion, skeleton),
        MotionFormat.VISEMES: lambda: to_viseme_text(schedule.visemes, schedule.duration_s),
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


def _viseme_weights(realized: Realized, realizer: Realizer) -> FloatArray | None:
    """The weights (T, 15) of the speech's visemes; None when nothing is said."""
    schedule = realized.schedule
    spoken = with_glides(schedule.visemes, schedule.words)
    return viseme_weights(realizer.face.visemes, spoken, realized.motion.body.times_s) if spoken else None
