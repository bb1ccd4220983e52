"""Strips as a director's notes, checked by Understudy's own reader of them."""

import json
from dataclasses import replace
from typing import Any

from plugins.blender.schedule.behaviors import Behavior
from plugins.blender.schedule.notes import notes
from understudy.schemas.direction import read_direction

WORDS = [
    {"index": index, "text": text, "start_s": 0.5 * index, "end_s": 0.5 * index + 0.4}
    for index, text in enumerate(["No,", "I", "have", "never", "seen", "those."])
]


def gesture(stroke_s: float, **changes: Any) -> Behavior:  # noqa: ANN401
    points = {"start": stroke_s - 0.4, "stroke": stroke_s, "end": stroke_s + 0.4}
    families = ("negation", "dismiss")
    behavior = Behavior("gesture1", "gesture", "NEGATION", points, first=2, last=4, families=families)
    return replace(behavior, **changes)


def test_a_moved_gesture_is_a_moment_on_the_word_that_it_came_to() -> None:
    (moment,) = notes([(gesture(1.6), -1.0)], [], WORDS)["moments"]
    assert (moment["first"], moment["last"], moment["stroke"], moment["gesture"]) == (0, 2, 1, ["negation"])


def test_a_selected_one_stays_on_its_word() -> None:
    (moment,) = notes([(gesture(1.6), 0.0)], [], WORDS)["moments"]
    assert (moment["first"], moment["last"], moment["stroke"], moment["importance"]) == (2, 4, 3, 3)


def test_moments_stay_within_the_line() -> None:
    (moment,) = notes([(gesture(1.6), 9.0)], [], WORDS)["moments"]
    assert (moment["first"], moment["last"], moment["stroke"]) == (4, 5, 5)


def test_a_muted_one_is_avoided_over_its_words() -> None:
    assert notes([], [gesture(1.6)], WORDS)["avoid"] == [
        {"first": 2, "last": 4, "what": ["hands"], "why": "negation, muted in Blender"}
    ]


def test_blinks_and_looks_around_are_no_notes() -> None:
    aside = gesture(1.6, families=(), first=None, last=None)
    assert notes([(aside, 0.5)], [aside], WORDS) == {"moments": [], "avoid": []}


def test_understudy_reads_the_notes() -> None:
    written = notes([(gesture(1.6), -1.0)], [gesture(2.6, kind="head", families=("shake",))], WORDS)
    direction = read_direction(json.dumps(written).encode())
    assert direction.moments[0].stroke == 1
    assert "shake" in direction.avoid[0].what
