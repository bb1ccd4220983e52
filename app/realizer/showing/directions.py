"""Where the things are that gestures point at, as far as the words say: a direction for each, kept through the line.

Words give a side, near or far, above or below; where they leave the side open, things that are named one after the
other lie apart, so that pointing at one is not pointing at the other, and what was named before is where it was.
Conventions: degrees; azimuths are positive to the performer's left, elevations above the horizontal. Positions are
metres in the world (`understudy.realizer.body.skeleton`).
"""

from collections.abc import Iterable, Iterator, Mapping
from math import cos, radians, sin
from types import MappingProxyType

from ...model import Hand
from ...model.slots import Distance, Side, Slots, Which
from ..gestures.gesture_plan import GestureRequest, Position

POINTING: Mapping[str, Side | None] = MappingProxyType(
    {
        "THERE": None,
        "POINT_LEFT": Side.LEFT,
        "PALM_LEFT": Side.LEFT,
        "POINT_RIGHT": Side.RIGHT,
        "PALM_RIGHT": Side.RIGHT,
        "POINT_FRONT": None,
    }
)
"""The categories that point, and the side that some are for."""

OWN_SIDE_DEG, ACROSS_DEG, AHEAD_DEG, BEHIND_DEG = 55.0, 38.0, 8.0, 140.0
"""How far to a side a hand points on its own side and across the body, and what is ahead or behind."""

APART_DEG = 50.0
"""Between things that lie in different places."""

_FREE_DEG = (35.0, -32.0, 85.0)
"""Where things lie whose side nobody says, the first that is free, seen from the side of the hand."""

_FROM_M: Position = (0.0, 1.40, 0.0)
"""The middle between the shoulders."""

_HOW_FAR_M = MappingProxyType({Distance.NEAR: 1.2, None: 2.5, Distance.FAR: 4.0})
_LEVEL_DEG = MappingProxyType({Distance.NEAR: -18.0, None: 0.0, Distance.FAR: 4.0})
"""The elevation of what is neither above nor below: what is near is lower than the shoulders."""

_SAG_DEG = 6.0
"""By how much a hand that points up is lower in a body that bows with its strokes."""

NOWHERE = Slots()


def directed(slots: Slots) -> bool:
    """Whether the words say anything of where a thing is, or name it."""
    return any((slots.side, slots.distance, slots.which, slots.referent, slots.elevation_deg is not None))


def aims_m(requests: Iterable[GestureRequest]) -> Mapping[str, Position]:
    """What each pointing gesture of a line points at, by its behaviour, for those of which the words say something and
    that have no target of the scene; requests are in order of their strokes."""
    pointing = [each for each in requests if _points_somewhere(each)]
    sides = _first_said_deg(pointing)
    known: dict[object, float] = {}
    found: dict[str, Position] = {}
    for request in pointing:
        slots = request.slots or NOWHERE
        thing = _thing(slots)
        said = _said_deg(_side(request.category, slots, known=thing in known), request.hand)
        taken = (*known.values(), *(place for other, place in sides.items() if other != thing))
        azimuth_deg = known.get(thing, _free_deg(taken, request.hand)) if said is None else said
        known[thing] = azimuth_deg
        found[request.behavior] = _position_m(slots, azimuth_deg)
    return found


def _points_somewhere(request: GestureRequest) -> bool:
    return request.category in POINTING and request.target is None and directed(request.slots or NOWHERE)


def _thing(slots: Slots) -> object:
    """What is pointed at: by its name, else by what the words say of where it is."""
    return slots.referent or (slots.which, slots.distance, slots.elevation_deg)


def _first_said_deg(pointing: Iterable[GestureRequest]) -> Mapping[object, float]:
    """The azimuths of the things that have a side when they are first pointed at: those before them that have none keep
    clear of these too ("on this wall … over there on the right")."""
    first: dict[object, float | None] = {}
    for request in pointing:
        slots = request.slots or NOWHERE
        first.setdefault(_thing(slots), _said_deg(_side(request.category, slots, known=False), request.hand))
    return {thing: place for thing, place in first.items() if place is not None}


def _side(category: str, slots: Slots, *, known: bool) -> Side | None:
    """The side on which a thing is: as the words say, else that of the gesture; a thing that is `known` by its name
    stays where it was shown, whichever gesture and hand point at it again."""
    return slots.side if known and slots.referent is not None else slots.side or POINTING[category]


def _outwards(hand: Hand) -> float:
    """The sign of azimuths on a hand's own side; two hands point as the right one does."""
    return 1.0 if hand is Hand.LEFT else -1.0


def _said_deg(side: Side | None, hand: Hand) -> float | None:
    """The azimuth of a side; None where it is open."""
    outwards = _outwards(hand)
    match side:
        case Side.LEFT | Side.RIGHT:
            sign = 1.0 if side is Side.LEFT else -1.0
            return sign * (OWN_SIDE_DEG if sign == outwards else ACROSS_DEG)
        case Side.FRONT:
            return outwards * AHEAD_DEG
        case Side.BEHIND:
            return outwards * BEHIND_DEG
    return None


def _free_deg(taken: Iterable[float], hand: Hand) -> float:
    """The first azimuth that is apart from all that are taken, else the one that is farthest from them."""
    others = list(taken)
    places = [_outwards(hand) * place for place in _FREE_DEG]

    def apart_deg(place: float) -> float:
        return min((abs(place - other) for other in others), default=APART_DEG)

    return next((place for place in places if apart_deg(place) >= APART_DEG), max(places, key=apart_deg))


def _position_m(slots: Slots, azimuth_deg: float) -> Position:
    elevation_deg = _LEVEL_DEG[slots.distance] if slots.elevation_deg is None else slots.elevation_deg
    elevation_deg += _SAG_DEG if elevation_deg > _SAG_DEG else 0.0
    x, y, z = _direction(azimuth_deg, elevation_deg)
    how_far_m = _HOW_FAR_M[slots.distance]
    return _FROM_M[0] + how_far_m * x, _FROM_M[1] + how_far_m * y, _FROM_M[2] + how_far_m * z


def _direction(azimuth_deg: float, elevation_deg: float) -> Position:
    azimuth, elevation = radians(azimuth_deg), radians(elevation_deg)
    return sin(azimuth) * cos(elevation), sin(elevation), cos(azimuth) * cos(elevation)


def points_far(slots: Slots) -> bool:
    """Whether what is pointed at is out of reach, so that the arm is stretched and a finger shows the way."""
    return slots.distance is Distance.FAR or slots.elevation_deg is not None or slots.which is Which.THAT


def told(slots: Slots) -> Iterator[str]:
    """What the words say of a place, in words."""
    if slots.side is not None:
        yield f"on the {slots.side}" if slots.side in (Side.LEFT, Side.RIGHT) else f"{slots.side}"
    if slots.distance is not None:
        yield f"{slots.distance}"
    if slots.elevation_deg is not None:
        yield f"{slots.elevation_deg:+.0f}° up"
    if slots.referent is not None:
        yield f"{slots.referent!r}"
