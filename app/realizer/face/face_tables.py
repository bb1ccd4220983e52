"""The face's lexicon (lexicon/face.yaml): action units, lexemes and visemes as weights of the 52 blendshapes.

Conventions: weights are in the order of `SHAPES`; a name without Left or Right means both sides. All mistakes of the
file are reported at once, with their place.
"""

from collections.abc import Collection, Iterator, Mapping
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, model_validator

from ...errors import AuthoringError, Mistake, did_you_mean
from ...model import FloatArray
from ...yaml_files import Entry, Source
from ..body.motion import SHAPES

INDEX: Mapping[str, int] = MappingProxyType({name: number for number, name in enumerate(SHAPES)})

VISEMES = ("sil", "PP", "FF", "TH", "DD", "kk", "CH", "SS", "nn", "RR", "aa", "E", "I", "O", "U")
"""The fifteen visemes in the order that rigs use (docs/references.md)."""

SILENCE = "sil"

_SIDES = ("Left", "Right")


def _columns_by_name() -> dict[str, tuple[int, ...]]:
    """The columns of each name: the 52 shapes, and the pairs of those that exist for both halves of the face.

    `jaw` and `mouth` are not among the pairs: jawLeft and jawRight are two directions of one jaw.
    """
    found: dict[str, tuple[int, ...]] = {name: (number,) for name, number in INDEX.items()}
    for name in SHAPES:
        both = name.removesuffix("Left")
        if both not in {name, "jaw", "mouth"}:
            found[both] = tuple(INDEX[both + side] for side in _SIDES)
    return found


COLUMNS: Mapping[str, tuple[int, ...]] = MappingProxyType(_columns_by_name())
"""The columns of each name that the file may use."""


class Articulator(StrEnum):
    """The independent articulators of speech: a T constrains the jaw strongly and the rounding of the lips hardly at
    all."""

    JAW = "jaw"
    LIPS = "lips"
    ROUNDING = "rounding"
    TONGUE = "tongue"


class FaceSide(StrEnum):
    LEFT = "left"
    RIGHT = "right"
    BOTH = "both"


@dataclass(frozen=True, slots=True, eq=False)
class Dominance:
    """The dominance (visemes, articulators) of each viseme over each articulator. It decays to 1/e in `before_s` ahead
    of the phone and `after_s` behind it; `inset_s` (articulators,) is how far inside the phone's bounds it is at its
    maximum."""

    strength: FloatArray
    before_s: FloatArray
    after_s: FloatArray
    inset_s: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class VisemeTable:
    """The visemes in the order of `VISEMES`. `targets` (15, 52) are their shapes, with lip closure as a share of the
    jaw's opening; `articulator` (52,) is the index in `Articulator` of what moves each shape, or -1."""

    targets: FloatArray
    leaves_corners: FloatArray
    dominance: Dominance
    articulator: tuple[int, ...]
    widest_jaw: float


@dataclass(frozen=True, slots=True)
class EyeTable:
    """The eye rotations in degrees at which each look shape reaches 1, and the shares of a look down and up that lids
    follow."""

    out_deg: float
    in_deg: float
    up_deg: float
    down_deg: float
    lids_down: float
    lids_up: float


@dataclass(frozen=True, slots=True, eq=False)
class FaceTables:
    """The validated file. `lexemes` has the 52 weights of every lexeme and action unit (`AU12`) at full amount."""

    lexemes: Mapping[str, FloatArray]
    visemes: VisemeTable
    eyes: EyeTable

    @classmethod
    def load(cls, path: Path) -> "FaceTables":
        """Read and validate the file. Raises AuthoringError with all its mistakes."""
        source = Source(path)
        file = source.validated(_FaceFile)
        mistakes = tuple(_mistakes(source, file))
        if mistakes:
            raise AuthoringError(mistakes)
        units = {name: _weights(shapes) for name, shapes in file.units.items()}
        lexemes = {name: _lexeme_weights(entry, units) for name, entry in file.lexemes.items()}
        return cls(MappingProxyType(units | lexemes), _viseme_table(file), _eye_table(file.eyes))


def sided(weights: FloatArray, side: FaceSide) -> FloatArray:
    """The weights on one side of the face; shapes that belong to neither side are halved."""
    if side is FaceSide.BOTH:
        return weights
    other = "Right" if side is FaceSide.LEFT else "Left"
    own = side.value.capitalize()
    shares = [0.0 if name.endswith(other) else 1.0 if name.endswith(own) else 0.5 for name in SHAPES]
    return np.asarray(weights * np.array(shares))


_Weight = Annotated[float, Field(ge=0, le=1, allow_inf_nan=False)]
_Pressed = Annotated[float, Field(ge=0, le=2, allow_inf_nan=False)]
_Strength = Annotated[float, Field(gt=0, le=100, allow_inf_nan=False)]
_Fade = Annotated[float, Field(ge=5, le=100, allow_inf_nan=False)]
_Degrees = Annotated[float, Field(gt=0, le=90, allow_inf_nan=False)]
_Unit = Annotated[str, Field(pattern=r"^AU[1-9][0-9]?$")]
_Lexeme = Annotated[str, Field(pattern=r"^[A-Z][A-Z0-9_]*$")]


class _LexemeEntry(Entry):
    units: dict[str, _Weight]
    side: FaceSide = FaceSide.BOTH


class _ArticulatorEntry(Entry):
    shapes: list[str]
    before_ms: _Fade
    after_ms: _Fade
    reaches_in_ms: Annotated[float, Field(ge=0, le=100, allow_inf_nan=False)]


