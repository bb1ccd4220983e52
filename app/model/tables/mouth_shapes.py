"""The fifteen mouth shapes of lip sync, the phones that have them, and how wide each opens the jaw."""

from collections.abc import Mapping
from types import MappingProxyType

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
