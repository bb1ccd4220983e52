"""SmartBody's dialect, against its section in shared/bml.md; the facts are written out here, not taken from our
tables."""

from dataclasses import replace
from pathlib import Path

import pytest
from lxml import etree

from tests.bml.writing.test_writer import PEAK, ROOT, STROKE, behavior, everything, performance
from tests.support.bml.smartbody_checker import GESTURES as FOUND
from tests.support.bml.smartbody_checker import STYLE, check_act, check_speech_file
from tests.support.words.by_hand import spoken
from understudy.behavior.characters.overlays import Characters
from understudy.behavior.speech import visemes
from understudy.bml.markup.documents import Document, Element, Reference
from understudy.bml.reading.reader import read_bml
from understudy.bml.writing.smartbody import HEADS
from understudy.bml.writing.smartbody_tables import shipped_tables
from understudy.bml.writing.writer import (
    losses,
    to_document,
    write_bml,
    write_speech_file,
)
from understudy.model import Agitation, Behavior, Channel, Hand, Level, Listening, Performance, Target, Word
from understudy.model.formats import BmlForm, DialectName, TimeForm, VisemeNames
from understudy.model.tables import ACTION_UNITS, CORE_LEXEMES

FORM = BmlForm(dialect=DialectName.SMARTBODY, audio_file="line1.wav")
TYPES = {name for name, _hand, _style in FOUND}
STROKED = {"start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end"}


def agitation(level: Level) -> Agitation:
    return Agitation(**{"low": 0.0, "medium": 0.0, "high": 0.0} | {level.value: 1.0})


def block(document: Document) -> list[Element]:
    _, bml = document.root.children
    return list(bml.children)


def written(*behaviors: Behavior) -> list[Element]:
    """What the behaviours become."""
    return [part for part in block(to_document(heard(*behaviors), FORM)) if part.name not in ("speech", "saccade")]


def heard(*behaviors: Behavior) -> Performance:
    """With one who listens."""
    return replace(performance(*behaviors), listeners=(Listening("anna", ()),))


def speech_of(line: Performance, form: BmlForm = FORM) -> etree._Element:
    """The file beside the recording."""
    found = write_speech_file(line, form)
    assert found is not None
    return etree.fromstring(found.content)


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
    assert names <= {"speech", "gesture", "head", "gaze", "face", "saccade", "body"}
    for part in block(to_document(everything(), FORM)):
        assert not {"strokeStart", "strokeEnd", "attackPeak"} & part.attributes.keys()


@pytest.mark.parametrize("timing", TimeForm)
@pytest.mark.parametrize("level", Level)
def test_smartbody_accepts_every_entry_of_the_table(timing: TimeForm, level: Level) -> None:
    line = replace(everything(), listeners=(Listening("anna", ()),))
    line = replace(line, utterance=replace(line.utterance, agitation=agitation(level)))
    form = replace(FORM, timing=timing)
    act, beside = write_bml(line, form), write_speech_file(line, form)
    assert check_act(act, frozenset({"anna"})) == []
    assert beside is not None
    assert beside.name == "line1.bml"
    assert check_speech_file(beside.content, act) == []


@pytest.mark.parametrize(
    ("lexeme", "hand", "level", "found"),
    [
        ("BEAT", Hand.LEFT, Level.HIGH, ("RHYTHM", "LEFT_HAND", None)),
        ("EMPTY", Hand.BOTH, Level.HIGH, ("EMPTY", "BOTH_HANDS", "high")),
        ("EMPTY", Hand.BOTH, Level.LOW, ("EMPTY", "BOTH_HANDS", None)),
        ("ME", Hand.RIGHT, Level.LOW, ("ME", None, None)),
        ("EMPTY", Hand.LEFT, Level.HIGH, ("EMPTY", None, "high")),
        ("CENTER", Hand.BOTH, Level.LOW, ("HERE", "BOTH_HANDS", None)),
        ("CARTWHEEL", Hand.BOTH, Level.HIGH, ("CARTWHEEL", "BOTH_HANDS", None)),
    ],
)
def test_a_gesture_asks_for_no_more_than_the_map_has(
    lexeme: str, hand: Hand, level: Level, found: tuple[str, str | None, str | None]
) -> None:
    line = performance(replace(behavior(Channel.GESTURE, lexeme, STROKE), hand=hand, priority=2.5))
    line = replace(line, utterance=replace(line.utterance, agitation=agitation(level)))
    gesture = block(to_document(line, FORM))[-1].attributes
    assert tuple(gesture.get(name) for name in ("type", "mode", STYLE)) == found
    assert gesture["priority"] == 25
    assert STROKED & gesture.keys() == {"stroke", "relax"}


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
        ("RAISE_RIGHT_MOUTH_CORNER", "right", ["12"]),
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
def test_every_face_has_units_that_brads_has(lexeme: str) -> None:
    """As SmartBody's own scripts define it for ChrBrad and ChrRachel."""
    units = {face.attributes["au"] for face in written(behavior(Channel.FACE, lexeme))}
    assert units
    assert units <= {"1", "2", "4", "5", "6", "7", "10", "12", "25", "26", "45"}


