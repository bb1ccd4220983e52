"""Interprets the statements of a gesture: those of a frame (Gesture Engine §4.2: sectors, hand shapes, fingers, wrists,
joints), and the offset tracks of its header (NGS §3.4), which are TRACK lines:

    TRACK held chest 0 12 0             the body turns with the gesture
    TRACK curved UpperArm 0 -10 0       the stroke's path is an arc
    TRACK circling LowerArm 0 12 0 2    a progressive: the forearm goes round, twice in a stroke

Each function converts a readable statement into its value, or returns None and appends the mistake to `wrong`.
"""

import re
from collections.abc import Iterable, Iterator
from enum import StrEnum
from itertools import product
from typing import TypeVar

from ...errors import nearest_names
from ...model import Hand
from ..body.skeleton import arm_joints
from .gesture import (
    ArmKey,
    Bend,
    Depth,
    Finger,
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
from .gesture_space import DIRECTIONS
from .statements import LocatedMistake, Statement, StatementValue

Named = TypeVar("Named", bound=StrEnum)

MAX_OFFSET_M = 0.3
MAX_DEGREES = 180.0
FINGER_BASE, PALM, AS_THE_FOREARM = "FB", "Palm", "Default"

THUMB_IN_FORM = frozenset(
    {
        HandForm.PINCH,
        HandForm.PINCH_ALL,
        HandForm.PINCH_OPEN,
        HandForm.CEE,
        HandForm.CEE_ALL,
        HandForm.CEE_OPEN,
    }
)
"""The forms that include the thumb, which therefore cannot be given separately."""

_DIRECTIONS = re.compile("|".join(HandDirection))


def arm_key(statements: Iterable[Statement], wrong: list[LocatedMistake]) -> ArmKey:
    """The key that a frame's statements define for one arm; each part may be defined only once."""
    said = {(statement.keyword.text, *_part(statement)): statement for statement in statements}
    one = {name: statement for (name, *_), statement in said.items()}
    fingers = [finger(statement, wrong) for (name, *_), statement in said.items() if name == "FINGER"]
    joints = [joint(statement, wrong) for (name, *_), statement in said.items() if name == "JOINT"]
    return ArmKey(
        place=place(one["ARM"], wrong) if "ARM" in one else None,
        hand=hand_shape(one["HAND"], wrong) if "HAND" in one else None,
        fingers=tuple(found for found in fingers if found),
        wrist=wrist(one["WRIST"], wrong) if "WRIST" in one else None,
        shoulder=number(one["SHOULDER"].numbers[0], -1, 1, wrong) if "SHOULDER" in one else None,
        joints=tuple(found for found in joints if found),
    )


def key_curve(statements: Iterable[Statement], wrong: list[LocatedMistake]) -> KeyCurve:
    """`TENSION`, `CONTINUITY` and `BIAS` among a frame's statements."""
    numbers = {statement.keyword.text.lower(): statement.numbers[0] for statement in statements if statement.numbers}
    said = {name: numbers[name] for name in KeyCurve.__slots__ if name in numbers}
    return KeyCurve(**{name: number(word, -1, 1, wrong) for name, word in said.items()})


def place(statement: Statement, wrong: list[LocatedMistake]) -> SectorPlace | None:
    """`ARM X Y Z [OFFSET out up away]`."""
    across, height, depth = statement.words
    sideways, up, away = (
        one_of(Sideways, across, "a sector across the body", wrong),
        one_of(HeightSector, height, "a sector in height", wrong),
        one_of(Depth, depth, "a distance from the body", wrong),
    )
    offsets = [number(word, -MAX_OFFSET_M, MAX_OFFSET_M, wrong, unit=" m") for word in statement.numbers]
    if sideways is None or up is None or away is None or None in offsets:
        return None
    out_m, up_m, away_m = (float(offset or 0.0) for offset in offsets or (0.0, 0.0, 0.0))
    return SectorPlace(sideways, up, away, (out_m, up_m, away_m))


def hand_shape(statement: Statement, wrong: list[LocatedMistake]) -> HandShape | None:
    """`HAND form` or `HAND form_thumb`."""
    word = statement.words[0]
    shape = _SHAPES.get(word.text)
    if shape is None:
        wrong.append(_unknown("a form of the hand, with or without the thumb's (_open, _out, _across)", word, _SHAPES))
    elif shape.form in THUMB_IN_FORM and shape.thumb is not Thumb.DEFAULT:
        made = f"the thumb takes part in {shape.form} and cannot be {shape.thumb} as well; write {shape.form}"
        wrong.append(LocatedMistake(word, made))
        return None
    return shape


def finger(statement: Statement, wrong: list[LocatedMistake]) -> tuple[Finger, Bend] | None:
    """`FINGER name bend`."""
    name, bend = statement.words
    found, bent = one_of(Finger, name, "a finger", wrong), one_of(Bend, bend, "a finger's bend", wrong)
    return None if found is None or bent is None else (found, bent)


def wrist(statement: Statement, wrong: list[LocatedMistake]) -> Wrist | None:
    """`WRIST FB… Palm…`: two sums of directions, orthogonal to each other."""
    base_word, palm_word = statement.words
    base, palm = _directions(FINGER_BASE, base_word, wrong), _directions(PALM, palm_word, wrong)
    if base is None or palm is None:
        return None
    if not orthogonal(base, palm):
        left = [f"{PALM}{one}" for one in HandDirection if orthogonal(base, {one})]
        right_would_be = f"right would be {', '.join(left)}" if left else "no single direction of the palm fits it"
        told = f"the palm must face at a right angle to {base_word.text}; {right_would_be}, or a sum of these"
        wrong.append(LocatedMistake(palm_word, told))
        return None
    return Wrist(base, palm)


def orthogonal(finger_base: Iterable[HandDirection], palm: Iterable[HandDirection]) -> bool:
    """Whether the sums of directions are orthogonal; exact, since sums are integers. True if either is empty."""
    return sum(_dot(one, other) for one, other in product(finger_base, tuple(palm))) == 0


def joint(statement: Statement, wrong: list[LocatedMistake]) -> tuple[str, tuple[float, float, float]] | None:
    """`JOINT name x y z` in degrees: the explicit override of Gesture Engine §4.2."""
    name = statement.words[0]
    known = name.text in ARM_JOINTS
    if not known:
        wrong.append(_unknown("a joint of the arm", name, ARM_JOINTS))
    x, y, z = (number(word, -MAX_DEGREES, MAX_DEGREES, wrong, unit="°") for word in statement.numbers)
    return (name.text, (x, y, z)) if known and x is not None and y is not None and z is not None else None


def number(
    word: StatementValue, least: float, most: float, wrong: list[LocatedMistake], *, unit: str = ""
) -> float | None:
    """The number, if it is in [least, most]."""
    value = float(word.text)
    if least <= value <= most:
        return value + 0.0
    wrong.append(LocatedMistake(word, f"{word.text} is outside {least:g} … {most:g}{unit}"))
    return None


def one_of(names: type[Named], word: StatementValue, what: str, wrong: list[LocatedMistake]) -> Named | None:
    """The member of `names` with this value."""
    if word.text in set(names):
        return names(word.text)
    wrong.append(_unknown(what, word, list(names)))
    return None


def _unknown(what: str, word: StatementValue, known: Iterable[str]) -> LocatedMistake:
    """Suggests the nearest of the known words, or lists all if they are few."""
    words = [str(one) for one in known]
    by_capitals = {one.lower(): one for one in words}
    close = nearest_names(word.text.lower(), by_capitals)
    listed = f": one of {', '.join(words)}" if len(words) <= 20 else ""
    meant = f"; did you mean {by_capitals[close[0]]}?" if close else listed
    return LocatedMistake(word, f"{word.text!r} is not {what}{meant}")


def _part(statement: Statement) -> tuple[str, ...]:
    """What distinguishes two statements of one keyword: the finger or the joint."""
    return (statement.words[0].text,) if statement.keyword.text in {"FINGER", "JOINT"} else ()


def _directions(prefix: str, word: StatementValue, wrong: list[LocatedMistake]) -> frozenset[HandDirection] | None:
    """The directions of `FBUpAway` or `PalmInwards`; the empty set for `…Default`."""
    rest = word.text.removeprefix(prefix)
    if rest == AS_THE_FOREARM and word.text != rest:
        return frozenset()
    found = [HandDirection(name) for name in _DIRECTIONS.findall(rest)]
    if not word.text.startswith(prefix) or "".join(found) != rest or not found:
        known = [f"{prefix}{name}" for name in (*HandDirection, AS_THE_FOREARM)]
        wrong.append(_unknown(f"{prefix} and directions, as {prefix}Up or {prefix}UpAway", word, known))
        return None
    clash = next((f"{a} and {b}" for a, b in product(found, found) if _dot(a, b) < 0), None)
    if clash or len(set(found)) < len(found):
        told = f"{clash} are opposite" if clash else "a direction is repeated"
        wrong.append(LocatedMistake(word, f"{told}; a sum takes each of up/down, inwards/outwards, away/towards once"))
        return None
    return frozenset(found)


def _dot(one: HandDirection, other: HandDirection) -> float:
    return sum(a * b for a, b in zip(DIRECTIONS[one], DIRECTIONS[other], strict=True))


_SHAPES = {
    str(form) if thumb is Thumb.DEFAULT else f"{form}_{thumb}": HandShape(form, thumb)
    for form, thumb in product(HandForm, Thumb)
}
ARM_JOINTS: tuple[str, ...] = tuple(name.removeprefix(Hand.LEFT) for name in arm_joints(Hand.LEFT))
"""From the collarbone down, without their side."""


MOST_DEGREES, MOST_PHASE_DEG, FEWEST_TURNS, MOST_TURNS = 45.0, 360.0, 0.25, 6.0


_NUMBER = re.compile(r"[+-]?\d+(\.\d*)?")


class TrackJoint(StrEnum):
    """The joints that can have a track; those of the arm are those of each arm that gestures."""

    SPINE = "spine"
    CHEST = "chest"
    UPPER_CHEST = "upperChest"
    SHOULDER = "Shoulder"
    UPPER_ARM = "UpperArm"
    LOWER_ARM = "LowerArm"
    HAND = "Hand"


TRUNK = frozenset({TrackJoint.SPINE, TrackJoint.CHEST, TrackJoint.UPPER_CHEST})


def offset_tracks(header: Iterable[Statement], wrong: list[LocatedMistake]) -> tuple[OffsetTrack, ...]:
    """The tracks of a gesture; mistakes are appended to `wrong`."""
    said = (statement for statement in header if statement.readable and statement.keyword.text == "TRACK")
    return tuple(track for statement in said for track in _track(statement, wrong))


def track_of(told: str) -> OffsetTrack:
    """The track of a line without its keyword, such as "held chest 0 12 0", as gesture scripts have it. Raises
    ValueError with everything that is wrong."""
    words = [StatementValue(text, 1, 1) for text in told.split()]
    numbers = words[2:]
    if not 3 <= len(numbers) <= 5 or not all(_NUMBER.fullmatch(word.text) for word in numbers):
        raise ValueError(f"{told!r} is not a track; give form, joint and three angles, as in 'held chest 0 12 0'")
    wrong: list[LocatedMistake] = []
    found = tuple(_track(Statement(StatementValue("TRACK", 1, 1), tuple(words[:2]), tuple(numbers)), wrong))
    if wrong:
        raise ValueError(f"{told!r}: {'; '.join(mistake.message for mistake in wrong)}")
    return found[0]


def _track(statement: Statement, wrong: list[LocatedMistake]) -> Iterator[OffsetTrack]:
    """The track, if nothing is wrong with it."""
    found: list[LocatedMistake] = []
    form_word, joint_word = statement.words
    form = one_of(TrackForm, form_word, "a track's form", found)
    joint = one_of(TrackJoint, joint_word, "a joint of tracks", found)
    x, y, z = (number(word, -MOST_DEGREES, MOST_DEGREES, found, unit="°") or 0.0 for word in statement.numbers[:3])
    turns, phase_deg = _turns(statement, form, found)
    if not found and not any((x, y, z)):
        found.append(LocatedMistake(statement.numbers[0], "this track turns nothing: all its angles are 0"))
    wrong += found
    if not found and form is not None and joint is not None:
        yield OffsetTrack(form, joint.value, (x, y, z), turns, phase_deg)


def _turns(statement: Statement, form: TrackForm | None, wrong: list[LocatedMistake]) -> tuple[float, float]:
    """How often a track goes round, and where it begins; the others do not."""
    more = statement.numbers[3:]
    if form is not TrackForm.CIRCLING:
        if more and form is not None:
            wrong.append(LocatedMistake(more[0], f"a track that is {form} has three angles; turns are for circling"))
        return 0.0, 0.0
    if not more:
        wrong.append(LocatedMistake(statement.words[0], "a circling track gives its turns after the angles"))
        return 0.0, 0.0
    phase_deg = number(more[1], -MOST_PHASE_DEG, MOST_PHASE_DEG, wrong, unit="°") if more[1:] else 0.0
    return number(more[0], FEWEST_TURNS, MOST_TURNS, wrong) or 0.0, phase_deg or 0.0