class _VisemeEntry(Entry):
    shapes: dict[str, _Pressed] = Field(default_factory=dict)
    dominance: dict[Articulator, _Strength] = Field(default_factory=dict)
    before_ms: dict[Articulator, _Fade] = Field(default_factory=dict)
    after_ms: dict[Articulator, _Fade] = Field(default_factory=dict)
    leaves_corners: _Weight


class _EyesEntry(Entry):
    whole_look_deg: dict[Literal["out", "in", "up", "down"], _Degrees]
    lids_follow: dict[Literal["up", "down"], _Weight]

    @model_validator(mode="after")
    def _whole(self) -> "_EyesEntry":
        missing = {"out", "in", "up", "down"} - self.whole_look_deg.keys()
        missing |= {"up", "down"} - self.lids_follow.keys()
        if missing:
            raise ValueError(f"missing: {', '.join(sorted(missing))}")
        return self


class _FaceFile(Entry):
    units: dict[_Unit, dict[str, _Weight]]
    lexemes: dict[_Lexeme, _LexemeEntry]
    articulators: dict[Articulator, _ArticulatorEntry]
    widest_jaw: _Weight
    visemes: dict[str, _VisemeEntry]
    eyes: _EyesEntry


def _mistakes(source: Source, file: _FaceFile) -> Iterator[Mistake]:
    for section, names in (("units", COLUMNS), ("lexemes", file.units)):
        yield from _unknown_parts(source, file, section, names)
    yield from _missing(source, "articulators", [each.value for each in Articulator], file.articulators)
    yield from _missing(source, "visemes", VISEMES, file.visemes)
    yield from _articulator_mistakes(source, file)
    spoken = [name for entry in file.articulators.values() for name in entry.shapes if name != "jawOpen"]
    for label, viseme in file.visemes.items():
        if label not in VISEMES:
            yield source.mistake(("visemes", label), f"no viseme is called {label!r}{did_you_mean(label, VISEMES)}")
        for name, weight in viseme.shapes.items():
            place = ("visemes", label, "shapes", name)
            if name not in spoken:
                yield source.mistake(place, f"no articulator moves {name!r}{did_you_mean(name, spoken)}")
            elif weight > 1 and name != "mouthClose":
                yield source.mistake(place, "only `mouthClose` may be more than 1")


def _unknown_parts(source: Source, file: _FaceFile, section: str, known: Collection[str]) -> Iterator[Mistake]:
    """Unknown names: units are made of shapes, lexemes of units."""
    parts: Mapping[str, Collection[str]] = (
        file.units if section == "units" else {name: entry.units for name, entry in file.lexemes.items()}
    )
    for name, words in parts.items():
        for word in words:
            if word not in known:
                place = (section, name, word) if section == "units" else (section, name, "units", word)
                kind = "shape" if section == "units" else "action unit"
                yield source.mistake(place, f"no {kind} is called {word!r}{did_you_mean(word, known)}")


def _missing(source: Source, section: str, wanted: Collection[str], found: Collection[str]) -> Iterator[Mistake]:
    for name in wanted:
        if name not in found:
            yield source.mistake((section,), f"{name} is missing in {section}")


def _articulator_mistakes(source: Source, file: _FaceFile) -> Iterator[Mistake]:
    """Shapes that do not exist, and shapes that belong to two articulators."""
    moved: set[str] = set()
    for articulator, entry in file.articulators.items():
        for number, name in enumerate(entry.shapes):
            place = ("articulators", articulator.value, "shapes", number)
            if name not in COLUMNS:
                yield source.mistake(place, f"no shape is called {name!r}{did_you_mean(name, COLUMNS)}")
            elif name in moved:
                yield source.mistake(place, f"{name!r} is moved by another articulator already")
            moved.add(name)


def _weights(shapes: Mapping[str, float]) -> FloatArray:
    weights = np.zeros(len(SHAPES))
    for name, weight in shapes.items():
        weights[list(COLUMNS[name])] = weight
    return weights


def _lexeme_weights(entry: _LexemeEntry, units: Mapping[str, FloatArray]) -> FloatArray:
    """Combine the units of a lexeme; shapes of several units add up to at most 1, as behaviours do (`expressions`)."""
    left = np.ones(len(SHAPES))
    for unit, share in entry.units.items():
        left *= 1 - share * units[unit]
    return sided(1 - left, entry.side)


def _viseme_table(file: _FaceFile) -> VisemeTable:
    entries = [file.visemes[label] for label in VISEMES]
    articulator = np.full(len(SHAPES), -1)
    for number, name in enumerate(Articulator):
        for shape in file.articulators[name].shapes:
            articulator[list(COLUMNS[shape])] = number
    return VisemeTable(
        targets=np.array([_weights(entry.shapes) for entry in entries]),
        leaves_corners=np.array([entry.leaves_corners for entry in entries]),
        dominance=_dominance(file, entries),
        articulator=tuple(articulator.tolist()),
        widest_jaw=file.widest_jaw,
    )


def _dominance(file: _FaceFile, entries: list[_VisemeEntry]) -> Dominance:
    usual = [(name, file.articulators[name]) for name in Articulator]
    return Dominance(
        strength=np.array([[entry.dominance.get(name, 1.0) for name, _ in usual] for entry in entries]),
        before_s=np.array([[entry.before_ms.get(name, own.before_ms) for name, own in usual] for entry in entries])
        / 1e3,
        after_s=np.array([[entry.after_ms.get(name, own.after_ms) for name, own in usual] for entry in entries]) / 1e3,
        inset_s=np.array([own.reaches_in_ms for _, own in usual]) / 1e3,
    )


def _eye_table(entry: _EyesEntry) -> EyeTable:
    whole, lids = entry.whole_look_deg, entry.lids_follow
    return EyeTable(whole["out"], whole["in"], whole["up"], whole["down"], lids["down"], lids["up"])
