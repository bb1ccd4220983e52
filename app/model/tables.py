"""Tables of names: the lexemes of gazes and faces, BML 1.0's and FACS action units for what it has no lexeme for; and
the fifteen mouth shapes of lip sync, the phones that have them, and how wide each opens the jaw.

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


SILENCE = "sil"
"""The mouth shape at rest."""

PHONES: Mapping[str, tuple[str, ...]] = MappingProxyType(
    {
        "PP": ("P", "B", "M"),
        "FF": ("F", "V"),
        "TH": ("TH", "DH"),
        "DD": ("T", "D"),
        "kk": ("K", "G", "NG"),
        "CH": ("CH", "JH", "SH", "ZH"),
        "SS": ("S", "Z"),
        "nn": ("N", "L"),
        "RR": ("R", "ER"),
        "aa": ("AA", "AH", "AY", "AW"),
        "E": ("EH", "AE", "EY"),
        "I": ("IH", "IY", "Y"),
        "O": ("AO", "OW", "OY"),
        "U": ("UH", "UW", "W"),
    }
)
"""The shapes other than silence, with their phones."""

OPENINGS: Mapping[str, float] = MappingProxyType(
    {
        SILENCE: 0.0,
        "PP": 0.0,
        "FF": 0.05,
        "SS": 0.1,
        "CH": 0.15,
        "TH": 0.15,
        "DD": 0.15,
        "nn": 0.2,
        "kk": 0.2,
        "RR": 0.25,
    }
    | {"U": 0.2, "I": 0.3, "O": 0.5, "E": 0.6, "aa": 1.0}
)
"""How wide the jaw is open in each shape, relative to the widest; ordered as the heights of the vowels."""
