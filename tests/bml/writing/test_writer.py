import re
from dataclasses import replace
from pathlib import Path

import pytest
from lxml import etree

from tests.support.bml.bml_checker import check
from tests.support.characters import CHARACTERS
from tests.support.shared_data import SHARED, needs
from tests.support.words.by_hand import FIGURE_8, spoken, utterance
from understudy.behavior.table.behavior_table import STROKED
from understudy.bml.markup.elements import CORE, CORE_EXTENSIONS
from understudy.bml.writing.writer import write_bml
from understudy.model import Behavior, Channel, Hand, Performance, SyncPoints, Word
from understudy.model.formats import BmlForm
from understudy.model.tables import GAZE_LEXEMES

ROOT = Path(__file__).resolve().parents[3]
SCHEMA = SHARED / "data" / "bml" / "bml-1.0.xsd"

STROKE = SyncPoints(start=0.1, ready=0.25, stroke_start=0.3, stroke=0.4, stroke_end=0.5, relax=0.75, end=1.0)
PEAK = SyncPoints(start=0.1, ready=0.25, relax=0.75, end=1.0)


def performance(*behaviors: Behavior, words: tuple[Word, ...] | None = None) -> Performance:
    return Performance(utterance(words or spoken(FIGURE_8)), (), behaviors, "default", 0)


def behavior(kind: Channel, lexeme: str, sync: SyncPoints = PEAK) -> Behavior:
    return Behavior(f"{kind}1", kind, lexeme, sync, 0, 0, 1.0)


def written(one: Behavior) -> etree._Element:
    """The element of one behaviour."""
    root = etree.fromstring(write_bml(performance(one)))
    assert check(etree.tostring(root)) == []
    return root[1]


def attributes(element: etree._Element) -> dict[str, str]:
    return {str(name): str(value) for name, value in element.attrib.items()}


def content(element: etree._Element) -> list[str]:
    return "".join(map(str, element.itertext())).split()


def everything() -> Performance:
    """Every entry of the table, one after the other."""
    entries = CHARACTERS.named("default").entries.values()
    behaviors = [
        replace(
            behavior(entry.channel, entry.lexeme, (STROKE if entry.channel in STROKED else PEAK).shifted(2 * number)),
            id=f"b{number}",
            hand=entry.hand,
            **{name: getattr(entry, name) for name in ("amount", "target", "direction", "repetitions")},
        )
        for number, entry in enumerate(entries)
    ]
    assert {each.kind for each in behaviors} == set(Channel)
    return performance(*behaviors)


def test_every_entry_of_the_table_passes_the_checker() -> None:
    whole = everything()
    assert len(whole.behaviors) > 80
    assert check(write_bml(whole)) == []


def test_kept_behaviours_are_written_and_no_others() -> None:
    lost = replace(behavior(Channel.HEAD, "NOD", STROKE), kept=False, id="head2")
    root = etree.fromstring(write_bml(performance(behavior(Channel.HEAD, "NOD", STROKE), lost)))
    assert [child.get("id") for child in root] == ["speech1", "head1"]


def test_the_block_names_the_character_and_has_no_other_attribute() -> None:
    root = etree.fromstring(write_bml(performance()))
    assert attributes(root) == {"id": "bml1", "characterId": "default"}
    assert root.nsmap == {None: CORE}


def test_the_speech_has_a_mark_before_every_word_and_one_after_the_last() -> None:
    text = etree.fromstring(write_bml(performance(words=spoken("Oh, no."))))[0][0]
    assert [(mark.get("id"), (mark.tail or "").strip()) for mark in text] == [("w0", "Oh,"), ("w1", "no."), ("w2", "")]
    assert content(text) == ["Oh,", "no."]


@pytest.mark.parametrize("word", ["<b>", "R&D", "café", "“no”", "]]>", "😀", 'a"b', "&#233;"])
def test_words_come_back_as_they_were(word: str) -> None:
    document = write_bml(performance(words=spoken(f"{word} yes")))
    assert check(document) == []
    assert content(etree.fromstring(document)[0][0])[0] == word
    assert not re.search(rb"&#\d", document)


def test_a_gesture_has_its_hand_and_all_sync_points() -> None:
    gesture = written(replace(behavior(Channel.GESTURE, "BEAT", STROKE), hand=Hand.LEFT))
    assert gesture.tag == f"{{{CORE}}}gesture"
    assert attributes(gesture) == {
        "id": "gesture1",
        "lexeme": "BEAT",
        "mode": "LEFT_HAND",
        "start": "0.100",
        "ready": "0.250",
        "strokeStart": "0.300",
        "stroke": "0.400",
        "strokeEnd": "0.500",
        "relax": "0.750",
        "end": "1.000",
    }


