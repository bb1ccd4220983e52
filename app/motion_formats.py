"""What motion is written as, told by the name of its file, and how."""

from dataclasses import dataclass, field
from enum import StrEnum

from .errors import InputError


class MotionFormat(StrEnum):
    """What motion is written as, by what the names of its files end in."""

    BVH = ".bvh"
    GLB = ".glb"
    VRMA = ".vrma"
    JSON = ".json"
    CSV = ".csv"
    VISEMES = ".visemes.txt"
    USDA = ".usda"
    USDC = ".usdc"
    USDZ = ".usdz"
    FBX = ".fbx"
    BAP = ".bap"
    FAP = ".fap"
    OTIO = ".otio"
    TEXTGRID = ".TextGrid"
    EAF = ".eaf"
    EVENTS = ".events.csv"
    SHEET = ".png"
    SPEEDS = ".speed.png"


class Keys(StrEnum):
    """The keys of a GLB's animation: one in every frame, or only those that an animator needs, and markers."""

    BAKED = "baked"
    SPARSE = "sparse"


class BapVersion(StrEnum):
    """What the first line of MPEG-4 body parameters says: MPEG-4's version, or what Greta has for the same units."""

    MPEG4 = "3.1"
    GRETA = "2.1"


@dataclass(frozen=True, slots=True)
class AudioFile:
    """The recording as files refer to it: by the name of its file, from where they lie, and its content."""

    name: str
    content: bytes = field(repr=False)


@dataclass(frozen=True, slots=True)
class FileOptions:
    """How files are written: BVH with a T-pose as its first frame, or with its root at the origin; GLB with baked keys
    or sparse ones; formats that know of sound with the recording; FBX by `blender`, or a Python that has `bpy`; body
    parameters with the version of their first line."""

    t_pose: bool = False
    root_at_origin: bool = False
    keys: Keys = Keys.BAKED
    audio: AudioFile | None = None
    blender: str | None = None
    bap: BapVersion = BapVersion.MPEG4


SCENES = frozenset({MotionFormat.USDA, MotionFormat.USDC, MotionFormat.USDZ})
"""Formats that usd-core writes."""

EDITORIAL = frozenset({MotionFormat.OTIO, MotionFormat.TEXTGRID, MotionFormat.EAF, MotionFormat.EVENTS})
"""Timelines, tiers and tables of what happens, rather than the motion."""

PICTURES = frozenset({MotionFormat.SHEET, MotionFormat.SPEEDS})
"""Formats that matplotlib draws."""


def is_editorial(name: str) -> bool:
    """Whether a file of this name is one of `EDITORIAL`."""
    return name.lower().endswith(tuple(form.value.lower() for form in EDITORIAL))


def format_of(name: str) -> MotionFormat:
    """The format of a file's name; raises InputError `motion_format`."""
    lower = name.lower()
    fitting = [each for each in MotionFormat if lower.endswith(each.value.lower())]
    if not fitting:
        known = ", ".join(each.value for each in MotionFormat)
        raise InputError("motion_format", f"{name}: motion is written as {known}; end the name in one of them")
    return max(fitting, key=lambda each: len(each.value))
