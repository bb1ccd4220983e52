"""The lines that the reader is annealed on: the readings of each as one target, and how often and how far it is taught.

What counts for which reading, and where the teacher comes from, is told in `annealing.py`.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from understudy.model import SingleArray

from .channel_readings import ChannelReading, asked_by, channel_readings
from .directed import CHANNELS, HANDS, OUTPUTS, DirectedLine, is_held_out, read_alike, read_lines
from .encoder import Encoded, encoded, starting_weights
from .listening import Voices, voices_of
from .network import Reader
from .recordings import read_measured
from .second_readings import DIRECTORS, careful_readings, second_readings

TAUGHT, OLD_SHARE = 0.3, 0.3
CAREFUL_WORTH, TAUGHT_CAREFUL, TAUGHT_OTHERS = 1.0, 0.25, 0.6

ALONE_WORTH = MappingProxyType({"head": 1.0, "face": 1.0})
"""What readings of head and face alone count; those of the whole body count the rest."""

QUICK = re.compile("[a-z]+[56]-")
"""The names of the lines of two series that their readers directed very quickly (`lines/README.md`)."""


@dataclass(frozen=True, slots=True, eq=False)
class Material:
    """The lines that are trained on and those held out that were read with care, what was measured in recordings,
    the vocabulary, the shipped reader, unless nobody teaches, the names of all lines that were read with care, in
    how many epochs the quickly read lines, all but these, and deliveries are, by how much the teacher is
    calibrated, and how far every target is drawn to what it reads, if not as usual."""

    kept: Sequence[Encoded]
    checked: Sequence[Encoded]
    voices: Voices
    vocabulary: Mapping[str, int]
    teacher: Reader | None
    with_care: frozenset[str] = frozenset()
    quick_share: float = 1.0
    other_share: float = 1.0
    delivery_share: float = 1.0
    more: SingleArray | None = None
    taught_share: float | None = None

    def share(self, line: DirectedLine) -> float:
        """The share of epochs in which a line is."""
        share = self.delivery_share if line.is_delivery else 1.0
        if line.name in self.with_care:
            return share
        if not line.careful:
            return OLD_SHARE * self.other_share
        return share * self.other_share * (self.quick_share if QUICK.match(line.name) else 1.0)

    def taught(self, line: DirectedLine) -> float:
        """How far the targets of a line are drawn towards what the teacher reads."""
        if self.taught_share is not None:
            return self.taught_share
        if not self.with_care:
            return TAUGHT
        return TAUGHT_CAREFUL if line.name in self.with_care else TAUGHT_OTHERS


def material(
    directing: Path,
    vocabulary: Mapping[str, int],
    measured: Path | None,
    *,
    without: Sequence[str],
    teacher: Path | None,
    careful_worth: float = CAREFUL_WORTH,
    alone_worth: Mapping[str, float] = ALONE_WORTH,
    only: Sequence[str] = (),
) -> Material:
    """All directed lines; those that were read several times have the mean of their readings. Kinds named in `without`
    are left out of both parts; where `only` some channels are trained, nothing else counts."""
    second, careful = second_readings(), careful_readings()
    alone = {channel: channel_readings(channel) for channel in CHANNELS}
    lines = [
        each for line in read_lines(directing) if line.source not in without and (each := encoded(line, vocabulary))
    ]
    by_three = {name for name, readings in careful.items() if len(readings) == DIRECTORS}
    held_out = {each.line.name for each in lines if is_held_out(each.line)} | by_three
    read = [
        _read_alone(
            _read_with_care(_read_twice(each, second, vocabulary), careful, vocabulary, careful_worth),
            {channel: readings.get(each.line.name, ()) for channel, readings in alone.items()},
            alone_worth,
        )
        for each in lines
    ]
    alike = list(_alike(alone, vocabulary))
    return Material(
        kept=_counting([each for each in read if each.line.name not in held_out] + alike, only),
        checked=_counting([each for each in read if each.line.name in held_out and each.line.name in careful], only),
        voices=voices_of(read_measured(measured) if measured else {}, (each.line for each in lines)),
        vocabulary=vocabulary,
        teacher=Reader(starting_weights(teacher)[0]).eval() if teacher else None,
        with_care=frozenset(careful) | {each.line.name for each in alike},
    )


def _alike(
    alone: Mapping[str, Mapping[str, Sequence[ChannelReading]]], vocabulary: Mapping[str, int]
) -> Iterator[Encoded]:
    """The lines of which only some channels were read; nothing counts but these."""
    for line in read_alike():
        readings = {channel: read[line.name] for channel, read in alone.items() if line.name in read}
        each = encoded(line, vocabulary) if readings else None
        if each:
            yield from _counting([_read_alone(each, readings, ALONE_WORTH)], list(readings))


def _counting(lines: Sequence[Encoded], channels: Sequence[str]) -> list[Encoded]:
    """The lines with nothing but `channels` counting; all of it where none are named."""
    outputs = np.ones(OUTPUTS, np.float32)
    if channels:
        outputs[:] = 0
        for channel in channels:
            outputs[CHANNELS[channel]] = 1
    return [replace(each, counts=each.counts * outputs) for each in lines]


def _read_twice(each: Encoded, second: Mapping[str, dict[str, Any]], vocabulary: Mapping[str, int]) -> Encoded:
    """A line with the mean of both readings. Where the first was not careful with heads and faces, only the second says
    what they do, and the line is a careful one from then on."""
    name = each.line.name
    other = encoded(DirectedLine(name, each.line.words, second[name], True), vocabulary) if name in second else None
    if other is None:
        return each
    wanted: SingleArray = np.asarray((each.wanted + other.wanted) / 2, np.float32)
    counts: SingleArray = np.maximum(each.counts, other.counts)
    if not each.line.careful:
        wanted[:, HANDS:] = other.wanted[:, HANDS:]
        counts[:, HANDS:] = other.counts[:, HANDS:]
    return replace(each, line=replace(each.line, careful=True), wanted=wanted, counts=counts)


def _read_with_care(
    each: Encoded, careful: Mapping[str, list[dict[str, Any]]], vocabulary: Mapping[str, int], worth: float
) -> Encoded:
    """A line with the mean of the readings that were made with care, of which the others are 1 - `worth`."""
    lines = (replace(each.line, reading=reading, careful=True) for reading in careful.get(each.line.name, ()))
    read = [found for line in lines if (found := encoded(line, vocabulary))]
    if not read:
        return each
    wanted = np.mean([one.wanted for one in read], axis=0)
    counts = np.mean([one.counts for one in read], axis=0)
    return replace(
        each,
        line=replace(each.line, careful=True),
        wanted=np.asarray(worth * wanted + (1 - worth) * each.wanted, np.float32),
        counts=np.asarray(counts, np.float32),
    )


def _read_alone(each: Encoded, alone: Mapping[str, Sequence[ChannelReading]], worth: Mapping[str, float]) -> Encoded:
    """A line whose head movements and faces are drawn for `worth` of their way to those that were read alone."""
    wanted = each.wanted.copy()
    for channel, readings in alone.items():
        if readings:
            own = wanted[:, CHANNELS[channel]]
            own += worth[channel] * (asked_by(readings, channel, len(each.ends)) - own)
    return replace(each, wanted=wanted)