@pytest.mark.parametrize(
    ("lexeme", "amount", "unit", "shown"),
    [("STRETCH_LIPS", 0.4, "12", 0.2), ("PRESS_LIPS", 0.4, "7", 0.2), ("STRETCH_LIPS", None, "12", 0.5)],
)
def test_what_the_face_lacks_is_shown_by_a_share_of_another_unit(
    lexeme: str, amount: float | None, unit: str, shown: float
) -> None:
    (face,) = written(replace(behavior(Channel.FACE, lexeme), amount=amount))
    assert (face.attributes["au"], face.attributes["amount"]) == (unit, shown)


def test_what_is_shown_for_units_that_the_face_lacks_is_told_once() -> None:
    faces = [behavior(Channel.FACE, lexeme) for lexeme in ("STRETCH_LIPS", "PRESS_LIPS", "PRESS_LIPS", "RAISE_BROWS")]
    line = performance(*(replace(face, id=f"face{number}") for number, face in enumerate(faces)))
    (told,) = losses(line, FORM)
    assert (told.code, told.message.partition("written: ")[2]) == ("smartbody_face", "12 for 20, 7 for 24")
    assert losses(line, BmlForm()) == ()


def test_a_gaze_aside_comes_back_for_it_would_stay() -> None:
    aside = replace(behavior(Channel.GAZE, "GLANCE", PEAK), target="listener", direction="UP", amount=0.25)
    away, back = written(aside)
    assert (away.attributes["direction"], away.attributes["angle"], away.attributes["start"]) == (
        "UP",
        15.0,
        PEAK.start,
    )
    assert (back.attributes["target"], back.attributes["start"]) == ("anna", PEAK.relax)
    assert "direction" not in back.attributes
    assert len(written(replace(behavior(Channel.GAZE, "LOOK"), target="listener"))) == 1


def test_a_gaze_at_nobody_is_left_out_and_it_is_told() -> None:
    gaze = replace(behavior(Channel.GAZE, "LOOK"), target="listener")
    alone = performance(gaze, replace(gaze, id="gaze2", target="lamp"))
    assert [part.name for part in block(to_document(alone, FORM))] == ["speech", "saccade"]
    assert [notice.code for notice in losses(alone, FORM)] == ["smartbody_gaze"]
    placed = replace(alone, targets=(Target("lamp", (1.0, 1.0, 1.0)),))
    assert [part.attributes["target"] for part in block(to_document(placed, FORM))[2:]] == ["lamp"]
    assert losses(heard(gaze), FORM) == ()
    assert losses(alone, BmlForm()) == ()


def test_words_stand_between_two_marks_in_time() -> None:
    (text,) = block(to_document(performance(words=spoken("Oh no")), FORM))[0].children
    assert text.content == (
        Element("sync", {"id": "T0", "time": 1.0}),
        "Oh ",
        Element("sync", {"id": "T1", "time": 1.4}),
        Element("sync", {"id": "T2", "time": 1.4}),
        "no ",
        Element("sync", {"id": "T3", "time": 1.8}),
    )


