"""Reads syllables of the Berlin database of emotional speech with the stress perceived by listeners.

A `.labsilb` file has a line per syllable: its start in seconds, a colour, its spelling and its stress, the mean of
listeners' judgements from 0 (none) to 3. A line without stress ("." or "(") begins a pause or ends the sentence.
"""

from dataclasses import dataclass
from pathlib import Path

from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.model import Audio, Interval


@dataclass(frozen=True, slots=True)
class JudgedSentence:
    """A sentence: its speaker, its emotion (N neutral, L bored, T sad, A afraid, E disgusted, F happy, W angry), and of
    each syllable the spelling, the time and the stress heard, 0 to 3."""

    speaker: str
    emotion: str
    audio: Audio
    spellings: tuple[str, ...]
    syllables: tuple[Interval, ...]
    stresses: tuple[float, ...]


def read_judged(speech: Path) -> list[JudgedSentence]:
    """Every sentence of `emodb_labels`, in order of name; its audio lies in `emodb`."""
    return [
        _read(path, speech / "emodb" / f"{path.stem}.flac") for path in sorted(speech.glob("emodb_labels/*.labsilb"))
    ]


def _read(labels: Path, recording: Path) -> JudgedSentence:
    rows = [line.split(None, 2) for line in labels.read_text("latin-1").split("#\n", 1)[1].splitlines()]
    starts_s = [float(row[0]) for row in rows]
    marks = [row[2].strip().split("\t") for row in rows]
    judged = [place for place, mark in enumerate(marks) if len(mark) == 2]
    return JudgedSentence(
        speaker=labels.stem[:2],
        emotion=labels.stem[5],
        audio=decode(recording.read_bytes(), AudioLimits())[0],
        spellings=tuple(marks[place][0] for place in judged),
        syllables=tuple(Interval(starts_s[place], starts_s[place + 1]) for place in judged),
        stresses=tuple(float(marks[place][1]) for place in judged),
    )
