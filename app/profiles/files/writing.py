"""Writes a profile as readable YAML: numbers of three digits, one habit per line.

Probabilities below `SHOWN` are not written. In the tables of successors the remaining probability of a row is shared
among the lexemes it does not name.
"""

from collections.abc import Iterator, Mapping, Sequence
from typing import TypeVar

from ...model import Hand
from ..profile import (
    FormHabit,
    HeadHabit,
    Occurrence,
    PhaseHabit,
    Profile,
    RestHabit,
    Smoothing,
    Spread,
    TagHabit,
    UnitHabit,
)

SHOWN = 0.002
Named = TypeVar("Named", bound=str)

HEADER = """\
# A gesture profile: how one speaker gestures (docs/profiles.md). Learnt by `understudy profiles learn`; edit it freely.
# Shares and probabilities are in [0, 1], times in seconds, pairs are [mean, deviation].
"""


def profile_yaml(profile: Profile) -> bytes:
    """The profile as the text of its YAML file."""
    lines = [
        f"description: {_text(profile.description)}",
        f"annotated_s: {_number(profile.annotated_s)}",
        f"gestures: {profile.gestures}",
        f"gestures_per_minute: {_number(profile.gestures_per_minute)}",
        "# How much earlier than its word says a main stroke comes, and a stroke after it.",
        f"lead_s: {_flow({'main': profile.lead.main_s, 'after': profile.lead.after_s})}",
        "# Strokes nearer than this are joined so often to a unit of 1, 2, ... gestures; shares of units by size.",
        f"units: {_flow({name: getattr(profile.units, name) for name in UnitHabit.__slots__})}",
        f"phases: {_flow({name: getattr(profile.phases, name) for name in PhaseHabit.__slots__})}",
        "# Where the hands rest, by how soon the next unit begins.",
        f"rests: {_flow({name: getattr(profile.rests, name) for name in RestHabit.__slots__})}",
        f"head: {_flow(_head(profile.head))}",
        "# The strength of each prior, in observations, as chosen by held-out likelihood (nats a tag).",
        f"smoothing: {_flow({name: getattr(profile.smoothing, name) for name in Smoothing.__slots__})}",
        "",
        "# How each gesture is made: its share of all, which hand, how many strokes, how long after its word it ends.",
        "lexemes:",
        *(f"  {name}: {_flow(_lexeme_line(profile, name))}" for name in profile.lexemes),
        "",
        "# P(gesture | tag): `class.subtype`, then `class` for the rest of a class, then `any` for all others.",
        "tags:",
        *(f"  {tag}: {_flow(_tag_line(habit))}" for tag, habit in profile.tags.items()),
        "",
        "# P(gesture | the gesture before it).",
        *_rows("follows", profile.follows),
        *_rows("hand_follows", profile.hand_follows),
        "",
        "# The GestureDB: where strokes started and ended, in sectors of gesture space.",
        *(["database:"] if profile.database else []),
        *(f"  - {_flow(_occurrence_line(each))}" for each in profile.database),
    ]
    return (HEADER + "\n".join(lines) + "\n").encode()


def _rows(name: str, rows: Mapping[str, Mapping[Named, float]]) -> Iterator[str]:
    if rows:
        yield f"{name}:"
    for first, row in rows.items():
        yield f"  {first}: {_flow({str(second): share for second, share in row.items() if share >= SHOWN})}"


def _head(head: HeadHabit) -> dict[str, object]:
    said: dict[str, object] = {"per_minute": head.per_minute}
    if head.eye_contact is not None:
        said["eye_contact"] = head.eye_contact
    return {**said, "postures": head.postures}


def _lexeme_line(profile: Profile, name: str) -> dict[str, object]:
    habit, form, usual = profile.lexemes[name], profile.forms.get(name, FormHabit()), FormHabit()
    hands = {hand.value: habit.hands.get(hand, 0.0) for hand in Hand}
    made = {"share": habit.share, "hands": hands, "strokes": habit.strokes, "offset_s": habit.offset_s}
    own = {key: getattr(form, key) for key in FormHabit.__slots__ if getattr(form, key) != getattr(usual, key)}
    return {**made, **({"held": habit.held} if habit.held else {}), **own}


def _tag_line(habit: TagHabit) -> dict[str, object]:
    shown = sorted(habit.lexemes.items(), key=lambda item: (-round(item[1], 3), item[0]))
    return {
        "occurrences": habit.occurrences,
        "gestures": {lexeme: share for lexeme, share in shown if share >= SHOWN},
    }


def _occurrence_line(occurrence: Occurrence) -> dict[str, object]:
    places = {"from": str(occurrence.start), "to": str(occurrence.end)}
    return {"lexeme": occurrence.lexeme, "hand": occurrence.hand.value, **places, "path": occurrence.path.value}


def _flow(value: object) -> str:
    """A value on one line of YAML."""
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{key}: {_flow(each)}" for key, each in value.items()) + "}"
    if isinstance(value, Spread):
        return _flow((value.mean, value.deviation))
    if isinstance(value, float | int):
        return _number(value)
    if isinstance(value, Sequence) and not isinstance(value, str):
        return "[" + ", ".join(map(_flow, value)) + "]"
    return str(value)


def _number(value: float) -> str:
    return f"{round(value, 3) + 0.0:g}" if abs(value) < 1000 else f"{value:.1f}"


def _text(value: str) -> str:
    return '"' + value.replace("\\", "\\\\").replace('"', '\\"').replace("\n", " ") + '"'
