"""Writes a gesture definition as the text of a gesture file, for tools such as the Gesture Editor (Gesture Engine
§4.3).

Nothing is written that a reader would complete to the same: categories, levels and expressivity only where they are not
the usual ones, of the other arm only what differs from the leading arm's mirror image.
"""

from collections.abc import Iterator, Mapping
from dataclasses import fields, replace

from ...model import Level
from .definitions import MEDIUM, RANGES, completed_by_mirroring, derived_expressivity
from .gesture import (
    ArmKey,
    Definition,
    Expressivity,
    Frame,
    HandDirection,
    HandShape,
    KeyCurve,
    OffsetTrack,
    SectorPlace,
    Thumb,
    Wrist,
)
from .specifiers import AS_THE_FOREARM, FINGER_BASE, PALM
from .statements import OTHER


def write_gesture(definition: Definition) -> str:
    """The lines of a gesture file that parses to the same definition, apart from path and line.

    Raises ValueError if the other arm leaves open what the leading arm defines, which the language cannot express.
    """
    return "".join(f"{line}\n" for line in (*_header(definition), *_frames(definition)))


def _header(definition: Definition) -> Iterator[str]:
    yield f"GESTURECLASS {definition.gesture_class}"
    yield f"GESTUREINSTANCE {definition.name}"
    yield f"DURATION {_number(definition.duration_s)}"
    if definition.hand:
        yield f"ARMS {definition.hand}"
    if definition.categories != (definition.name.upper(),):
        yield f"CATEGORY {' '.join(definition.categories)}"
    if definition.aimed:
        yield "AIMED"
    yield from map(_track, definition.tracks)
    if len(definition.levels) < len(Level):
        yield f"LEVELS {' '.join(definition.levels)}"
    yield from _expressivities(definition.levels)


def _track(track: OffsetTrack) -> str:
    last = [track.turns, track.phase_deg] if track.phase_deg else [track.turns] if track.turns else []
    return " ".join(["TRACK", track.form, track.joint, *map(_number, (*track.degrees, *last))])


def _expressivities(levels: Mapping[Level, Expressivity]) -> Iterator[str]:
    medium = levels.get(Level.MEDIUM, MEDIUM)
    for level, expressivity in levels.items():
        usual = MEDIUM if level is Level.MEDIUM else derived_expressivity(level, medium)
        values = {name: getattr(expressivity, name) for name in RANGES}
        own = [f"{name} {_number(value)}" for name, value in values.items() if value != getattr(usual, name)]
        if own:
            yield f"EXPRESSIVITY {level} {' '.join(own)}"


def _frames(definition: Definition) -> Iterator[str]:
    for frame in definition.frames:
        yield f"STARTFRAME {_number(frame.time)}"
        yield f"  FRAMETYPE {frame.type}"
        yield from (f"  {line}" for line in _key(frame.leading))
        yield from (f"  {OTHER} {line}" for line in _other(frame))
        yield from (f"  {line}" for line in _curve(frame.curve))
        if frame.noise:
            yield "  ADDNOISE"
        yield "ENDFRAME"


def _curve(curve: KeyCurve) -> Iterator[str]:
    for name in KeyCurve.__slots__:
        value = getattr(curve, name)
        if value is not None:
            yield f"{name.upper()} {_number(value)}"


def _other(frame: Frame) -> Iterator[str]:
    if frame.other is None:
        return
    if frame.other == ArmKey() or completed_by_mirroring(frame.other, frame.leading) != frame.other:
        raise ValueError(f"at {frame.time:g} the other arm leaves open what the leading arm says")
    own = _without_mirrored(frame.other, frame.leading)
    sufficient = own != ArmKey() and completed_by_mirroring(own, frame.leading) == frame.other
    yield from _key(own if sufficient else frame.other)


def _without_mirrored(other: ArmKey, leading: ArmKey) -> ArmKey:
    """What the other arm does not have of the leading arm."""
    empty = ArmKey()
    same = [field.name for field in fields(ArmKey) if getattr(other, field.name) == getattr(leading, field.name)]
    return replace(other, **{name: getattr(empty, name) for name in same})


def _key(key: ArmKey) -> Iterator[str]:
    if key.place:
        yield f"ARM {_place(key.place)}"
    if key.hand:
        yield f"HAND {_hand(key.hand)}"
    yield from (f"FINGER {finger} {bend}" for finger, bend in key.fingers)
    if key.wrist:
        yield f"WRIST {_wrist(key.wrist)}"
    if key.shoulder is not None:
        yield f"SHOULDER {_number(key.shoulder)}"
    yield from (f"JOINT {joint} {' '.join(map(_number, degrees))}" for joint, degrees in key.joints)


def _place(place: SectorPlace) -> str:
    offset = f" OFFSET {' '.join(map(_number, place.offset_m))}" if any(place.offset_m) else ""
    return f"{place.sideways} {place.height} {place.depth}{offset}"


def _hand(shape: HandShape) -> str:
    return shape.form if shape.thumb is Thumb.DEFAULT else f"{shape.form}_{shape.thumb}"


def _wrist(wrist: Wrist) -> str:
    return f"{FINGER_BASE}{_sum(wrist.finger_base)} {PALM}{_sum(wrist.palm)}"


def _sum(directions: frozenset[HandDirection]) -> str:
    return "".join(direction for direction in HandDirection if direction in directions) or AS_THE_FOREARM


def _number(value: float) -> str:
    """The shortest decimal notation that reads back as the same number, without exponents."""
    text = repr(float(value))
    return text if "e" not in text else f"{value:.17f}".rstrip("0")
