"""The keys of a profile's file, and the ranges of its numbers (docs/profiles.md)."""

from typing import Annotated

from pydantic import BeforeValidator, Field

from ...model import Hand
from ...yaml_files import Entry
from ..annotation.model import PathForm

_Share = Annotated[float, Field(ge=0, le=1)]
_Seconds = Annotated[float, Field(ge=0, le=10)]
_Lexeme = Annotated[str, Field(pattern=r"^[A-Z][A-Z0-9_]*$")]
_Shares = dict[str, _Share]
_Durations = tuple[_Seconds, _Seconds]
_Offset = tuple[Annotated[float, Field(ge=-5, le=5)], _Seconds]
_Strokes = tuple[Annotated[float, Field(ge=1, le=20)], Annotated[float, Field(ge=0, le=10)]]


def _several(said: object) -> object:
    """One share for all sizes of units is a list of one."""
    return said if isinstance(said, list) else [said]


class TagForm(Entry):
    occurrences: int = Field(ge=0)
    gestures: dict[_Lexeme, _Share]


class LexemeForm(Entry):
    share: _Share
    hands: dict[Hand, _Share]
    strokes: _Strokes = (1.0, 0.0)
    offset_s: _Offset = (0.0, 0.1)
    held: _Share = 0.0
    size: float = Field(default=1.0, ge=0.3, le=2.0)


class UnitForm(Entry):
    merge_within_s: float = Field(default=1.5, ge=0, le=10)
    joined: Annotated[tuple[_Share, ...], Field(min_length=1, max_length=6), BeforeValidator(_several)] = (1.0,)
    sizes: tuple[_Share, ...] = Field(default=(), max_length=7)


class PhaseForm(Entry):
    preparation_s: _Durations = (0.45, 0.1)
    hold_s: _Durations = (0.3, 0.2)
    retraction_s: _Durations = (0.53, 0.1)
    after_stroke_s: _Durations = (0.35, 0.05)


class RestForm(Entry):
    near: str = "clasped"
    medium: str = "at_side"
    far: str = "in_pockets"
    near_s: float = Field(default=3.0, ge=0, le=60)
    far_s: float = Field(default=10.0, ge=0, le=600)


class HeadForm(Entry):
    per_minute: dict[str, Annotated[float, Field(ge=0, le=120)]] = Field(default_factory=dict)
    eye_contact: Annotated[float, Field(ge=0.05, le=0.95)] | None = None
    postures: tuple[str, ...] = ()


class SmoothingForm(Entry):
    tags: float = 0.0
    sequence: float = 0.0
    hands: float = 0.0
    hand_sequence: float = 0.0
    held_out: float = 0.0
    blind: float = 0.0


class LeadForm(Entry):
    main: _Seconds = 0.3
    after: _Seconds = 0.12


class OccurrenceForm(Entry):
    lexeme: _Lexeme
    hand: Hand
    start: str = Field(alias="from")
    end: str = Field(alias="to")
    path: PathForm = PathForm.STRAIGHT


class ProfileForm(Entry):
    description: str = Field(min_length=1)
    gestures_per_minute: float = Field(gt=0, le=120)
    lexemes: dict[_Lexeme, LexemeForm] = Field(min_length=1)
    tags: dict[str, TagForm]
    annotated_s: float = Field(default=0.0, ge=0)
    gestures: int = Field(default=0, ge=0)
    lead_s: LeadForm = LeadForm()
    units: UnitForm = UnitForm()
    phases: PhaseForm = PhaseForm()
    rests: RestForm = RestForm()
    head: HeadForm = HeadForm()
    smoothing: SmoothingForm = SmoothingForm()
    follows: dict[str, _Shares] = Field(default_factory=dict)
    hand_follows: dict[str, dict[Hand, _Share]] = Field(default_factory=dict)
    database: tuple[OccurrenceForm, ...] = ()
