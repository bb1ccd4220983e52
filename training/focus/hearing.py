"""Recordings with a known focus, or none, as the analysis hears them: the network's inputs and what it should say.

Folders are as `speaking.py` and `refocusing.py` make them. The aligner's times are kept beside the recordings
(`alignments.jsonl`), since it takes most of the time; all else is measured anew.
"""

import json
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import yaml

from understudy.acoustic.alignment.aligner import Aligner
from understudy.acoustic.focus.focus_model import inputs
from understudy.acoustic.focus.listeners import Listeners
from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.acoustic.stage import contours_of
from understudy.acoustic.stress import prominence
from understudy.errors import UnderstudyError
from understudy.model import Audio, FloatArray, Interval, Phone, Word
from understudy.text.transcript import read_transcript

ROOT = Path(__file__).resolve().parents[2]
ALIGNMENTS = "alignments.jsonl"
PROMINENCE_SHARE = 0.3
"""What the log odds of syllables' prominence weigh beside those of listeners: so the two agree best with which words
TIMIT's speakers accent."""

LEAST = 1e-4


@dataclass(frozen=True, slots=True, eq=False)
class HeardLine:
    """A recording: the network's inputs (words × inputs), which words have the focus (all 0 where none is known), and
    each word's log odds of emphasis as listeners and syllables' prominence have it."""

    name: str
    voice: str
    texts: tuple[str, ...]
    given: FloatArray
    focused: FloatArray
    emphasis: FloatArray


def hear(folder: Path, texts: dict[str, str], models: tuple[Aligner, Listeners]) -> Iterator[HeardLine]:
    """All recordings of a folder but those in which the aligner does not find the words."""
    kept = {entry["path"]: entry["words"] for entry in _entries([folder / ALIGNMENTS])}
    with (folder / ALIGNMENTS).open("a") as alignments:
        for entry in _entries(sorted(folder.glob("index-*.jsonl"))):
            audio, _ = decode((folder / entry["path"]).read_bytes(), AudioLimits())
            if entry["path"] not in kept:
                kept[entry["path"]] = _aligned(models[0], audio, entry.get("text") or texts[entry["id"]])
                print(json.dumps({"path": entry["path"], "words": kept[entry["path"]]}), file=alignments, flush=True)
            words = tuple(_word(index, *word) for index, word in enumerate(kept[entry["path"]] or ()))
            timed = tuple(word for word in words if word.interval)
            if len(timed) > 1:
                yield heard_line((entry["path"], entry["voice"]), timed, (audio, entry["focus"]), models[1])


def heard_line(
    names: tuple[str, str], words: tuple[Word, ...], said: tuple[Audio, Iterable[int]], listeners: Listeners
) -> HeardLine:
    """A recording by its name and voice, its timed words, and its audio and focus."""
    audio, focus = said
    contours, heard = contours_of(audio), listeners.heard(audio, words)
    return HeardLine(
        *names,
        texts=tuple(word.text for word in words),
        given=inputs(words, contours, usual_seconds(), heard),
        focused=np.array([float(word.index in set(focus)) for word in words]),
        emphasis=np.array([heard[word.index] for word in words])
        + PROMINENCE_SHARE * _log_odds([word.prominence for word in prominence(words, contours)]),
    )


@cache
def usual_seconds() -> dict[str, float]:
    """How long phones usually last, by label."""
    read: dict[str, float] = yaml.safe_load((ROOT / "lexicon" / "phone_durations.yaml").read_text())
    return read


def _log_odds(likely: Iterable[float | None]) -> FloatArray:
    known = np.clip([LEAST if each is None else each for each in likely], LEAST, 1 - LEAST)
    odds: FloatArray = np.log(known / (1 - known))
    return odds


def _entries(paths: Iterable[Path]) -> Iterator[dict[str, Any]]:
    for path in paths:
        if path.exists():
            yield from map(json.loads, path.read_text().splitlines())


def _aligned(aligner: Aligner, audio: Audio, text: str) -> list[list[Any]] | None:
    """Each word's text, times and phones; None where the words are not found."""
    try:
        words, _ = aligner.align(audio, read_transcript(text))
    except UnderstudyError:
        return None
    return [
        [
            word.text,
            word.interval and [word.interval.start_s, word.interval.end_s],
            [[phone.label, phone.interval.start_s, phone.interval.end_s] for phone in word.phones],
        ]
        for word in words
    ]


def _word(index: int, text: str, times_s: list[float] | None, phones: list[tuple[str, float, float]]) -> Word:
    placed = tuple(Phone(label, Interval(start_s, end_s)) for label, start_s, end_s in phones)
    return Word(index, text, Interval(*times_s) if times_s else None, placed)
