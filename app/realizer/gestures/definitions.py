"""Builds gesture definitions from parsed statements (`statements.py`), collecting every mistake.

Levels of agitation that a file does not define are derived from medium: low is smaller, slower and smoother, high
larger, faster and sharper. In a frame with OTHER, whatever it leaves open is mirrored from the leading arm.
"""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from types import MappingProxyType

from ...model import Hand, Level
from .checking import TimedFrame, frame_mistakes, repeated_statements
from .gesture import ArmKey, Definition, Expressivity, Frame, FrameType, OffsetTrack
from .specifiers import arm_key, key_curve, number, offset_tracks, one_of
from .statements import FrameTree, GestureTree, LocatedMistake, Statement, StatementValue

MEDIUM = Expressivity(repetition=0.35)
FACTORS: Mapping[Level, tuple[float, float]] = MappingProxyType(
    {Level.LOW: (0.92, 0.97), Level.MEDIUM: (1.0, 1.0), Level.HIGH: (1.2, 1.2)}
)
"""Amplitude and tempo of a level, as factors of medium's."""
SUMMANDS: Mapping[Level, tuple[float, float, float]] = MappingProxyType(
    {Level.LOW: (0.2, -0.2, -0.05), Level.MEDIUM: (0.0, 0.0, 0.0), Level.HIGH: (-0.15, 0.25, 0.3)}
)
"""Fluidity, power and repetition of a level, added to medium's."""
RANGES: Mapping[str, tuple[float, float]] = MappingProxyType(
    {
        "amplitude": (0.25, 2.0),
        "tempo": (0.25, 3.0),
        "fluidity": (0.0, 1.0),
        "power": (0.0, 1.0),
        "repetition": (0.0, 1.0),
    }
)
MIN_DURATION_S, MAX_DURATION_S = 0.1, 10.0
NEEDED = frozenset({"GESTURECLASS", "GESTUREINSTANCE", "DURATION"})

_LEXEME = re.compile(r"[A-Z][A-Z0-9_]*")


@dataclass(frozen=True, slots=True)
class _Header:
    gesture_class: str
    name: str
    duration_s: float
    categories: tuple[str, ...]
    levels: Mapping[Level, Expressivity]
    hand: Hand | None
    aimed: bool
    tracks: tuple[OffsetTrack, ...]


def definition(tree: GestureTree, path: Path | None, wrong: list[LocatedMistake]) -> Definition | None:
    """The gesture defined by `tree`, or None if it has mistakes, which are appended to `wrong`."""
    found: list[LocatedMistake] = []
    header = _header(tree, found)
    both = header is None or header.hand is Hand.BOTH
    timed = [_timed(frame, found, both=both) for frame in tree.frames]
    found += frame_mistakes(tree, timed)
    wrong += found
    if found or header is None or not tree.all_readable():
        return None
    return Definition(
        gesture_class=header.gesture_class,
        name=header.name,
        categories=header.categories,
        duration_s=header.duration_s,
        frames=tuple(frame for frame in (_frame(one) for one in timed) if frame),
        levels=header.levels,
        hand=header.hand,
        aimed=header.aimed,
        tracks=header.tracks,
        path=path,
        line=tree.start.line,
    )


def derived_expressivity(level: Level, medium: Expressivity) -> Expressivity:
    """The default expressivity at `level` of a gesture with this expressivity at medium agitation."""
    amplitude, tempo = FACTORS[level]
    rounder, stronger, again = SUMMANDS[level]
    made = replace(
        medium,
        amplitude=medium.amplitude * amplitude,
        tempo=medium.tempo * tempo,
        fluidity=medium.fluidity + rounder,
        power=medium.power + stronger,
        repetition=medium.repetition + again,
    )
    return Expressivity(**{name: round(_within(getattr(made, name), *RANGES[name]), 6) for name in RANGES})


def _within(value: float, least: float, most: float) -> float:
    return min(max(value, least), most)


def _header(tree: GestureTree, wrong: list[LocatedMistake]) -> _Header | None:
    """None if a required statement is missing, wrong or unreadable."""
    wrong += (*repeated_statements(tree.header), *_missing(tree))
    said = {statement.keyword.text: statement for statement in tree.header if statement.readable}
    hand = one_of(Hand, said["ARMS"].words[0], "an arm, nor both", wrong) if "ARMS" in said else None
    categories = _categories(said["CATEGORY"].words, wrong) if "CATEGORY" in said else ()
    levels, tracks = _levels(tree.header, wrong), offset_tracks(tree.header, wrong)
    duration_s = (
        number(said["DURATION"].numbers[0], MIN_DURATION_S, MAX_DURATION_S, wrong, unit=" s")
        if "DURATION" in said
        else None
    )
    if not said.keys() >= NEEDED or duration_s is None:
        return None
    name = said["GESTUREINSTANCE"].words[0].text
    return _Header(
        gesture_class=said["GESTURECLASS"].words[0].text,
        name=name,
        duration_s=duration_s,
        categories=categories or (name.upper(),),
        levels=levels,
        hand=hand,
        aimed="AIMED" in said,
        tracks=tracks,
    )


