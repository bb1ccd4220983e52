"""Mixes two profiles (NGS Fig. 2) by linear interpolation of every probability, mean and rate."""

from collections.abc import Iterable, Mapping
from typing import TypeVar

from ..model import Hand
from .profile import (
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

Named = TypeVar("Named", bound=str)


def mix(one: Profile, other: Profile, share: float, *, name: str) -> Profile:
    """The mixture of `other`, with weight `share` in [0, 1], and `one`, with weight 1 - `share`.

    Rests and postures, which cannot be interpolated, are those of the profile with the greater weight.
    """
    nearer = other if share > 0.5 else one
    return Profile(
        name=name,
        description=f"{1 - share:.0%} {one.name}, {share:.0%} {other.name}.",
        annotated_s=one.annotated_s + other.annotated_s,
        gestures=one.gestures + other.gestures,
        gestures_per_minute=_between(one.gestures_per_minute, other.gestures_per_minute, share),
        tags={tag: _tag(one, other, tag, share) for tag in _names(one.tags, other.tags)},
        lexemes=_lexemes(one, other, share),
        follows=_rows((one.follows, other.follows), (_lexeme_shares(one), _lexeme_shares(other)), share),
        hand_follows=_rows((one.hand_follows, other.hand_follows), (_hand_shares(one), _hand_shares(other)), share),
        units=_units(one.units, other.units, share),
        phases=_phases(one.phases, other.phases, share),
        smoothing=_smoothing(one.smoothing, other.smoothing, share),
        rests=_rests(one.rests, other.rests, nearer.rests, share),
        head=_head(one.head, other.head, nearer.head, share),
        forms=_forms(one, other, share),
        database=_database(one.database, other.database, share),
        lead=Lead(
            _between(one.lead.main_s, other.lead.main_s, share), _between(one.lead.after_s, other.lead.after_s, share)
        ),
    )


def _between(one: float, other: float, share: float) -> float:
    return (1 - share) * one + share * other


def _names(*tables: Iterable[Named]) -> list[Named]:
    return sorted(set().union(*tables))


def _table(one: Mapping[Named, float], other: Mapping[Named, float], share: float) -> dict[Named, float]:
    return {name: _between(one.get(name, 0.0), other.get(name, 0.0), share) for name in _names(one, other)}


def _spread(one: Spread, other: Spread, share: float) -> Spread:
    return Spread(_between(one.mean, other.mean, share), _between(one.deviation, other.deviation, share))


def _tag(one: Profile, other: Profile, tag: str, share: float) -> TagHabit:
    """The mixed habit of a tag; a profile without the tag contributes its habit of the tag's class, or of `any`."""
    habits = one.tag(tag), other.tag(tag)
    first, second = (habit or TagHabit(0, {}) for habit in habits)
    return TagHabit(first.occurrences + second.occurrences, _table(first.lexemes, second.lexemes, share))


def _lexemes(one: Profile, other: Profile, share: float) -> dict[str, LexemeHabit]:
    made = {}
    for name in _names(one.lexemes, other.lexemes):
        first, second = one.lexemes.get(name), other.lexemes.get(name)
        known = first or second
        assert known is not None, "it is a lexeme of one of them"
        first, second = first or known, second or known
        made[name] = LexemeHabit(
            share=_between(
                first.share if name in one.lexemes else 0.0, second.share if name in other.lexemes else 0.0, share
            ),
            hands=_table(first.hands, second.hands, share),
            strokes=_spread(first.strokes, second.strokes, share),
            offset_s=_spread(first.offset_s, second.offset_s, share),
            held=_between(first.held, second.held, share),
        )
    return made


def _rows(
    rows: tuple[Mapping[str, Mapping[Named, float]], Mapping[str, Mapping[Named, float]]],
    shares: tuple[Mapping[Named, float], Mapping[Named, float]],
    share: float,
) -> dict[str, Mapping[Named, float]]:
    """The mixed rows; a profile without a row contributes its overall distribution."""
    return {
        first: _table(rows[0].get(first, shares[0]), rows[1].get(first, shares[1]), share) for first in _names(*rows)
    }


def _lexeme_shares(profile: Profile) -> dict[str, float]:
    return {lexeme: habit.share for lexeme, habit in profile.lexemes.items()}


def _hand_shares(profile: Profile) -> dict[Hand, float]:
    habits = profile.lexemes.values()
    return {hand: sum(each.share * each.hands.get(hand, 0.0) for each in habits) for hand in Hand}


def _units(one: UnitHabit, other: UnitHabit, share: float) -> UnitHabit:
    longest = max(len(one.sizes), len(other.sizes))
    known = max(len(one.joined), len(other.joined))
    sizes = (each.sizes + (0.0,) * (longest - len(each.sizes)) for each in (one, other))
    return UnitHabit(
        _between(one.merge_within_s, other.merge_within_s, share),
        tuple(_between(one.joined_after(size), other.joined_after(size), share) for size in range(1, known + 1)),
        tuple(_between(first, second, share) for first, second in zip(*sizes, strict=True)),
    )


def _phases(one: PhaseHabit, other: PhaseHabit, share: float) -> PhaseHabit:
    return PhaseHabit(
        preparation_s=_spread(one.preparation_s, other.preparation_s, share),
        hold_s=_spread(one.hold_s, other.hold_s, share),
        retraction_s=_spread(one.retraction_s, other.retraction_s, share),
        after_stroke_s=_spread(one.after_stroke_s, other.after_stroke_s, share),
    )


def _smoothing(one: Smoothing, other: Smoothing, share: float) -> Smoothing:
    return Smoothing(*(_between(getattr(one, name), getattr(other, name), share) for name in Smoothing.__slots__))


def _rests(one: RestHabit, other: RestHabit, nearer: RestHabit, share: float) -> RestHabit:
    return RestHabit(
        nearer.near,
        nearer.medium,
        nearer.far,
        _between(one.near_s, other.near_s, share),
        _between(one.far_s, other.far_s, share),
    )


def _head(one: HeadHabit, other: HeadHabit, nearer: HeadHabit, share: float) -> HeadHabit:
    contact = nearer.eye_contact
    if one.eye_contact is not None and other.eye_contact is not None:
        contact = _between(one.eye_contact, other.eye_contact, share)
    return HeadHabit(_table(one.per_minute, other.per_minute, share), contact, nearer.postures)


def _forms(one: Profile, other: Profile, share: float) -> dict[str, FormHabit]:
    """The mixed forms; a form that only one profile has is taken unchanged."""
    made = {}
    for name in _names(one.forms, other.forms):
        known = one.forms.get(name) or other.forms[name]
        first, second = one.forms.get(name, known), other.forms.get(name, known)
        made[name] = FormHabit(_between(first.size, second.size, share))
    return made


def _database(one: tuple[Occurrence, ...], other: tuple[Occurrence, ...], share: float) -> tuple[Occurrence, ...]:
    """The occurrences of each lexeme from both profiles in proportion to their weights, at least one of a lexeme that
    only one profile has."""
    made: list[Occurrence] = []
    for name in sorted({each.lexeme for each in (*one, *other)}):
        first = [each for each in one if each.lexeme == name]
        second = [each for each in other if each.lexeme == name]
        made += first[: round((1 - share) * len(first)) or (0 if second else 1)]
        made += second[: round(share * len(second)) or (0 if first else 1)]
    return tuple(made)
