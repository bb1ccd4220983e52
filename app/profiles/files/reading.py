"""Reads a profile from its YAML file and checks keys and ranges (docs/profiles.md). All mistakes are reported at once,
with file, line and column.
"""

from collections.abc import Collection, Iterator, Mapping
from pathlib import Path
from typing import Annotated

from pydantic import BeforeValidator, Field

from ...errors import AuthoringError, did_you_mean
from ...model import Hand
from ...yaml_files import Entry, Source
from ..annotation.model import PathForm, Position, Swivel
from ..annotation.spans import DEPTHS, HEIGHTS, RESTS, SIDEWAYS
from ..profile import (
    ANY_TAG,
    FormHabit,
    HeadHabit,
    Lead,
    LexemeHabit,
    Occurrence,
    PhaseHabit,
    Profile,
    RestHabit,
    Smoothing,
    Spread,
    TagHabit,
    UnitHabit,
)

Known = Collection[str] | None
"""The known names; None for any."""

ROUNDING = 0.02
"""The tolerance of sums of probabilities above 1, because they are rounded to three digits."""


def read_profile(path: Path, lexemes: Known = None, tags: Known = None) -> Profile:
    """The profile in a file, named after the file; `lexemes` are the playable lexemes and `tags` the tags that words
    can have (None: any).

    Raises AuthoringError with every mistake and its location.
    """
    return _read(Source(path), path.stem, lexemes, tags)


def read_profile_text(text: str, name: str, lexemes: Known = None, tags: Known = None) -> Profile:
    """The profile in a file's text, under that name; raises as `read_profile` does."""
    return _read(Source(Path(f"{name}.yaml"), text), name, lexemes, tags)


def _read(source: Source, name: str, lexemes: Known, tags: Known) -> Profile:
    form = source.validated(ProfileForm)
    wrong = (*_mistakes(form, lexemes), *_unknown_tags(form, tags))
    mistakes = tuple(source.mistake(place, message) for place, message in wrong)
    if mistakes:
        raise AuthoringError(mistakes)
    return _profile(form, name)


_Place = tuple[str | int, ...]

_Share = Annotated[float, Field(ge=0, le=1)]

_Lexeme = Annotated[str, Field(pattern=r"^[A-Z][A-Z0-9_]*$")]
_Shares = dict[str, _Share]


class TagForm(Entry):
    occurrences: int = Field(ge=0)
    gestures: dict[_Lexeme, _Share]


_Seconds = Annotated[float, Field(ge=0, le=10)]

_Offset = tuple[Annotated[float, Field(ge=-5, le=5)], _Seconds]
_Strokes = tuple[Annotated[float, Field(ge=1, le=20)], Annotated[float, Field(ge=0, le=10)]]


class LexemeForm(Entry):
    share: _Share
    hands: dict[Hand, _Share]
    strokes: _Strokes = (1.0, 0.0)
    offset_s: _Offset = (0.0, 0.1)
    held: _Share = 0.0
    size: float = Field(default=1.0, ge=0.3, le=2.0)


def _several(said: object) -> object:
    """Converts a single share, for units of all sizes, to a list of one."""
    return said if isinstance(said, list) else [said]


class UnitForm(Entry):
    merge_within_s: float = Field(default=1.5, ge=0, le=10)
    joined: Annotated[tuple[_Share, ...], Field(min_length=1, max_length=6), BeforeValidator(_several)] = (1.0,)
    sizes: tuple[_Share, ...] = Field(default=(), max_length=7)


_Durations = tuple[_Seconds, _Seconds]


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


def _mistakes(form: ProfileForm, lexemes: Collection[str] | None) -> Iterator[tuple[_Place, str]]:
    for name in form.lexemes:
        if lexemes is not None and name not in lexemes:
            yield ("lexemes", name), f"the library has no gesture {name!r}{did_you_mean(name, lexemes)}"
    if ANY_TAG not in form.tags:
        yield ("tags",), f"the tag {ANY_TAG!r} is missing: it says what comes with tags that are not here"
    for place, shares in _distributions(form):
        if sum(shares.values()) > 1 + ROUNDING:
            yield place, f"the shares sum to {sum(shares.values()):.3f}; give 1 at most"
    for place in _gestures(form):
        if place[-1] not in form.lexemes:
            hint = did_you_mean(str(place[-1]), form.lexemes)
            yield place, f"{place[-1]} is not among the lexemes of this profile{hint}"
    for distance in ("near", "medium", "far"):
        rest = getattr(form.rests, distance)
        if rest not in RESTS:
            yield ("rests", distance), f"the hands have no rest pose {rest!r}{did_you_mean(rest, RESTS)}"
    yield from _places(form)


