"""Something to look and point at, through every interface: named by the words, placed by option, kept in the BML."""

import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from fastapi.testclient import TestClient

import understudy as library
from tests.support.bml.bml_checker import check
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.bml.writing.writer import write_bml
from understudy.cli.main import main
from understudy.model import Channel, FloatArray, Line, Performance, Target
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import BmlInput, RealizedSchedule, prepare_schedule, realize, schedule_of
from understudy.realizer.body.skeleton import forward
from understudy.realizer.geometry.rotations import rotate
from understudy.settings import Settings

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
AUDIO = AUDIO_FOLDER / "figure8.flac"
TEXT = (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8")
SIGNALS = Target("signals", (1.2, 1.2, 1.8))
"""The line ends in "those signals"."""


@pytest.fixture(scope="module")
def performance(understudy: Understudy) -> Performance:
    return perform(understudy, Line(AUDIO.read_bytes(), TEXT), Options(targets=(SIGNALS,)))


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        yield client


def test_the_words_that_name_it_point_and_look_at_it(performance: Performance) -> None:
    kept = [each for each in performance.behaviors if each.kept and each.target == "signals"]
    assert {each.kind for each in kept} == {Channel.GESTURE, Channel.GAZE}
    (gesture,) = (each for each in kept if each.kind is Channel.GESTURE)
    assert (gesture.lexeme, gesture.rule) == ("POINT_LEFT", "show_target")
    word = performance.utterance.words[gesture.last]
    assert word.text.startswith("signals")
    assert word.interval is not None
    assert gesture.sync.stroke_end is not None
    assert word.interval.start_s <= gesture.sync.stroke_end <= word.interval.end_s


def test_without_the_target_nothing_is_at_it(understudy: Understudy, performance: Performance) -> None:
    plain = perform(understudy, Line(AUDIO.read_bytes(), TEXT), Options())
    assert {each.target for each in plain.behaviors} <= {None, "listener"}
    assert "signals" not in write_bml(plain).decode().replace("signals.", "")
    assert [each for each in plain.behaviors if each.kind is Channel.EYES] == [
        each for each in performance.behaviors if each.kind is Channel.EYES
    ]


def test_finger_and_eyes_are_on_it(understudy: Understudy, performance: Performance) -> None:
    realizer = understudy.realizer
    motion = realize(realizer, schedule_of(performance))
    skeleton, body = realizer.performer("default").skeleton, motion.body
    pointing = next(each for each in performance.behaviors if each.target == "signals" and each.hand)
    frame = int(np.argmin(np.abs(body.times_s - (motion.realized[pointing.id].stroke_end or 0.0))))
    places_m, turned = forward(skeleton, body.rotations[frame], body.hips_m[frame])
    way = np.array(SIGNALS.position_m) - places_m[skeleton.index["leftUpperArm"]]
    hand = places_m[skeleton.index["leftHand"]] - places_m[skeleton.index["leftUpperArm"]]
    assert _angle_deg(way, hand) < 15
    look = next(each for each in performance.behaviors if each.target == "signals" and each.kind is Channel.GAZE)
    reached_s = (look.sync.ready or 0.0) + 0.1
    frame = int(np.argmin(np.abs(body.times_s - min(reached_s, look.sync.relax or reached_s))))
    places_m, turned = forward(skeleton, body.rotations[frame], body.hips_m[frame])
    eye = skeleton.index["leftEye"]
    assert _angle_deg(rotate(turned[eye], np.array([0.0, 0.0, 1.0])), np.array(SIGNALS.position_m) - places_m[eye]) < 6


def _angle_deg(one: FloatArray, other: FloatArray) -> float:
    cosine = one @ other / np.linalg.norm(one) / np.linalg.norm(other)
    return float(np.degrees(np.arccos(np.clip(cosine, -1, 1))))


def test_the_bml_says_where_it_is_and_is_read_back(performance: Performance) -> None:
    bml = write_bml(performance)
    assert check(bml) == []
    schedule = prepare_schedule(None, BmlInput(bml, Path("a.bml"))).schedule
    assert schedule.targets == (SIGNALS,)
    ours = {(each.id, each.lexeme, each.target) for each in schedule.behaviors if each.target == "signals"}
    assert ours == {(each.id, each.lexeme, each.target) for each in performance.behaviors if each.target == "signals"}


def test_every_door_takes_targets(
    understudy: Understudy, performance: Performance, client: TestClient, tmp_path: Path
) -> None:
    expected = write_bml(performance)
    out = tmp_path / "out.bml"
    code = main(["perform", str(AUDIO), "--text", TEXT, "--target", "signals=1.2,1.2,1.8", "-o", str(out)])
    assert (code, out.read_bytes()) == (0, expected)
    options = json.dumps({"targets": {"signals": [1.2, 1.2, 1.8]}})
    answer = client.post("/perform", files={"audio": AUDIO.read_bytes()}, data={"text": TEXT, "options": options})
    assert (answer.status_code, answer.content) == (200, expected)
    own = library.perform(understudy, AUDIO, TEXT, targets={"signals": (1.2, 1.2, 1.8)})
    assert library.write_bml(own) == expected
    realized = library.realize_bml(understudy, expected, targets={"signals": (0.0, 1.0, 2.0)})
    assert isinstance(realized, RealizedSchedule)
    assert realized.schedule.targets == (Target("signals", (0.0, 1.0, 2.0)),)


@pytest.mark.parametrize(
    ("options", "code", "said"),
    [
        ('{"targets": {"door": [1, 2]}}', "value_wrong", "targets.door.2"),
        ('{"targets": {"door": [1, 2, "3"]}}', "value_wrong", "targets.door.2"),
        ('{"targets": {"door": [1, 2, NaN]}}', "target_wrong", "z is nan"),
        ('{"targets": {"the door": [1, 2, 3]}}', "target_wrong", "a name has letters"),
        ('{"targets": {"door": [1, 2, 3], "door": [3, 2, 1]}}', "value_wrong", "the key 'door' comes twice"),
        ('{"targets": ["door"]}', "value_wrong", "targets"),
    ],
)
def test_a_wrong_target_is_a_problem_that_names_it(client: TestClient, options: str, code: str, said: str) -> None:
    answer = client.post("/perform", files={"audio": AUDIO.read_bytes()}, data={"text": TEXT, "options": options})
    assert answer.status_code == 422
    assert answer.json()["code"] == code
    assert said in answer.json()["detail"]


def test_several_listeners_have_places_and_are_addressed_in_turn(understudy: Understudy) -> None:
    text = TEXT.replace("not,", "not.")
    line = Line(AUDIO.read_bytes(), text)
    done = perform(understudy, line, Options(listeners=("anna", "ben"), targets=(Target("ben", (-0.9, 1.6, 0.9)),)))
    places = {target.name: target.position_m for target in done.targets}
    assert places["ben"] == (-0.9, 1.6, 0.9)
    looks = [each.target for each in done.behaviors if each.kept and each.kind is Channel.GAZE]
    assert set(looks) == {"anna", "ben"}
    assert all(each.target == "default" for other in done.listeners for each in other.behaviors if each.target)
    schedule = prepare_schedule(None, BmlInput(write_bml(done), Path("a.bml"))).schedule
    assert {target.name for target in schedule.targets} == {"anna", "ben"}
