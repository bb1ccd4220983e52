"""A line without a recording, through every interface: words in time, marks heard, BML of the same shape, motion."""

import json
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest
from fastapi.testclient import TestClient

import understudy as package
from tests.support.bml.bml_checker import check
from understudy.api.application import create_app
from understudy.api.workers.processes import Nursery
from understudy.bml.writing.writer import write_bml
from understudy.cli.main import main
from understudy.errors import InputError
from understudy.model import Channel, Level, Performance, Timings
from understudy.models import Understudy
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.settings import Settings

TEXT = "No, I have *never* seen those, Mr. Smith."
WORDS = TEXT.replace("*", "").split()


@pytest.fixture(scope="module")
def said(understudy: Understudy) -> Performance:
    return package.say(understudy, TEXT)


@pytest.fixture(scope="module")
def client(nursery: Nursery) -> Iterator[TestClient]:
    with TestClient(create_app(Settings(workers=1), nursery)) as client:
        yield client


def test_words_follow_one_another_with_pauses_where_marks_stand(said: Performance) -> None:
    utterance = said.utterance
    assert [word.text for word in utterance.words] == WORDS
    times = [word.interval for word in utterance.words if word.interval]
    assert len(times) == len(WORDS)
    gaps_s = [later.start_s - earlier.end_s for earlier, later in pairwise(times)]
    assert [index for index, gap_s in enumerate(gaps_s) if gap_s > 0.1] == [0, 5]
    assert utterance.duration_s is not None
    assert utterance.duration_s > times[-1].end_s
    assert utterance.level is Level.MEDIUM


def test_what_the_text_marks_is_the_focus(said: Performance) -> None:
    assert [word.text for word in said.utterance.words if word.focus] == ["never"]
    assert said.utterance.words[3].is_emphasised


def test_the_bml_has_the_shape_of_any_other(said: Performance) -> None:
    assert check(write_bml(said)) == []
    assert any(each.kind is Channel.GESTURE and each.kept for each in said.behaviors)
    assert said.visemes


def test_capitals_rates_and_feeling_change_the_performance(understudy: Understudy) -> None:
    plain = package.say(understudy, "You did not see it.")
    loud = package.say(understudy, "You did NOT see it.", agitation="high", affect="angry")
    assert [word.focus for word in loud.utterance.words] == [0, 0, 1, 0, 0]
    assert loud.utterance.level is Level.HIGH
    assert loud.utterance.manners[0].speed > plain.utterance.manners[0].speed


def test_a_synthesizers_times_are_kept(understudy: Understudy) -> None:
    times = [{"text": word, "start_s": index * 0.5, "end_s": index * 0.5 + 0.4} for index, word in enumerate(WORDS)]
    timings = Timings(json.dumps({"words": times}).encode(), "json")
    words = package.say(understudy, TEXT, words=timings).utterance.words
    assert [word.interval.start_s for word in words if word.interval] == [each["start_s"] for each in times]
    assert all(word.phones for word in words)


def test_tags_ask_for_functions_and_gestures(understudy: Understudy) -> None:
    tagged = (
        '<apml><performative type="greet">Well well,</performative> <gesture name="EMPTY">look</gesture> here</apml>'
    )
    performance = package.say(understudy, tagged)
    assert [(each.class_name, each.first, each.last) for each in performance.functions if each.given] == [
        ("greeting", 0, 1)
    ]
    (empty,) = [each for each in performance.behaviors if each.kept and each.lexeme == "EMPTY"]
    assert empty.first == 2


RHEME = (
    '<apml><theme>As for the house,</theme> <rheme>it was <gesture name="NARROW"><emphasis adjectival="small">tiny'
    "</emphasis></gesture> when <emphasis>Peter</emphasis> bought the <emphasis>garden</emphasis>.</rheme></apml>"
)
"""A turn of Gesture Engine's discourse planner, whose gesture is a small measure."""


