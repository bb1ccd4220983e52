"""Reads a profile from the YAML that people edit: every mistake at once, with file, line and column."""

from collections.abc import Collection, Iterator, Mapping
from pathlib import Path

from ...errors import AuthoringError
from ...suggestions import did_you_mean
from ...yaml_files import Source
from ..annotation.model import Position, Swivel
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
from .schema import LexemeForm, OccurrenceForm, ProfileForm

Known = Collection[str] | None
"""Names that there are; None for any."""

ROUNDING = 0.02
"""By how much probabilities of three digits may sum to more than 1."""


def read_profile(path: Path, lexemes: Known = None, tags: Known = None) -> Profile:
    """The profile in a file, its name that of the file; `lexemes` are those that can be played and `tags` those that
    words can have (None: any).

    Raises AuthoringError with every mistake at its place.
    """
    return _read(Source(path), path.stem, lexemes, tags)


def read_profile_text(text: str, name: str, lexemes: Known = None, tags: Known = None) -> Profile:
    """The profile of that name in a file's text; raises as `read_profile` does."""
    return _read(Source(Path(f"{name}.yaml"), text), name, lexemes, tags)


def _read(source: Source, name: str, lexemes: Known, tags: Known) -> Profile:
    form = source.validated(ProfileForm)
    wrong = (*_mistakes(form, lexemes), *_unknown_tags(form, tags))
    mistakes = tuple(source.mistake(place, message) for place, message in wrong)
    if mistakes:
        raise AuthoringError(mistakes)
    return _profile(form, name)


_Place = tuple[str | int, ...]


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
            yield ("rests", distance), f"hands do not rest {rest!r}{did_you_mean(rest, RESTS)}"
    yield from _places(form)


def _unknown_tags(form: ProfileForm, known: Known) -> Iterator[tuple[_Place, str]]:
    for tag in form.tags.keys() - {ANY_TAG} if known is not None else ():
        if tag not in (known or ()):
            yield ("tags", tag), f"no function is called {tag!r}{did_you_mean(tag, known or ())} (docs/functions.md)"


def _gestures(form: ProfileForm) -> Iterator[_Place]:
    """Where lexemes are named besides their own table."""
    for tag, habit in form.tags.items():
        yield from (("tags", tag, "gestures", lexeme) for lexeme in habit.gestures)
    for name, row in form.follows.items():
        yield from (("follows", name, lexeme) for lexeme in row)


def _places(form: ProfileForm) -> Iterator[tuple[_Place, str]]:
    for number, occurrence in enumerate(form.database):
        for key, said in (("from", occurrence.start), ("to", occurrence.end)):
            if _position(said) is None:
                told = f"{said!r}: give a sector across, in height and away, such as 'XC YCC ZMiddle normal'"
                yield ("database", number, key), told


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
