"""Gestures written out and read back."""

from dataclasses import replace
from itertools import product
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.support.examples import examples
from understudy.authoring.catalogue import load_gestures
from understudy.model import Hand, Level
from understudy.realizer.gestures.checking import REPEATED
from understudy.realizer.gestures.definitions import MAX_DURATION_S, RANGES, completed_by_mirroring, definition
from understudy.realizer.gestures.gesture import (
    ArmKey,
    Bend,
    Definition,
    Depth,
    Expressivity,
    Finger,
    Frame,
    FrameType,
    HandDirection,
    HandForm,
    HandShape,
    HeightSector,
    KeyCurve,
    OffsetTrack,
    SectorPlace,
    Sideways,
    Thumb,
    TrackForm,
    Wrist,
)
from understudy.realizer.gestures.language import parse_gestures
from understudy.realizer.gestures.specifiers import (
    ARM_JOINTS,
    MAX_DEGREES,
    MAX_OFFSET_M,
    THUMB_IN_FORM,
    TrackJoint,
    orthogonal,
)
from understudy.realizer.gestures.statements import LocatedMistake
from understudy.realizer.gestures.writing import write_gesture

PATH = Path("written.gesture")


def number(least: float, most: float) -> st.SearchStrategy[float]:
    """Numbers as people write them."""
    return st.integers(0, 1000).map(lambda k: round(least + (most - least) * k / 1000, 4))


def distinct(keys: st.SearchStrategy[str], most: int) -> st.SearchStrategy[list[str]]:
    return st.lists(keys, max_size=most, unique=True)


OFFSETS = number(-MAX_OFFSET_M, MAX_OFFSET_M)
DEGREES = number(-MAX_DEGREES, MAX_DEGREES)
SUMS = [
    frozenset(one for one in parts if one is not None)
    for parts in product(
        (None, HandDirection.UP, HandDirection.DOWN),
        (None, HandDirection.INWARDS, HandDirection.OUTWARDS),
        (None, HandDirection.AWAY, HandDirection.TOWARDS),
    )
]
WRISTS = [Wrist(base, palm) for base, palm in product(SUMS, SUMS) if orthogonal(base, palm)]
HANDS = [
    HandShape(form, thumb)
    for form, thumb in product(HandForm, Thumb)
    if thumb is Thumb.DEFAULT or form not in THUMB_IN_FORM
]
PLACES = st.builds(
    SectorPlace,
    st.sampled_from(Sideways),
    st.sampled_from(HeightSector),
    st.sampled_from(Depth),
    st.tuples(OFFSETS, OFFSETS, OFFSETS),
)
KEYS = st.builds(
    ArmKey,
    place=st.none() | PLACES,
    hand=st.none() | st.sampled_from(HANDS),
    fingers=st.dictionaries(st.sampled_from(Finger), st.sampled_from(Bend), max_size=3).map(lambda d: (*d.items(),)),
    wrist=st.none() | st.sampled_from(WRISTS),
    shoulder=st.none() | number(-1, 1),
    joints=st.dictionaries(st.sampled_from(ARM_JOINTS), st.tuples(DEGREES, DEGREES, DEGREES), max_size=3).map(
        lambda d: (*d.items(),)
    ),
)
CURVES = st.builds(KeyCurve, *[st.none() | number(-1, 1)] * 3)
LEVELS = st.dictionaries(
    st.sampled_from(Level),
    st.builds(Expressivity, **{name: number(*limits) for name, limits in RANGES.items()}),
    min_size=1,
).map(lambda made: {level: made[level] for level in Level if level in made})


def tracks_of(form: TrackForm) -> st.SearchStrategy[OffsetTrack]:
    circles = form is TrackForm.CIRCLING
    turns, phases = (number(0.25, 6), number(-360, 360)) if circles else (st.just(0.0), st.just(0.0))
    angles = st.tuples(number(-45, 45), number(1, 45), number(-45, 45))
    return st.builds(OffsetTrack, st.just(form), st.sampled_from([*TrackJoint]).map(str), angles, turns, phases)


