"""Hand shapes as rotations of fifteen finger joints (Gesture Engine §4.2; the twelve basic forms of HamNoSys 2.0).

Conventions: the left hand, local rotations (15, 4) in the skeleton's order: thumb, index, middle, ring and little
finger, each from the palm outwards. Tables are in degrees; fingers bend towards the palm, and positive spread is from
the middle finger towards the thumb's side. HamNoSys has drawings only; the angles are ours, set by eye, those of
pinches and C shapes so that fingertips meet or face each other.
"""

from collections.abc import Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType

import numpy as np

from ...model import FloatArray
from ..geometry.rotations import from_rotation_vector, multiply
from .gesture import Bend, Finger, HandForm, HandShape, Thumb

FingerBends = tuple[float, float, float, float]
"""Proximal, intermediate and distal flexion, and spread."""
ThumbBends = tuple[float, float, float, float, float]
"""At the root: towards the index finger, below the palm, roll; then proximal and distal flexion."""

_CLOSED: FingerBends = (85.0, 100.0, 60.0, 0.0)
_STRAIGHT: FingerBends = (0.0, 3.0, 2.0, 0.0)
_RELAXED: tuple[FingerBends, ...] = (
    (16.0, 27.0, 13.0, 1.0),
    (25.0, 33.0, 17.0, 0.0),
    (29.0, 37.0, 20.0, -1.0),
    (27.0, 33.0, 18.0, -5.0),
)
_FIST = (_CLOSED,) * 4
_OPEN: tuple[FingerBends, ...] = (
    (2.0, 5.0, 3.0, 6.0),
    (3.0, 6.0, 3.0, 0.0),
    (4.0, 8.0, 4.0, -6.0),
    (6.0, 9.0, 5.0, -13.0),
)
_SPREAD: tuple[FingerBends, ...] = (
    (0.0, 4.0, 2.0, 16.0),
    (0.0, 4.0, 2.0, 2.0),
    (0.0, 5.0, 3.0, -11.0),
    (0.0, 5.0, 3.0, -24.0),
)
_THREE_APART = (15.0, 0.0, -15.0, 0.0)
"""The spread of fingers of which three are stretched."""
_PINCHING: FingerBends = (48.0, 52.0, 24.0, 0.0)
_CEE: FingerBends = (42.0, 36.0, 24.0, 0.0)

_FINGERS: Mapping[HandForm, tuple[FingerBends, ...]] = MappingProxyType(
    {
        HandForm.DEFAULT: _RELAXED,
        HandForm.FIST: _FIST,
        HandForm.FLAT: (_STRAIGHT,) * 4,
        HandForm.SPREAD: _SPREAD,
        HandForm.INDEX: (_STRAIGHT, _CLOSED, _CLOSED, _CLOSED),
        HandForm.TWO: (_STRAIGHT, _STRAIGHT, _CLOSED, _CLOSED),
        HandForm.TWO_APART: ((0.0, 3.0, 2.0, 12.0), (0.0, 3.0, 2.0, -10.0), _CLOSED, _CLOSED),
        HandForm.PINCH: (_PINCHING, _CLOSED, _CLOSED, _CLOSED),
        HandForm.PINCH_ALL: (
            _PINCHING,
            (52.0, 52.0, 24.0, 3.0),
            (54.0, 50.0, 26.0, 12.0),
            (56.0, 48.0, 30.0, 22.0),
        ),
        HandForm.PINCH_OPEN: (_PINCHING, *_OPEN[1:]),
        HandForm.CEE: (_CEE, _CLOSED, _CLOSED, _CLOSED),
        HandForm.CEE_ALL: (_CEE, _CEE, _CEE, (44.0, 36.0, 24.0, 0.0)),
        HandForm.CEE_OPEN: (_CEE, *_OPEN[1:]),
    }
)

_PINCHING_THUMB: ThumbBends = (10.0, 20.0, 16.0, 18.0, 20.0)
_CEE_THUMB: ThumbBends = (16.0, 30.0, 25.0, 0.0, 5.0)
_OVER_THE_FIST: ThumbBends = (6.0, 7.0, 10.0, 42.0, 60.0)