def test_the_speech_names_its_recording() -> None:
    assert block(to_document(performance(), FORM))[0].attributes["ref"] == "line1"
    unnamed = replace(FORM, audio_file=None)
    assert "ref" not in block(to_document(performance(), unnamed))[0].attributes
    assert write_speech_file(performance(), unnamed) is None
    assert [notice.code for notice in losses(performance(), unnamed)] == ["smartbody_unnamed"]


def test_what_breaks_smartbody_is_left_out_of_text_and_name_and_it_is_told() -> None:
    line, form = performance(words=spoken("R&D is < 2")), replace(FORM, audio_file="R&D.wav")
    document = to_document(line, form)
    assert "".join(part for part in next(block(document)[0].children).content if isinstance(part, str)).split() == [
        "RD",
        "is",
        "2",
    ]
    assert check_act(write_bml(line, form)) == []
    found = write_speech_file(line, form)
    assert found is not None
    assert found.name == "RD.bml"
    told = [notice for notice in losses(line, form) if notice.code == "smartbody_text"]
    assert [("RD" in notice.message, "R&D, <" in notice.message) for notice in told] == [(True, False), (False, True)]


def test_times_from_marks_use_marks_directly_inside_the_speech() -> None:
    line = performance(behavior(Channel.GESTURE, "BEAT", STROKE.shifted(1.1)), words=spoken("Oh no"))
    speech, *_, gesture = block(to_document(line, replace(FORM, timing=TimeForm.SYNC)))
    assert gesture.attributes["stroke"] == Reference("speech1", "T2", 0.1)
    assert speech.attributes["type"] == "application/ssml+xml"
    assert [part.attributes["name"] for part in speech.children if part.name == "mark"] == ["T0", "T1", "T2", "T3"]


def test_the_file_beside_the_recording_is_in_its_time() -> None:
    words = spoken("Oh no", start_s=1.5)
    line = replace(performance(words=words), visemes=visemes(words, 3.0)[0])
    led_in = replace(line, utterance=replace(line.utterance, lead_in_s=0.5))
    root = speech_of(led_in)
    assert [sync.get("time") for sync in root.iter("sync")] == ["1.000", "1.400", "1.400", "1.800"]
    assert root.findall("lips")[0].get("start") == "1.000"


def test_lips_move_as_the_visemes_say() -> None:
    line = talking(spoken("Oh no", stressed=[1]))
    assert not [part for part in block(to_document(line, FORM)) if part.name == "lips"]
    lips = speech_of(line).findall("lips")
    assert [each.get("viseme") for each in lips] == ["tRoof", "open", "tRoof", "open"]
    assert {str(name): str(value) for name, value in lips[1].attrib.items()} == {
        "viseme": "open",
        "articulation": "0.600",
        "start": "1.200",
        "ready": "1.250",
        "relax": "1.350",
        "end": "1.400",
    }
    assert lips[3].get("articulation") == "1.000"
    named = speech_of(line, replace(FORM, visemes=VisemeNames.FACEFX)).findall("lips")
    assert [each.get("viseme") for each in named] == ["Told", "Ox", "Told", "Ox"]


def test_a_mouth_that_never_moves_is_said_to_be_shut() -> None:
    """SmartBody refuses a speech without visemes."""
    (lips,) = speech_of(performance()).findall("lips")
    assert lips.get("articulation") == "0.000"


def test_a_listener_looks_at_the_speaker() -> None:
    line = performance(replace(behavior(Channel.GAZE, "LOOK"), target="default"))
    silent = replace(line, utterance=replace(line.utterance, words=()))
    assert block(to_document(silent, FORM))[-1].attributes["target"] == "default"


def test_the_eyes_dart_as_a_talker_does() -> None:
    assert [dict(part.attributes) for part in block(to_document(performance(), FORM)) if part.name == "saccade"] == [
        {"mode": "talk", "start": 0.0}
    ]


def test_every_gesture_of_the_library_has_a_type() -> None:
    """A lexeme that has none would go as it is, and SmartBody plays nothing."""
    tables = shipped_tables()
    entries = Characters.load(ROOT / "lexicon").named("default").entries.values()
    lexemes = {entry.lexeme for entry in entries if entry.channel is Channel.GESTURE}
    assert {lexeme for lexeme in lexemes if tables.gesture(lexeme, None, None).type not in TYPES} == set()