def test_a_head_movement_has_amount_and_repetition() -> None:
    head = written(replace(behavior(Channel.HEAD, "NOD", STROKE), amount=0.5, repetitions=2))
    assert (head.get("lexeme"), head.get("amount"), head.get("repetition")) == ("NOD", "0.500", "2")


def test_a_face_of_the_core_is_a_lexeme_and_any_other_an_action_unit() -> None:
    brows = written(replace(behavior(Channel.FACE, "RAISE_BROWS"), amount=0.5))
    assert (brows.tag, brows.get("lexeme"), brows.get("attackPeak")) == (
        f"{{{CORE}}}faceLexeme",
        "RAISE_BROWS",
        "0.250",
    )
    blink = written(replace(behavior(Channel.EYES, "BLINK"), amount=1.0))
    assert (blink.tag, blink.get("au"), blink.get("side")) == (f"{{{CORE_EXTENSIONS}}}faceFacs", "45", "BOTH")


@pytest.mark.parametrize("lexeme", sorted(GAZE_LEXEMES))
def test_a_gaze_has_target_and_influence(lexeme: str) -> None:
    gaze = written(replace(behavior(Channel.GAZE, lexeme), target="listener"))
    assert gaze.get("target") == "listener"
    assert gaze.get("influence") == ("EYES" if lexeme == "GLANCE" else "NECK")
    assert gaze.tag.endswith("gazeShift") is (lexeme == "SHIFT")


def test_a_gaze_beside_its_target_has_an_angle() -> None:
    aversion = replace(behavior(Channel.GAZE, "GLANCE"), target="listener", direction="UPRIGHT", amount=0.25)
    gaze = written(aversion)
    assert (gaze.get("offsetAngle"), gaze.get("offsetDirection")) == ("15.000", "UPRIGHT")


def test_a_posture_has_a_stance_and_a_pose() -> None:
    shift = written(behavior(Channel.POSTURE, "LEAN_BACK", SyncPoints(start=0.1, ready=0.75, relax=0.75, end=0.75)))
    assert (shift.tag, shift.get("start"), shift.get("end")) == (f"{{{CORE}}}postureShift", "0.100", "0.750")
    assert [(part.tag.split("}")[1], attributes(part)) for part in shift] == [
        ("stance", {"type": "STANDING"}),
        ("pose", {"part": "WHOLEBODY", "lexeme": "LEAN_BACK"}),
    ]


def test_a_posture_from_which_the_body_comes_back_is_no_shift() -> None:
    lean = written(behavior(Channel.POSTURE, "LEAN_FORWARD", PEAK))
    assert lean.tag == f"{{{CORE}}}posture"
    syncs = {name: value for name, value in attributes(lean).items() if name != "id"}
    assert syncs == {"start": "0.100", "ready": "0.250", "relax": "0.750", "end": "1.000"}


def test_where_nothing_is_said_there_is_no_speech() -> None:
    line = performance(behavior(Channel.HEAD, "NOD", STROKE))
    document = write_bml(replace(line, utterance=replace(line.utterance, words=())))
    assert check(document) == []
    assert [child.get("id") for child in etree.fromstring(document)] == ["head1"]


def test_asap_is_told_what_to_play_where_that_is_asked_for() -> None:
    line = performance(behavior(Channel.HEAD, "NOD", STROKE))
    line = replace(line, utterance=replace(line.utterance, lead_in_s=0.5))
    named = BmlForm(audio_file="line 1.wav")
    assert write_bml(line, named) == write_bml(line)
    root = etree.fromstring(write_bml(line, replace(named, bmlt_audio=True)))
    assert root[1].tag == "{http://hmi.ewi.utwente.nl/bmlt}audiofile"
    assert attributes(root[1]) == {"id": "audio1", "fileName": "line 1.wav", "start": "0.500"}
    assert root.nsmap == {None: CORE}
    root.remove(root[1])
    assert check(etree.tostring(root)) == []


def test_small_times_are_fixed_decimals() -> None:
    face = written(behavior(Channel.FACE, "RAISE_BROWS", SyncPoints(start=0.0, ready=1e-5, relax=0.1, end=1e4)))
    assert (face.get("attackPeak"), face.get("end")) == ("0.000", "10000.000")


@needs(SCHEMA)
def test_the_schema_in_the_wild_agrees_where_it_can() -> None:
    """It lacks gazeShift, faceFacs and descriptions and spells a pose's `part` as `type` (shared/bml.md)."""
    root = etree.fromstring(write_bml(everything()))
    for description in list(root.iter(f"{{{CORE}}}description")):
        description.getparent().remove(description)  # type: ignore[union-attr]
    for element in list(root):
        if element.tag in (f"{{{CORE}}}gazeShift", f"{{{CORE_EXTENSIONS}}}faceFacs"):
            root.remove(element)
    for pose in root.iter(f"{{{CORE}}}pose"):
        pose.set("type", pose.attrib.pop("part"))
    etree.XMLSchema(etree.parse(SCHEMA)).assertValid(root)
