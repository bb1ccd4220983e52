"""The forms in which results are written: a schedule as BML (its dialect, how times are written, names of files and
visemes), and motion in file formats, chosen by file name, with their options.
"""

from dataclasses import dataclass, field
from enum import StrEnum
from pathlib import PurePath

from ..errors import InputError


class DialectName(StrEnum):
    """The supported dialects of BML."""

    BML = "bml"
    SMARTBODY = "smartbody"


class TimeForm(StrEnum):
    """How times are written: in seconds, or relative to the sync marks of the speech."""

    ABSOLUTE = "absolute"
    SYNC = "sync"


class VisemeNames(StrEnum):
    """The vocabulary of mouth shapes."""

    SMARTBODY = "smartbody"
    FACEFX = "facefx"


@dataclass(frozen=True, slots=True)
class BmlForm:
    """The output format. Absolute times are the default, because realizers do not know the word times of recorded
    speech. `audio_file` is the name of the recording's file, with which SmartBody finds it, and ASAP if `bmlt_audio`
    adds an element that plays it, which strict readers of the core refuse. `visemes` selects the names of visemes for
    SmartBody."""

    dialect: DialectName = DialectName.BML
    timing: TimeForm = TimeForm.ABSOLUTE
    audio_file: str | None = None
    bmlt_audio: bool = False
    visemes: VisemeNames = VisemeNames.SMARTBODY

    @property
    def audio_name(self) -> str | None:
        """The name of the recording's file without its extension."""
        return PurePath(self.audio_file).stem if self.audio_file else None


CORE_FORM = BmlForm()
"""BML 1.0 core with absolute times."""


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
