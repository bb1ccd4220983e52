"""SmartBody's dialect, against shared/bml.md's section on it; the facts are spelt out here and not taken from ours."""

from dataclasses import replace
from pathlib import Path

import pytest

from tests.bml.writing.test_writer import PEAK, ROOT, STROKE, behavior, everything, performance
from tests.support.by_hand import spoken
from understudy.bml.choice.behavior_table.faces import ACTION_UNITS, CORE_LEXEMES
from understudy.bml.choice.characters.characters import Characters
from understudy.bml.choice.speech.visemes import visemes
from understudy.bml.markup.documents import DialectName, Document, Element, Reference, TimeForm
from understudy.bml.reading.reader import read_bml
from understudy.bml.writing.smartbody import GESTURES, HEADS
from understudy.bml.writing.writer import BmlForm, to_document, write_bml
from understudy.model import Agitation, Behavior, Channel, Hand, Performance, Word

FORM = BmlForm(dialect=DialectName.SMARTBODY, audio_name="line1")

TYPES = {
    *("RHYTHM", "QUESTION", "YOU", "ME", "WE", "LEFT", "RIGHT", "CENTER", "HERE", "ASIDE", "CONTRAST", "NEGATION"),
    *("OBLIGATION", "UNCERTAINTY", "INDIFFERENCE", "INCLUSIVITY", "EMPTY", "SURROUND", "STOP", "GREETING"),
    "INTENSIFIER_POSITIVE",
}
STROKED = {"start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end"}


def block(document: Document) -> list[Element]:
    _, bml = document.root.children
    return list(bml.children)


def written(*behaviors: Behavior) -> list[Element]:
    """What the behaviours become."""
    return [
        part for part in block(to_document(performance(*behaviors), FORM)) if part.name not in ("speech", "saccade")
    ]


def talking(words: tuple[Word, ...]) -> Performance:
    return replace(performance(words=words), visemes=visemes(words, 3.0)[0])


def test_an_act_has_its_actor() -> None:
    document = to_document(performance(), FORM)
    participant, bml = document.root.children
    assert (document.root.name, bml.name) == ("act", "bml")
    assert dict(participant.attributes) == {"id": "default", "role": "actor"}


def test_every_entry_of_the_table_comes_back_from_what_is_written() -> None:
    for timing in TimeForm:
        document = to_document(everything(), replace(FORM, timing=timing))
        again, notices = read_bml(write_bml(everything(), replace(FORM, timing=timing)), Path("take.bml"))
        assert again == document
        assert notices == ()


def test_nothing_that_smartbody_does_not_know_is_written() -> None:
    names = {part.name for part in block(to_document(everything(), FORM))}
    assert names <= {"speech", "lips", "gesture", "head", "gaze", "face", "saccade", "body"}
    for part in block(to_document(everything(), FORM)):
        assert not {"strokeStart", "strokeEnd", "attackPeak"} & part.attributes.keys()


def test_gestures_are_of_its_types_and_give_stroke_and_relax_alone() -> None:
    gestures = [part for part in block(to_document(everything(), FORM)) if part.name == "gesture"]
    assert gestures
    for gesture in gestures:
        assert STROKED & gesture.attributes.keys() == {"stroke", "relax"}
    assert set(GESTURES.values()) <= TYPES
    assert not GESTURES.keys() & TYPES


@pytest.mark.parametrize(("level", "style"), [("low", "low"), ("medium", "mid"), ("high", "high")])
def test_a_gesture_has_hand_style_and_priority(level: str, style: str) -> None:
    agitation = Agitation(**{"low": 0.0, "medium": 0.0, "high": 0.0} | {level: 1.0})
    line = performance(replace(behavior(Channel.GESTURE, "BEAT", STROKE), hand=Hand.LEFT, priority=2.5))
    line = replace(line, utterance=replace(line.utterance, agitation=agitation))
    gesture = next(part for part in block(to_document(line, FORM)) if part.name == "gesture")
    found = {name: gesture.attributes[name] for name in ("type", "style", "mode", "priority")}
    assert found == {"type": "RHYTHM", "style": style, "mode": "LEFT_HAND", "priority": 25}