TRACKS = st.lists(
    st.sampled_from(TrackForm).flatmap(tracks_of), max_size=3, unique_by=lambda track: (track.form, track.joint)
)


@st.composite
def definitions(draw: st.DrawFn) -> Definition:
    types = draw(st.lists(st.sampled_from(FrameType), min_size=1, max_size=6))
    types += [FrameType.STROKE_START, FrameType.STROKE_END]
    in_order = sorted(types, key=[*FrameType].index)
    types = [one for k, one in enumerate(in_order) if one in REPEATED or one not in in_order[:k]]
    hand = draw(st.sampled_from([None, *Hand]))
    times = draw(st.lists(st.integers(0, 1000), min_size=len(types), max_size=len(types), unique=True).map(sorted))
    frames: list[Frame] = []
    for time, type_ in zip(times, types, strict=True):
        leading, other = draw(KEYS), draw(KEYS)
        if not frames:
            leading = replace(leading, place=draw(PLACES))
        said = hand is Hand.BOTH and draw(st.booleans()) and other != ArmKey()
        other = completed_by_mirroring(other, leading)
        frames.append(Frame(time / 1000, type_, leading, other if said else None, draw(st.booleans()), draw(CURVES)))
    return Definition(
        gesture_class=draw(st.sampled_from(["beat", "iconic", "OTHER", "HAND"])),
        name=draw(st.from_regex(r"[A-Za-z][A-Za-z0-9_]{0,8}", fullmatch=True)),
        categories=tuple(draw(st.lists(st.sampled_from(["ME", "YOU", "ARM", "OFFSET"]), min_size=1, unique=True))),
        duration_s=draw(number(0.1, MAX_DURATION_S)),
        frames=tuple(frames),
        levels=draw(LEVELS),
        hand=hand,
        aimed=draw(st.booleans()),
        tracks=tuple(draw(TRACKS)),
        path=PATH,
    )


def read_back(text: str) -> list[Definition | None]:
    file, mistakes = parse_gestures(text, PATH)
    wrong: list[LocatedMistake] = []
    found = [definition(tree, PATH, wrong) for tree in file.gestures]
    assert (mistakes, wrong) == ((), [])
    return found


@examples(60)
@given(definitions())
def test_what_is_written_is_read_back(written: Definition) -> None:
    """Words of the language are no worse as names than others."""
    assert read_back(write_gesture(written)) == [written]


def test_the_library_is_read_back() -> None:
    for written in load_gestures().definitions:
        assert read_back(write_gesture(written)) == [replace(written, path=PATH, line=1)]


def test_what_cannot_be_said_is_refused() -> None:
    leading = ArmKey(place=SectorPlace(Sideways.C, HeightSector.CC, Depth.NEAR), shoulder=1.0)
    frames = tuple(Frame(time, FrameType.STROKE, leading, ArmKey(shoulder=0.5)) for time in (0.0, 1.0))
    one = Definition("beat", "one", ("BEAT",), 1.0, frames, {Level.LOW: Expressivity()}, Hand.BOTH)
    with pytest.raises(ValueError, match="at 0 the other arm leaves open what the leading arm says"):
        write_gesture(one)


@pytest.mark.parametrize("offset_m", [1e-07, 0.1 + 0.1 + 0.1 - 0.2])
def test_numbers_keep_their_value(offset_m: float) -> None:
    """The language has no powers of ten."""
    place = SectorPlace(Sideways.C, HeightSector.CC, Depth.NEAR, (offset_m, 0.0, 0.0))
    frames = (Frame(0.0, FrameType.STROKE, ArmKey(place=place)), Frame(1.0, FrameType.STROKE, ArmKey()))
    one = Definition("beat", "one", ("BEAT",), 1.0, frames, {Level.LOW: Expressivity()}, path=PATH)
    assert read_back(write_gesture(one)) == [one]
