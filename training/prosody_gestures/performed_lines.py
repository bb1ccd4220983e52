"""Reads the lines that the rules performed (`training.prosody_gestures.performed`): paths of states with their
prosody."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from types import MappingProxyType

import numpy as np

from understudy.model import Channel, FloatArray
from understudy.prosody_gestures.prosody import features, in_context, raw_frames
from understudy.prosody_gestures.semi_markov import FRAME_S, IntArray, Segment, segments_of
from understudy.prosody_gestures.voice_model import PartModel, VoiceModel

from .parts import learn_part

HANDS = ("rest", "preparation", "stroke", "hold", "retraction")
HEAD = ("still", "nod", "shake", "tilt", "turn")
BROWS = ("neutral", "raised", "lowered")
STROKE = HANDS.index("stroke")

HEAD_LEXEMES = MappingProxyType(
    {"NOD": 1, "SHAKE": 2, "SWAY": 2, "TILT_LEFT": 3, "TILT_RIGHT": 3, "TURN_LEFT": 4, "TURN_RIGHT": 4}
)
BROW_LEXEMES = MappingProxyType(
    {"RAISE_BROWS": 1, "RAISE_RIGHT_BROW": 1, "WIDEN_EYES": 1, "LOWER_BROWS": 2, "NARROW_EYES": 2, "OBLIQUE_BROWS": 2}
)


@dataclass(frozen=True, slots=True, eq=False)
class PerformedLine:
    """What the rules did with a recording. `rows` is its prosody in context, a row a frame, `strokes_s` where their
    strokes begin and end (strokes × 2), `word_s` where its words do."""

    name: str
    speaker: str
    duration_s: float
    energy_db: FloatArray
    f0_hz: FloatArray
    rows: FloatArray
    hands: IntArray
    head: IntArray
    brows: IntArray
    strokes_s: FloatArray
    words: IntArray
    word_s: FloatArray


def read_performed(folder: Path, corpora: Sequence[str]) -> list[PerformedLine]:
    """The lines of some corpora, by name."""
    return [_read(path) for corpus in corpora for path in sorted(folder.glob(f"{corpus}-*.npz"))]


def learn(lines: Sequence[PerformedLine]) -> VoiceModel:
    """The models of hands, head and brows."""
    return VoiceModel((_part(lines, "hands", HANDS), _part(lines, "head", HEAD), _part(lines, "brows", BROWS)))


def _part(lines: Iterable[PerformedLine], part: str, states: tuple[str, ...]) -> PartModel:
    return learn_part(part, states, [(line.rows, segments_of(getattr(line, part))) for line in lines])


def strokes_of(path: Sequence[Segment]) -> list[Segment]:
    """The strokes of a path of the hands."""
    return [segment for segment in path if segment.state == STROKE]


def _read(path: Path) -> PerformedLine:
    corpus, speaker, name = path.stem.split("-", 2)
    with np.load(path) as file:
        arrays = dict(file)
    energy_db, f0_hz = arrays["energy_db"].astype(np.float64), arrays["f0_hz"].astype(np.float64)
    rows = in_context(features(raw_frames(energy_db, f0_hz)))
    gestures = arrays["sync_s"][arrays["kind"] == Channel.GESTURE.value]
    return PerformedLine(
        name,
        f"{corpus}-{speaker}",
        float(arrays["duration_s"]),
        energy_db,
        f0_hz,
        rows,
        _hands(gestures, len(rows)),
        _moved(arrays, Channel.HEAD, HEAD_LEXEMES, len(rows)),
        _moved(arrays, Channel.FACE, BROW_LEXEMES, len(rows)),
        gestures[:, [2, 4]],
        arrays["word"],
        arrays["word_s"],
    )


def _hands(gestures: FloatArray, frames: int) -> IntArray:
    """The phases of gestures: from start to stroke, to its end, to the relax point, to the end."""
    states = np.zeros(frames, dtype=np.intp)
    for start, _, stroke_start, _, stroke_end, relax, end in gestures:
        points = (start, stroke_start, stroke_end, end if np.isnan(relax) else relax, end)
        for state, (first, last) in enumerate(pairwise(map(_frame, points)), start=1):
            states[first:last] = state
    return states


def _moved(arrays: Mapping[str, FloatArray], channel: Channel, lexemes: Mapping[str, int], frames: int) -> IntArray:
    """The states of what a rule moved on a channel; where two overlap, the later one's."""
    states = np.zeros(frames, dtype=np.intp)
    asked = (arrays["kind"] == channel.value) & ~arrays["by_itself"].astype(bool)
    for lexeme, sync_s in zip(arrays["lexeme"][asked], arrays["sync_s"][asked], strict=True):
        if str(lexeme) in lexemes:
            states[_frame(sync_s[0]) : _frame(sync_s[-1])] = lexemes[str(lexeme)]
    return states


def _frame(time_s: float) -> int:
    return max(0, round(time_s / FRAME_S))
