"""What was done to strips as edits, checked by Understudy's own reader of them."""

import json
from dataclasses import replace
from typing import Any

import pytest

from plugins.blender.schedule.behaviors import Behavior
from plugins.blender.schedule.notes import Done, Note, edits_of, in_words, landed, made_by, note_on, with_done
from understudy.schemas.edits import read_edits

WORDS = [
    {"index": index, "text": text, "start_s": 0.5 * index, "end_s": 0.5 * index + 0.4}
    for index, text in enumerate(["No,", "I", "have", "never", "seen", "those."])
]
MADE = {"id": "gesture1", "kept": True, "function": "f1", "hand": "right", "amount": 0.5, "sync": {"start": 1.2}}
TRACE = {"words": WORDS, "functions": [{"id": "f1", "class": "negation"}], "behaviors": [MADE]}
POINTS_S = {"start": 1.2, "stroke": 1.6, "end": 2.0}
GESTURE = Behavior("gesture1", "gesture", "NEGATION", POINTS_S, 2, 4, "have never seen", families=("negation",))


def noted(*done: Done, before: tuple[Note, ...] = (), sent: tuple[int, ...] = ()) -> tuple[Note, ...]:
    return with_done(before, done, TRACE, sent)


def test_a_moved_strip_keeps_its_gesture_where_it_was_put() -> None:
    (note,) = noted(Done(GESTURE, shift_s=-0.55))
    assert note.edit == {
        "of": {
            "channel": "gesture",
            "at": {"word": 2, "text": "have"},
            "function": "negation",
            "family": "negation",
            "lexeme": "NEGATION",
            "offset_s": 0.2,
        },
        "lexeme": "NEGATION",
        "hand": "right",
        "amount": 0.5,
        "marks": {"stroke": {"at": {"word": 2, "text": "have"}, "edge": "start", "offset_s": 0.05}},
        "lock": True,
    }
    assert note.wanted_s == pytest.approx(1.05)
    assert note.label == "gesture: negation, “have never seen”: moved to 1.05 s"


def test_a_longer_strip_has_its_end_noted_too() -> None:
    (note,) = noted(Done(GESTURE, longer_s=0.4))
    assert note.edit["marks"]["end"] == {"at": {"word": 4, "text": "seen"}, "edge": "end", "offset_s": 0.0}


def test_a_muted_strip_is_left_out() -> None:
    (note,) = noted(Done(GESTURE, omitted=True))
    assert (note.edit["omit"], note.wanted_s, note.label[-5:]) == ("muted", None, "muted")


def test_what_is_done_again_takes_the_place_of_its_note() -> None:
    first = noted(Done(GESTURE, shift_s=-0.55))
    (again,) = noted(Done(GESTURE, omitted=True), before=first)
    assert again.edit == {"of": first[0].edit["of"], "omit": "muted"}
    assert again.number == first[0].number


def test_a_behaviour_that_a_note_made_belongs_to_that_note() -> None:
    """In another take it has another id and other words."""
    first = noted(Done(GESTURE, shift_s=-0.55))
    made = replace(GESTURE, first=1, edit=0)
    (again,) = noted(Done(made, shift_s=1.0), before=first, sent=(first[0].number,))
    assert again.edit["of"] == first[0].edit["of"]
    assert made_by(again, [made], (again.number,)) == made
    assert note_on(made, [again], TRACE, (again.number,)) == again


def test_numbers_are_not_used_twice() -> None:
    head = replace(GESTURE, kind="head", lexeme="SHAKE")
    one, two = noted(Done(GESTURE), Done(head))
    (_, three) = noted(Done(GESTURE), before=(two,))
    assert (one.number, two.number, three.number) == (1, 2, 3)


def test_what_goes_with_no_word_cannot_be_noted() -> None:
    assert noted(Done(replace(GESTURE, first=None), shift_s=1.0)) == ()


def test_understudy_reads_the_edits() -> None:
    head = replace(GESTURE, kind="head", lexeme="SHAKE")
    written = edits_of(noted(Done(GESTURE, shift_s=0.3, longer_s=0.2), Done(head, omitted=True)))
    moved, muted = read_edits(json.dumps(written).encode()).behaviors
    assert moved.lock
    assert moved.marks.stroke is not None
    assert str(muted.omit) == "muted"
    assert edits_of(()) is None


def test_it_survives_being_saved() -> None:
    for note in noted(Done(GESTURE, shift_s=0.3)):
        assert Note.from_json(note.to_json()) == note


def test_what_lands_elsewhere_says_where_and_why() -> None:
    (note,) = noted(Done(GESTURE, shift_s=0.3))
    late = replace(GESTURE, points_s={"start": 1.7, "stroke": 2.1, "end": 2.5}, decisions=("timed: begins at 1.70 s",))
    told = landed(note, late, 0.05)
    assert told == "gesture: negation is fully seen 0.20 s later than its strip was put: timed: begins at 1.70 s"
    assert landed(note, replace(late, points_s={"stroke": 1.9}), 0.05) == ""
    assert landed(note, None, 0.05) == ""


def test_warnings_name_notes_as_the_list_does() -> None:
    notes = [Note(number, {}, f"note {number}") for number in range(11)]
    told: Any = in_words("behaviors[10].marks.stroke: NEGATION cannot have it", notes)
    assert told == "note 10.marks.stroke: NEGATION cannot have it"
