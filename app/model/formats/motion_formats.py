"""The file formats that motion is written in, chosen by file name, and their options."""

from dataclasses import dataclass, field
from enum import StrEnum

from ...errors import InputError


class MotionFormat(StrEnum):
    """The file formats of motion, by the suffix of their files."""

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
    """Who plays MPEG-4 parameters, by the version in the first line of a body's file: MPEG-4's players, or Greta, with
    the signs and the order of its skeleton and one number for each parameter of the face."""

    MPEG4 = "3.1"
    GRETA = "2.1"


@dataclass(frozen=True, slots=True)
class AudioFile:
    """The recording as motion files refer to it: its file name, relative to theirs, and its content."""

    name: str
    content: bytes = field(repr=False)


@dataclass(frozen=True, slots=True)
class FileOptions:
    """How files are written: BVH with a T-pose as its first frame, or with its root at the origin; GLB with baked or
    sparse keys; formats with sound, with the recording; FBX by `blender`, or a Python that has `bpy`; body parameters
    for the players of one version."""

    t_pose: bool = False
    root_at_origin: bool = False
    keys: Keys = Keys.BAKED
    audio: AudioFile | None = None
    blender: str | None = None
    bap: BapVersion = BapVersion.MPEG4


SCENES = frozenset({MotionFormat.USDA, MotionFormat.USDC, MotionFormat.USDZ})
"""Formats that usd-core writes."""

EDITORIAL = frozenset({MotionFormat.OTIO, MotionFormat.TEXTGRID, MotionFormat.EAF, MotionFormat.EVENTS})
"""Formats of timelines, tiers and tables of behaviours, rather than of motion."""

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
