"""Documents as others write them, of our own writing, with the names of those that they stand for, and two of ours;
realized whole."""

from pathlib import Path

import numpy as np
import pytest

from understudy.model import Behavior
from understudy.models import load_realizer
from understudy.realization.bml import BmlInput, prepare_schedule
from understudy.realization.motion import RealizedSchedule, realize_prepared
from understudy.realizer.scheduling.deviations import NOTICEABLE_S

DOCUMENTS = Path(__file__).parent / "documents"
EXPECTED = {"lips_unheard", "speech_untimed"}
"""What every speech without a recording is told."""


def realized(name: str) -> RealizedSchedule:
    path = DOCUMENTS / f"{name}.xml"
    prepared = prepare_schedule(None, BmlInput(path.read_bytes(), path), targets=())
    return realize_prepared(load_realizer(), prepared, frame_rate_hz=30, tail_s=1.0)


def behaviors(found: RealizedSchedule) -> dict[str, Behavior]:
    return {each.id: each for each in found.schedule.behaviors}


def codes(found: RealizedSchedule) -> set[str]:
    return {notice.code for notice in found.motion.notices} - EXPECTED


@pytest.mark.parametrize("name", sorted(path.stem for path in DOCUMENTS.glob("*.xml")))
def test_each_is_played_with_finite_motion(name: str) -> None:
    found = realized(name)
    assert found.schedule.behaviors or name == "bmlis__speech_retime"
    assert np.isfinite(found.motion.body.rotations).all()


def test_a_nod_begins_with_a_speech_whose_mark_has_an_absolute_time() -> None:
    found = realized("core__testspeechandnod_synctimed")
    assert behaviors(found)["nod1"].sync.start == pytest.approx(10 - 0.35)
    assert codes(found) == set()


@pytest.mark.parametrize("name", ["f1_h1", "h1_f1"])
def test_a_constraint_is_met_in_either_order(name: str) -> None:
    found = realized(name)
    face, head = behaviors(found)["f1"].sync, behaviors(found)["h1"].sync
    assert (head.stroke, face.start) == (2.6, head.end)
    assert head.end - head.start > 0.4
    assert codes(found) == set()


def test_a_speech_that_nobody_hears_takes_the_time_that_it_is_given() -> None:
    assert codes(realized("bmlis__speech_retime")) == set()


def test_smartbodys_type_is_the_gesture_and_its_prefix_needs_no_declaration() -> None:
    found = realized("smartbody_deictic_me")
    gesture, gaze = behaviors(found)["gesture.1"], behaviors(found)["gaze.2"]
    assert gesture.lexeme == "ME"
    places = {target.name: target.position_m for target in found.schedule.targets}
    assert places[gaze.target or ""] == (1.0, 1.0, 1.0)
    assert codes(found) == {"bml_namespace"}


def test_gretas_first_namespace_is_read() -> None:
    found = behaviors(realized("greta_mindmakers"))
    lexemes = {name: each.lexeme for name, each in found.items()}
    assert lexemes == {"h_1": "TILT_RIGHT", "f_1": "RAISE_MOUTH_CORNERS", "h_1_2": "Beat_Low"}
    assert (found["h_1"].sync.start, found["h_1"].sync.end) == (0.0, 2.1)
    assert codes(realized("greta_mindmakers")) == {"bml_translated"}


def test_gretas_bml_beside_its_fml_is_read_without_a_namespace() -> None:
    found = realized("greta_fml_apml")
    (told,) = (notice.message for notice in found.motion.notices if notice.code == "bml_translated")
    assert told == "Greta's BML is read as BML 1.0; the <fml> beside it is ignored"
    head, gaze = behaviors(found)["head1"], behaviors(found)["gaze1"]
    assert (head.lexeme, head.sync.start, head.sync.end) == ("TILT_LEFT", 0.35, 2.5)
    assert (gaze.target, gaze.direction, gaze.sync.start) == ("listener", "DOWN", 1.0)


def test_names_of_asaps_and_places_are_played_and_what_stands_in_is_told() -> None:
    found = realized("asap_lexemes")
    assert behaviors(found)["h1"].lexeme == "TILT_LEFT"
    told = {each.behavior: each.reason for each in found.motion.decisions if each.action == "replaced"}
    assert told["g1"].endswith("CONDUIT: OPEN_HAND replaces it")
    assert told["g2"].endswith("greta_deictic_self: ME replaces it")
    assert {target.position_m for target in found.schedule.targets} == {(1.0, 1.0, 1.0)}
    assert not [each for each in found.motion.decisions if each.behavior == "g3"]
    assert codes(found) == set()


def test_a_beat_from_1_to_3_is_played_from_1_to_3() -> None:
    found = realized("beat_1_to_3")
    made = found.motion.realized["g1"]
    assert (made.start, made.end) == pytest.approx((1.0, 3.0), abs=0.001)
    assert not [each for each in found.motion.decisions if each.behavior == "g1"]


def test_the_first_gesture_of_kennedys_line_begins_when_our_document_says_and_what_does_not_is_told() -> None:
    """As performed from the recording by this program (`understudy perform jfk.flac`)."""
    found = realized("understudy_jfk")
    written, made = behaviors(found), found.motion.realized
    assert made["gesture1"].start == pytest.approx(written["gesture1"].sync.start, abs=0.001)
    told = {each.behavior for each in found.motion.decisions}
    late = {each for each in made if abs(made[each].start - written[each].sync.start) >= NOTICEABLE_S}
    assert (late - told, "gesture1" in late) == (set(), False)
