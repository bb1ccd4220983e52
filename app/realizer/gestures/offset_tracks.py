"""Offset tracks of a gesture (NGS §3.4): TRACK lines of its header, read and checked.

TRACK held chest 0 12 0             the body turns with the gesture
TRACK curved UpperArm 0 -10 0       the stroke's path is an arc
TRACK circling LowerArm 0 12 0 2    a progressive: the forearm goes round, twice in a stroke
"""

import re
from collections.abc import Iterable, Iterator
from enum import StrEnum

from .gesture import OffsetTrack, TrackForm
from .specifiers import number, one_of
from .statements import LocatedMistake, Statement, StatementValue

MOST_DEGREES, MOST_PHASE_DEG, FEWEST_TURNS, MOST_TURNS = 45.0, 360.0, 0.25, 6.0


_NUMBER = re.compile(r"[+-]?\d+(\.\d*)?")


class TrackJoint(StrEnum):
    """The joints that can have a track; those of the arm are those of each arm that gestures."""

    SPINE = "spine"
    CHEST = "chest"
    UPPER_CHEST = "upperChest"
    SHOULDER = "Shoulder"
    UPPER_ARM = "UpperArm"
    LOWER_ARM = "LowerArm"
    HAND = "Hand"


TRUNK = frozenset({TrackJoint.SPINE, TrackJoint.CHEST, TrackJoint.UPPER_CHEST})


def offset_tracks(header: Iterable[Statement], wrong: list[LocatedMistake]) -> tuple[OffsetTrack, ...]:
    """The tracks of a gesture; mistakes are appended to `wrong`."""
    said = (statement for statement in header if statement.readable and statement.keyword.text == "TRACK")
    return tuple(track for statement in said for track in _track(statement, wrong))


def track_of(told: str) -> OffsetTrack:
    """The track of a line without its keyword, such as "held chest 0 12 0", as gesture scripts have it. Raises
    ValueError with everything that is wrong."""
    words = [StatementValue(text, 1, 1) for text in told.split()]
    numbers = words[2:]
    if not 3 <= len(numbers) <= 5 or not all(_NUMBER.fullmatch(word.text) for word in numbers):
        raise ValueError(f"{told!r} is no track; give form, joint and three angles, as in 'held chest 0 12 0'")
    wrong: list[LocatedMistake] = []
    found = tuple(_track(Statement(StatementValue("TRACK", 1, 1), tuple(words[:2]), tuple(numbers)), wrong))
    if wrong:
        raise ValueError(f"{told!r}: {'; '.join(mistake.message for mistake in wrong)}")
    return found[0]


def _track(statement: Statement, wrong: list[LocatedMistake]) -> Iterator[OffsetTrack]:
    """The track, if nothing is wrong with it."""
    found: list[LocatedMistake] = []
    form_word, joint_word = statement.words
    form = one_of(TrackForm, form_word, "a track's form", found)
    joint = one_of(TrackJoint, joint_word, "a joint of tracks", found)
    x, y, z = (number(word, -MOST_DEGREES, MOST_DEGREES, found, unit="°") or 0.0 for word in statement.numbers[:3])
    turns, phase_deg = _turns(statement, form, found)
    if not found and not any((x, y, z)):
        found.append(LocatedMistake(statement.numbers[0], "this track turns nothing: all its angles are 0"))
    wrong += found
    if not found and form is not None and joint is not None:
        yield OffsetTrack(form, joint.value, (x, y, z), turns, phase_deg)


def _turns(statement: Statement, form: TrackForm | None, wrong: list[LocatedMistake]) -> tuple[float, float]:
    """How often a track goes round, and where it begins; the others do not."""
    more = statement.numbers[3:]
    if form is not TrackForm.CIRCLING:
        if more and form is not None:
            wrong.append(LocatedMistake(more[0], f"a track that is {form} has three angles; turns are for circling"))
        return 0.0, 0.0
    if not more:
        wrong.append(LocatedMistake(statement.words[0], "a track that is circling says its turns after the angles"))
        return 0.0, 0.0
    phase_deg = number(more[1], -MOST_PHASE_DEG, MOST_PHASE_DEG, wrong, unit="°") if more[1:] else 0.0
    return number(more[0], FEWEST_TURNS, MOST_TURNS, wrong) or 0.0, phase_deg or 0.0