_THUMBS: Mapping[Thumb, ThumbBends] = MappingProxyType(
    {
        Thumb.OPEN: (28.0, 4.0, 0.0, 2.0, 0.0),
        Thumb.OUT: (-28.0, -4.0, 0.0, -8.0, -8.0),
        Thumb.ACROSS: (30.0, 14.0, 10.0, 30.0, 50.0),
    }
)
_OWN_THUMBS: Mapping[HandForm, ThumbBends] = MappingProxyType(
    {
        HandForm.DEFAULT: (20.0, 14.0, 8.0, 14.0, 16.0),
        HandForm.FIST: _OVER_THE_FIST,
        HandForm.FLAT: (24.0, 4.0, 0.0, 2.0, 2.0),
        HandForm.SPREAD: (-14.0, 4.0, 0.0, -4.0, -4.0),
        HandForm.INDEX: _OVER_THE_FIST,
        HandForm.TWO: _OVER_THE_FIST,
        HandForm.TWO_APART: _OVER_THE_FIST,
        HandForm.PINCH: _PINCHING_THUMB,
        HandForm.PINCH_ALL: _PINCHING_THUMB,
        HandForm.PINCH_OPEN: _PINCHING_THUMB,
        HandForm.CEE: _CEE_THUMB,
        HandForm.CEE_ALL: _CEE_THUMB,
        HandForm.CEE_OPEN: _CEE_THUMB,
    }
)
"""The default thumb of each form."""

_BENDS: Mapping[Bend, tuple[float, float, float]] = MappingProxyType(
    {
        Bend.STRAIGHT: (0.0, 3.0, 2.0),
        Bend.CURVED: (25.0, 38.0, 22.0),
        Bend.ANGLED: (70.0, 8.0, 4.0),
        Bend.HOOKED: (8.0, 95.0, 55.0),
        Bend.CLOSED: _CLOSED[:3],
    }
)
_THUMB_BENDS: Mapping[Bend, tuple[float, float]] = MappingProxyType(
    {
        Bend.STRAIGHT: (0.0, 0.0),
        Bend.CURVED: (18.0, 25.0),
        Bend.ANGLED: (40.0, 5.0),
        Bend.HOOKED: (8.0, 60.0),
        Bend.CLOSED: (45.0, 50.0),
    }
)

THUMB_HINGE: FloatArray = np.array([0.513, 0.643, -0.570])
"""The flexion axis of the thumb, whose pad faces the palm and the fingers instead of down."""

_ORDER = tuple(Finger)


@lru_cache(maxsize=256)
def hand_shape(shape: HandShape, fingers: tuple[tuple[Finger, Bend], ...] = ()) -> FloatArray:
    """The finger joints' local rotations (15, 4) of a form, overridden by the bends of single fingers. Cached and
    read-only."""
    thumb = _OWN_THUMBS[shape.form] if shape.thumb is Thumb.DEFAULT else _THUMBS[shape.thumb]
    others = list(_FINGERS[shape.form])
    for finger, bend in fingers:
        if finger is Finger.THUMB:
            thumb = (*thumb[:3], *_THUMB_BENDS[bend])
        else:
            number = _ORDER.index(finger) - 1
            others[number] = (*_BENDS[bend], others[number][3])
    if shape.form is HandForm.TWO_APART and (Finger.RING, Bend.STRAIGHT) in fingers:
        others = [(*each[:3], spread) for each, spread in zip(others, _THREE_APART, strict=True)]
    rotations = _rotations(thumb, others)
    rotations.setflags(write=False)
    return rotations


def finger_rows(finger: Finger) -> slice:
    """The rows of a finger's three joints among the fifteen."""
    first = 3 * _ORDER.index(finger)
    return slice(first, first + 3)


def _rotations(thumb: ThumbBends, others: Sequence[FingerBends]) -> FloatArray:
    """Each joint's flexion, combined at its root with the thumb's opposition or the finger's spread."""
    bends, roots = np.zeros((15, 3)), np.zeros((15, 3))
    inwards, below, rolled, *hinges = thumb
    roots[0], bends[0] = (0.0, inwards, -below), (rolled, 0.0, 0.0)
    bends[1:3] = np.array(hinges)[:, None] * THUMB_HINGE
    angles = np.array(others)
    bends[3:, 2], roots[3::3, 1] = -angles[:, :3].ravel(), -angles[:, 3]
    return multiply(from_rotation_vector(np.radians(roots)), from_rotation_vector(np.radians(bends)))