def test_heads_are_nods_shakes_and_tosses() -> None:
    heads = [part for part in block(to_document(everything(), FORM)) if part.name == "head"]
    assert {head.attributes["type"] for head in heads} <= {"NOD", "SHAKE", "TOSS"}
    (nod,) = written(replace(behavior(Channel.HEAD, "NOD", STROKE), amount=0.5, repetitions=2))
    assert (nod.attributes["repeats"], nod.attributes["stroke_start"]) == (2.0, STROKE.stroke_start)
    assert set(HEADS.values()) <= {"NOD", "SHAKE", "TOSS"}


@pytest.mark.parametrize(
    ("lexeme", "side", "units"),
    [
        ("BLINK", "both", ["45"]),
        ("RAISE_BROWS", "both", ["1", "2"]),
        ("RAISE_LEFT_BROW", "left", ["1", "2"]),
        ("LOWER_RIGHT_MOUTH_CORNER", "right", ["15"]),
    ],
)
def test_faces_are_action_units(lexeme: str, side: str, units: list[str]) -> None:
    faces = written(replace(behavior(Channel.FACE, lexeme), amount=0.4))
    assert [face.attributes["au"] for face in faces] == units
    assert {(face.attributes["type"], face.attributes["side"], face.attributes["amount"]) for face in faces} == {
        ("facs", side, 0.4)
    }
    assert len({face.id for face in faces}) == len(faces)


@pytest.mark.parametrize("lexeme", sorted(CORE_LEXEMES | ACTION_UNITS.keys()))
def test_every_face_has_units(lexeme: str) -> None:
    assert written(behavior(Channel.FACE, lexeme))


def test_a_gaze_aside_comes_back_for_it_would_stay() -> None:
    aside = replace(behavior(Channel.GAZE, "GLANCE", PEAK), target="listener", direction="UP", amount=0.25)
    away, back = written(aside)
    assert (away.attributes["direction"], away.attributes["angle"], away.attributes["start"]) == (
        "UP",
        15.0,
        PEAK.start,
    )
    assert (back.attributes["target"], back.attributes["start"]) == ("listener", PEAK.relax)
    assert "direction" not in back.attributes
    assert len(written(replace(behavior(Channel.GAZE, "LOOK"), target="listener"))) == 1


def test_words_stand_between_two_marks_in_time() -> None:
    speech = block(to_document(performance(words=spoken("Oh no")), FORM))[0]
    text, description = speech.children
    assert text.content == (
        Element("sync", {"id": "T0", "time": 1.0}),
        "Oh ",
        Element("sync", {"id": "T1", "time": 1.4}),
        Element("sync", {"id": "T2", "time": 1.4}),
        "no ",
        Element("sync", {"id": "T3", "time": 1.8}),
    )
    assert [dict(part.attributes) for part in description.children] == [{"ref": "line1"}]
    unnamed = to_document(performance(), replace(FORM, audio_name=None))
    assert [part.name for part in block(unnamed)[0].children] == ["text"]


def test_times_from_marks_use_its_marks() -> None:
    line = performance(behavior(Channel.GESTURE, "BEAT", STROKE.shifted(1.1)), words=spoken("Oh no"))
    gesture = block(to_document(line, replace(FORM, timing=TimeForm.SYNC)))[-1]
    assert gesture.attributes["stroke"] == Reference("speech1", "T2", 0.1)


def test_lips_move_as_the_visemes_say() -> None:
    line = talking(spoken("Oh no", stressed=[1]))
    lips = [part for part in block(to_document(line, FORM)) if part.name == "lips"]
    assert [part.attributes["viseme"] for part in lips] == ["DD", "aa", "DD", "aa"]
    assert dict(lips[1].attributes) == {
        "viseme": "aa",
        "articulation": 0.6,
        "start": 1.2,
        "ready": 1.25,
        "relax": 1.35,
        "end": 1.4,
    }
    assert lips[3].attributes["articulation"] == 1.0


def test_the_eyes_dart_as_a_talker_does() -> None:
    assert [dict(part.attributes) for part in block(to_document(performance(), FORM)) if part.name == "saccade"] == [
        {"mode": "talk", "start": 0.0}
    ]


def test_every_gesture_of_the_library_has_a_type() -> None:
    """A lexeme that has none would go as it is, and SmartBody plays nothing."""
    entries = Characters.load(ROOT / "lexicon").named("default").entries.values()
    lexemes = {entry.lexeme for entry in entries if entry.channel is Channel.GESTURE}
    assert {lexeme for lexeme in lexemes if GESTURES.get(lexeme, lexeme) not in TYPES} == set()
