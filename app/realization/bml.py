"""Turns any BML file into a schedule on the clock of its recording.

BML's core has no word times, phones or agitation. Our own files record them, so that realizing a file gives exactly the
motion of the performance. For other files they are measured in the recording; without one the lips stay shut, and a
Notice says so.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from ..behavior.idle.stillness import stilled
from ..behavior.speech import emphases_s, phrases, visemes
from ..bml.markup.documents import Document
from ..bml.markup.speech import speech_of
from ..bml.reading.pawns import scene_of
from ..bml.reading.reader import read_bml
from ..bml.reading.record import Record, read_record
from ..bml.reading.resolving import ResolvedDocument, resolve
from ..model import DEFAULT_CHARACTER, Level, Notice, Schedule, Target, Word
from ..model.lead_in import later_s
from ..model.limits import MotionLimits
from ..model.performance import Progress, no_progress
from ..model.targets import check_targets
from ..option_table import MOTION
from ..text.transcript import read_transcript
from .motion import PreparedSchedule, last_s

if TYPE_CHECKING:
    from ..acoustic.models import AcousticModels


@dataclass(frozen=True, slots=True)
class BmlInput:
    """A BML file to be played: its content, its name in messages, the recording of its speech, and the limit on the
    number of its behaviours, if any."""

    bml: bytes
    name: Path
    audio: bytes | None = None
    limits: MotionLimits | None = None


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
    """The schedule of a BML file, on the clock of its recording.

    `agitation` overrides the level measured in the voice, `character` the name in the file, `seed` the recorded seed.
    `stillness` (0 to 1) reduces movement; `targets` are positions of things, which take precedence over the file's own.
    `acoustic` may be None if there is no recording. Raises WrongBmlError, TooLargeError, and InputError for unusable
    audio, words, targets or stillness; too many behaviours are refused before their times are resolved.
    """
    MOTION["stillness"].check(stillness)
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
        targets=scene_of(behaviors, targets, resolved.targets, resolved.places),
        asked=_asked(resolved, record),
    )
    told = (*notices, *speech.notices, *resolved.notices, *lip_notices)
    recorded = record.seed if record and record.seed is not None else 0
    return PreparedSchedule(prepared, told, recorded if seed is None else seed)


def _asked(resolved: ResolvedDocument, record: Record | None) -> dict[str, frozenset[str]]:
    """The sync points that the author of the file states: all but those of a performance as it was scheduled."""
    others = [each.id for each in resolved.behaviors if not (record and record.is_as_scheduled(each))]
    return {name: resolved.stated[name] for name in others}


def _read(sheet: BmlInput) -> tuple[Document, tuple[Notice, ...]]:
    """The document; raises TooLargeError if it has more behaviours than the limit."""
    document, notices = read_bml(sheet.bml, sheet.name)
    if sheet.limits is not None:
        sheet.limits.check_count(sum(1 for _ in document.root.children))
    return document, notices


@dataclass(frozen=True, slots=True)
class _Speech:
    """What is known of the speech: its words, the recording's length and agitation, and whether the notices already
    cover the lips."""

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
    """The speech that the file records; if its words or its recording differ, the speech measured in the recording."""
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
    from ..acoustic.signal.decoding import decode
    from ..acoustic.stage import audio_limits

    return decode(audio, audio_limits(acoustic.settings))[0].duration_s


def _heard(acoustic: AcousticModels, audio: bytes, text: str, progress: Progress) -> _Speech:
    """The speech measured in the recording, with its words if the file has a text."""
    from ..acoustic.stage import (  # slow to import, and only needed for recordings
        align_words,
        analyze_signal,
        measure_stress,
    )

    heard = analyze_signal(acoustic, audio, progress)
    speech = _Speech((), heard.audio.duration_s, heard.agitation.level, heard.notices)
    if not text:
        message = "the BML says no words to look for in the recording; give its <speech> a <text>"
        return replace(speech, notices=(*speech.notices, Notice("speech_missing", message)))
    transcript = read_transcript(text)
    progress("align")
    timed = align_words(acoustic, heard.audio, transcript)
    progress("stress")
    words, _thresholds = measure_stress(acoustic, timed.words, heard.contours, heard.audio)
    return replace(speech, words=words, notices=speech.notices + timed.notices)


def _schedule(resolved: ResolvedDocument, speech: _Speech) -> tuple[Schedule, tuple[Notice, ...]]:
    spoken_s = [word.interval.end_s for word in resolved.words if word.interval]
    heard_s = later_s(speech.duration_s, resolved.speech_start_s) if speech.duration_s else 0.0
    lips, notices = visemes(resolved.words, heard_s) if heard_s else ((), ())
    schedule = Schedule(
        behaviors=resolved.behaviors,
        duration_s=heard_s or max([last_s(resolved.behaviors), *spoken_s]),
        words=resolved.words,
        visemes=resolved.visemes or lips,
        phrases=phrases(resolved.words),
        emphases_s=emphases_s(resolved.words),
        agitation=resolved.agitation or speech.agitation or Level.MEDIUM,
        lead_in_s=resolved.speech_start_s,
    )
    return schedule, () if speech.complete else notices


def _together(recorded: float, stillness: float) -> float:
    """Combines two stillness factors."""
    return 1 - (1 - recorded) * (1 - stillness) if stillness else recorded


def _lips_unheard() -> tuple[Notice, ...]:
    return (Notice("lips_unheard", "there is no recording to take the lips from; send the audio with the BML"),)
