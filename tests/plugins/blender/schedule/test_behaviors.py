"""Behaviours from BML, its realized times, and the record of its performance."""

import pytest

from plugins.blender.schedule.behaviors import LAYERS, Behavior, behaviors_of
from plugins.blender.schedule.bml_document import KINDS
from tests.plugins.blender.clips import clip
from tests.plugins.blender.documents import BML, REALIZED_S
from understudy.model import Channel

TRACE = {
    "words": [{"index": 0, "text": "No,"}, {"index": 1, "text": "not"}, {"index": 2, "text": "those."}],
    "functions": [{"id": "f1", "class": "negation", "subtype": ""}, {"id": "f2", "class": "deixis", "subtype": "far"}],
    "moments": [{"id": "moment.gesture.1", "families": ["negation", "stop_refuse"]}],
    "behaviors": [
        {
            "id": "gesture1",
            "kind": "gesture",
            "lexeme": "NEGATION",
            "first": 0,
            "last": 1,
            "function": "f1",
            "rule": "show_negation",
            "moment": "moment.gesture.1",
            "kept": True,
        },
        {"id": "head1", "kind": "head", "lexeme": "SHAKE", "kept": True, "reason": "by itself"},
    ],
}
PLAYED = clip(
    events=[
        {"behavior": name, "point": point, "time_s": time_s}
        for name, points in REALIZED_S.items()
        for point, time_s in points.items()
    ],
    decisions=[{"behavior": "gesture1", "action": "held", "reason": "for head1"}],
)


def test_a_performance_tells_words_functions_and_rules() -> None:
    found = {each.id: each for each in behaviors_of(BML, PLAYED, TRACE)}
    gesture = found["gesture1"]
    assert (gesture.words, gesture.why, gesture.families) == (
        "No, not",
        "negation by show_negation",
        ("negation", "stop_refuse"),
    )
    assert gesture.decisions == ("held: for head1",)
    assert (gesture.start_s, gesture.stroke_s, gesture.end_s) == (0.1, 0.6, 1.2)
    assert found["head1"].why == "by itself"


def test_others_bml_tells_what_it_has_and_only_what_was_realized() -> None:
    found = behaviors_of(BML, PLAYED)
    assert [(each.id, each.kind, each.lexeme, each.why) for each in found] == [
        ("posture1", "posture", "posture", ""),
        ("gesture1", "gesture", "NEGATION", ""),
        ("head1", "head", "SHAKE", ""),
    ]


def test_it_survives_being_saved() -> None:
    for behavior in behaviors_of(BML, PLAYED, TRACE):
        assert Behavior.from_json(behavior.to_json()) == behavior


def test_every_kind_has_a_layer() -> None:
    assert set(LAYERS) == {channel.value for channel in Channel} >= set(KINDS.values())


def test_a_glance_is_fully_seen_when_it_is_reached() -> None:
    assert Behavior("gaze1", "gaze", "GLANCE", {"start": 1.0, "ready": 1.2, "end": 2.0}).stroke_s == pytest.approx(1.2)