def _unknown_tags(form: ProfileForm, known: Known) -> Iterator[tuple[_Place, str]]:
    for tag in form.tags.keys() - {ANY_TAG} if known is not None else ():
        if tag not in (known or ()):
            yield ("tags", tag), f"no function is called {tag!r}{did_you_mean(tag, known or ())} (docs/functions.md)"


def _gestures(form: ProfileForm) -> Iterator[_Place]:
    """The places where lexemes are named outside their own table."""
    for tag, habit in form.tags.items():
        yield from (("tags", tag, "gestures", lexeme) for lexeme in habit.gestures)
    for name, row in form.follows.items():
        yield from (("follows", name, lexeme) for lexeme in row)


def _places(form: ProfileForm) -> Iterator[tuple[_Place, str]]:
    for number, occurrence in enumerate(form.database):
        for key, said in (("from", occurrence.start), ("to", occurrence.end)):
            if _position(said) is None:
                message = f"{said!r}: give a sector across, in height and away, such as 'XC YCC ZMiddle normal'"
                yield ("database", number, key), message


def _distributions(form: ProfileForm) -> Iterator[tuple[_Place, Mapping[str, float]]]:
    for tag, habit in form.tags.items():
        yield ("tags", tag, "gestures"), habit.gestures
    for name, row in form.follows.items():
        yield ("follows", name), row
    for name, hands in form.hand_follows.items():
        yield ("hand_follows", name), {hand.value: share for hand, share in hands.items()}
    for name, lexeme in form.lexemes.items():
        yield ("lexemes", name, "hands"), {hand.value: share for hand, share in lexeme.hands.items()}


def _position(said: str) -> Position | None:
    parts = said.split()
    if len(parts) not in (3, 4) or parts[0] not in SIDEWAYS or parts[1] not in HEIGHTS or parts[2] not in DEPTHS:
        return None
    if len(parts) == 4 and parts[3] not in set(Swivel):
        return None
    return Position(parts[0], parts[1], parts[2], Swivel(parts[3]) if len(parts) == 4 else Swivel.NORMAL)


def _profile(form: ProfileForm, name: str) -> Profile:
    return Profile(
        name=name,
        description=form.description,
        annotated_s=form.annotated_s,
        gestures=form.gestures,
        gestures_per_minute=form.gestures_per_minute,
        tags={tag: TagHabit(each.occurrences, each.gestures) for tag, each in form.tags.items()},
        lexemes={lexeme: _lexeme(each) for lexeme, each in form.lexemes.items()},
        follows=form.follows,
        hand_follows=form.hand_follows,
        units=UnitHabit(form.units.merge_within_s, form.units.joined, form.units.sizes),
        phases=PhaseHabit(
            preparation_s=Spread(*form.phases.preparation_s),
            hold_s=Spread(*form.phases.hold_s),
            retraction_s=Spread(*form.phases.retraction_s),
            after_stroke_s=Spread(*form.phases.after_stroke_s),
        ),
        smoothing=Smoothing(**form.smoothing.model_dump()),
        rests=RestHabit(**form.rests.model_dump()),
        head=HeadHabit(**form.head.model_dump()),
        forms={lexeme: _form(each) for lexeme, each in form.lexemes.items()},
        database=tuple(map(_occurrence, form.database)),
        lead=Lead(form.lead_s.main, form.lead_s.after),
    )


def _lexeme(form: LexemeForm) -> LexemeHabit:
    return LexemeHabit(form.share, form.hands, Spread(*form.strokes), Spread(*form.offset_s), form.held)


def _form(form: LexemeForm) -> FormHabit:
    return FormHabit(form.size)


def _occurrence(form: OccurrenceForm) -> Occurrence:
    start, end = _position(form.start), _position(form.end)
    assert start is not None, "checked before"
    assert end is not None, "checked before"
    return Occurrence(form.lexeme, form.hand, start, end, form.path)