def _missing(tree: GestureTree) -> Iterator[LocatedMistake]:
    """Required statements that are missing; none if a line was unreadable, since it may be the missing one."""
    if all(statement.readable for statement in tree.header):
        for keyword in sorted(NEEDED - {statement.keyword.text for statement in tree.header}):
            yield LocatedMistake(tree.start, f"this gesture has no {keyword}")


def _categories(words: Sequence[StatementValue], wrong: list[LocatedMistake]) -> tuple[str, ...]:
    wrong += _repeated(words)
    for word in words:
        if not _LEXEME.fullmatch(word.text):
            wrong.append(LocatedMistake(word, f"a category is a BML lexeme in capitals: {word.text.upper()}"))
    return tuple(word.text for word in words)


def _repeated(words: Sequence[StatementValue]) -> Iterator[LocatedMistake]:
    for position, word in enumerate(words):
        if word.text in {before.text for before in words[:position]}:
            yield LocatedMistake(word, f"duplicate {word.text}")


def _levels(header: Iterable[Statement], wrong: list[LocatedMistake]) -> Mapping[Level, Expressivity]:
    """The expressivity at each level that the gesture suits."""
    readable = [statement for statement in header if statement.readable]
    listed = next((statement.words for statement in readable if statement.keyword.text == "LEVELS"), ())
    wrong += _repeated(listed)
    found = [one_of(Level, word, "a level of agitation", wrong) for word in listed]
    fit = list(Level) if None in found or not found else found
    defined: dict[Level, dict[str, float]] = {}
    for statement in readable:
        if statement.keyword.text == "EXPRESSIVITY":
            level = one_of(Level, statement.words[0], "a level of agitation", wrong)
            factors = _factors(statement, wrong)
            if level is not None and level not in fit:
                wrong.append(LocatedMistake(statement.words[0], f"{level} is not among the LEVELS of this gesture"))
            elif level is not None:
                defined[level] = factors
    medium = replace(MEDIUM, **defined.get(Level.MEDIUM, {}))
    return MappingProxyType(
        {
            level: replace(derived_expressivity(level, medium), **defined.get(level, {}))
            for level in Level
            if level in fit
        }
    )


def _factors(statement: Statement, wrong: list[LocatedMistake]) -> dict[str, float]:
    """The values of one EXPRESSIVITY line."""
    found: dict[str, float] = {}
    wrong += _repeated(statement.words[1:])
    for name, value in zip(statement.words[1:], statement.numbers, strict=True):
        if name.text not in RANGES:
            wrong.append(LocatedMistake(name, f"{name.text!r} is none of {', '.join(RANGES)}"))
        else:
            least, most = RANGES[name.text]
            in_range = number(value, least, most, wrong)
            found[name.text] = least if in_range is None else in_range
    return found


def _timed(tree: FrameTree, wrong: list[LocatedMistake], *, both: bool) -> TimedFrame:
    wrong += repeated_statements(tree.statements)
    readable = [statement for statement in tree.statements if statement.readable]
    types = [statement.words[0] for statement in readable if statement.keyword.text == "FRAMETYPE"]
    others = [statement for statement in readable if statement.other]
    if others and not both:
        wrong.append(
            LocatedMistake(others[0].keyword, "OTHER needs a gesture of both arms: write ARMS both in its header")
        )
    own = [statement for statement in readable if not statement.other]
    leading = arm_key(own, wrong)
    return TimedFrame(
        tree=tree,
        time=number(tree.start.numbers[0], 0, 1, wrong) if tree.start.readable else None,
        type=one_of(FrameType, types[0], "a frame's type", wrong) if types else None,
        type_at=types[0] if types else tree.start.keyword,
        leading=leading,
        other=completed_by_mirroring(arm_key(others, wrong), leading) if others else None,
        noise=any(statement.keyword.text == "ADDNOISE" for statement in readable),
        curve=key_curve(own, wrong),
    )


def completed_by_mirroring(other: ArmKey, leading: ArmKey) -> ArmKey:
    """`other`, with undefined parts taken from `leading`. Finger bends belong to the hand shape and are copied with
    it."""
    says_hand = other.hand is not None or other.fingers != ()
    kept = {"hand", "fingers"} if says_hand else set()
    silent = {
        field.name for field in fields(ArmKey) if getattr(other, field.name) in {None, ()} and field.name not in kept
    }
    return replace(other, **{name: getattr(leading, name) for name in silent})


def _frame(timed: TimedFrame) -> Frame | None:
    if timed.time is None or timed.type is None:
        return None
    return Frame(timed.time, timed.type, timed.leading, timed.other, timed.noise, timed.curve)
