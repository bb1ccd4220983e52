"""The lexemes of gazes and faces: BML 1.0's, and FACS action units for what it has no lexeme for.

A blink is action unit 45 and not the core's CLOSE_EYES, which is an eye that closes and stays closed (unit 43); BML
gives units in `faceFacs`, in its core extensions, which strict parsers read.
"""

from collections.abc import Mapping
from enum import StrEnum
from types import MappingProxyType

LOOK, GLANCE, SHIFT = "LOOK", "GLANCE", "SHIFT"
GAZE_LEXEMES = frozenset({LOOK, GLANCE, SHIFT})


class GazeDirection(StrEnum):
    """The offset of a gaze from its target (BML 1.0, `offsetDirection`)."""

    LEFT = "LEFT"
    RIGHT = "RIGHT"
    UP = "UP"
    DOWN = "DOWN"
    UPLEFT = "UPLEFT"
    UPRIGHT = "UPRIGHT"
    DOWNLEFT = "DOWNLEFT"
    DOWNRIGHT = "DOWNRIGHT"


CORE_LEXEMES = frozenset(
    {
        "OBLIQUE_BROWS",
        "RAISE_BROWS",
        "RAISE_LEFT_BROW",
        "RAISE_RIGHT_BROW",
        "LOWER_BROWS",
        "LOWER_LEFT_BROW",
        "LOWER_RIGHT_BROW",
        "LOWER_MOUTH_CORNERS",
        "LOWER_LEFT_MOUTH_CORNER",
        "LOWER_RIGHT_MOUTH_CORNER",
        "RAISE_MOUTH_CORNERS",
        "RAISE_LEFT_MOUTH_CORNER",
        "RAISE_RIGHT_MOUTH_CORNER",
        "OPEN_MOUTH",
        "OPEN_LIPS",
        "WIDEN_EYES",
        "CLOSE_EYES",
    }
)
"""The lexemes of BML 1.0's `faceLexeme`."""

ACTION_UNITS: Mapping[str, int] = MappingProxyType(
    {
        "RAISE_CHEEKS": 6,
        "NARROW_EYES": 7,
        "WRINKLE_NOSE": 9,
        "DIMPLE": 14,
        "PUCKER_LIPS": 18,
        "STRETCH_LIPS": 20,
        "PRESS_LIPS": 24,
        "BLINK": 45,
    }
)
"""Our lexemes for FACS action units."""

LIDS_AND_CHEEKS = frozenset({"WIDEN_EYES", "CLOSE_EYES", "NARROW_EYES", "RAISE_CHEEKS"})
"""The lexemes of lids and cheeks, which brows and mouth leave free."""

LOWER_FACE = frozenset(
    lexeme
    for lexeme in (*CORE_LEXEMES, *ACTION_UNITS)
    if any(part in lexeme for part in ("MOUTH", "LIP", "NOSE", "DIMPLE"))
)
"""The lexemes of mouth and nose; the others are of brows, or of lids and cheeks. FACS divides the face in the same way:
the parts move independently of each other."""