def test_in_a_rheme_the_stroke_is_repeated_on_further_emphases_each_time_smaller(
    understudy: Understudy, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Gesture Engine §5.1, by the command and by what it wrote."""
    turn, bml = tmp_path / "turn.xml", tmp_path / "turn.bml"
    turn.write_text(RHEME, encoding="utf-8")
    assert main(["say", "--text-file", str(turn), "-o", str(bml)]) == 0
    assert "tags_unread" not in capsys.readouterr().err
    given = [each for each in package.say(understudy, RHEME).functions if each.given]
    assert [(each.class_name, each.subtype, each.first, each.last) for each in given] == [
        ("information", "theme", 0, 3),
        ("information", "rheme", 4, 11),
        ("physical", "small", 6, 6),
    ]
    schedule = package.realize_bml(understudy, bml).schedule
    gestures = [each for each in schedule.behaviors if each.kind is Channel.GESTURE and each.kept]
    theme, narrow = gestures
    assert (narrow.lexeme, theme.sync.end <= narrow.sync.start) == ("NARROW", True)
    plan = plan_gestures(understudy.realizer.library, schedule, seed=0)
    repeats = next(arm.placed.repeats for arm in plan.gestures if arm.behavior == narrow.id)
    assert [each.amplitude for each in repeats] == [0.6, 0.4]


def test_a_gesture_that_does_not_exist_is_told(understudy: Understudy) -> None:
    wrong = "the tag <gesture> in line 1, column 8: there is no behaviour, lexeme or family 'gesture_empti'"
    with pytest.raises(InputError, match=rf"{wrong}; did you mean 'gesture_empty'"):
        package.say(understudy, '<speak><gesture name="gesture_empti">so</gesture></speak>')


def test_a_text_that_would_last_too_long_is_refused(understudy: Understudy) -> None:
    with pytest.raises(InputError) as wrong:
        package.say(understudy, "never " * 1000)
    assert wrong.value.code == "text_too_long"


def test_the_command_writes_bml_and_motion(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    bml, motion, trace = tmp_path / "line.bml", tmp_path / "line.bvh", tmp_path / "line.json"
    command = ["say", "--text", TEXT, "-o", str(bml), "--realize", str(motion), "--trace", str(trace), "--fps", "30"]
    assert main(command) == 0
    assert check(bml.read_bytes()) == []
    told = json.loads(trace.read_text(encoding="utf-8"))
    assert told["focus"][3] == {"word": 3, "share": 1.0}
    assert "stress" not in told
    assert "MOTION" in motion.read_text(encoding="utf-8")
    assert "NEGATION" in capsys.readouterr().err.upper()
    assert main(["say", "--text", "<speak>so", "-o", str(bml)]) == 2
    assert "line 1, column 10" in capsys.readouterr().err


def test_the_service_performs_a_form_without_audio(client: TestClient, said: Performance) -> None:
    answer = client.post("/perform", files={"text": (None, TEXT)})
    assert answer.status_code == 200, answer.text
    assert answer.content == write_bml(said)


def _sharing(functions: list[dict[str, object]]) -> int:
    """How many kept functions share a word with another."""
    spans = [range(int(str(each["first"])), int(str(each["last"])) + 1) for each in functions if each["kept"]]
    return sum(any(set(one) & set(other) for other in spans if other is not one) for one in spans)


def test_the_command_has_functions_compete_by_priority_alone(tmp_path: Path) -> None:
    """VCP §3.3; by default they stand beside each other."""
    trace = tmp_path / "line.json"
    line = [
        "say",
        "--text",
        "I have never seen a *bigger* house.",
        "-o",
        str(tmp_path / "x.bml"),
        "--trace",
        str(trace),
    ]
    shared = []
    for choice in ("priority", "terms"):
        assert main([*line, "--choice", choice, "--quiet"]) == 0
        shared.append(_sharing(json.loads(trace.read_text(encoding="utf-8"))["functions"]))
    assert shared[0] == 0
    assert shared[1] > 0


def test_by_priority_functions_of_any_classes_compete_for_their_words(understudy: Understudy) -> None:
    """VCP §3.3, at the door: none that are kept share a word, and none has lost to a lesser one."""
    text = "No, I have never seen anything like those lights before! Are you really sure, or should we all go back?"
    found = {each.id: each for each in package.say(understudy, text, choice="priority").functions}
    kept = [each for each in found.values() if each.kept]
    words = [word for each in kept for word in range(each.first, each.last + 1)]
    assert len(words) == len(set(words))
    lost = [each for each in found.values() if each.lost_to]
    assert {each.class_name for each in lost} - {each.class_name for each in kept}
    assert all(found[each.lost_to or ""].priority >= each.priority for each in lost)
    by_terms = [each for each in package.say(understudy, text).functions if each.kept]
    assert len(by_terms) > len(kept)
