"""Schedules for the realizer: our own performance and the BML written of it must have the body do the same."""

import json
from dataclasses import replace
from pathlib import Path

import pytest

from understudy.errors import InputError
from understudy.model import Behavior, Channel, Level, Performance
from understudy.performance import Line, Options, Understudy, perform, write_bml
from understudy.realization import (
    BmlInput,
    MotionFormat,
    Realized,
    format_of,
    prepare_schedule,
    realize,
    schedule_of,
    write_motion,
)

AUDIO_FOLDER = Path(__file__).parent / "audio"
AUDIO = (AUDIO_FOLDER / "figure8.flac").read_bytes()
TEXT = (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def performance(understudy: Understudy) -> Performance:
    return perform(understudy, Line(AUDIO, TEXT), Options(character="expansive"))


def in_core_bml(behavior: Behavior) -> Behavior:
    """What BML has no attribute for is not known of a behaviour that was read."""
    amount = None if behavior.kind is Channel.GESTURE else behavior.amount and round(behavior.amount, 3)
    return replace(
        behavior, amount=amount, priority=0.0, first=0, last=0, rule=None, function=None, reason=None, repetitions=None
    )


def test_bml_with_its_recording_is_staged_as_performed(understudy: Understudy, performance: Performance) -> None:
    direct = schedule_of(performance)
    staged = prepare_schedule(understudy.acoustic, BmlInput(write_bml(performance), Path("a.bml"), AUDIO))
    assert staged.notices == ()
    assert staged.schedule.words == direct.words
    assert staged.schedule.visemes == direct.visemes
    assert (staged.schedule.phrases, staged.schedule.emphases_s) == (direct.phrases, direct.emphases_s)
    assert (staged.schedule.character, staged.schedule.agitation) == ("expansive", direct.agitation)
    found = {behavior.id: in_core_bml(behavior) for behavior in staged.schedule.behaviors}
    for behavior in direct.behaviors:
        expected, read = in_core_bml(behavior), found[behavior.id]
        assert read.lexeme == expected.lexeme
        assert read.sync.start == pytest.approx(expected.sync.start, abs=1e-3)
        assert (read.hand, read.target, read.direction, read.amount) == (
            expected.hand,
            expected.target,
            expected.direction,
            expected.amount,
        )


def test_what_the_caller_says_goes_before_what_is_heard(understudy: Understudy, performance: Performance) -> None:
    sheet = BmlInput(write_bml(performance), Path("a.bml"), AUDIO)
    staged = prepare_schedule(understudy.acoustic, sheet, agitation=Level.HIGH, character="reserved")
    assert (staged.schedule.agitation, staged.schedule.character) == (Level.HIGH, "reserved")


def test_without_the_recording_lips_stay_shut_and_it_is_said(understudy: Understudy, performance: Performance) -> None:
    staged = prepare_schedule(understudy.acoustic, BmlInput(write_bml(performance), Path("a.bml")))
    assert staged.schedule.visemes == ()
    assert [notice.code for notice in staged.notices] == ["lips_unheard"]


def test_a_recording_without_words_is_said(understudy: Understudy) -> None:
    bml = b'<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b" characterId="c"/>'
    staged = prepare_schedule(understudy.acoustic, BmlInput(bml, Path("a.bml"), AUDIO))
    assert [notice.code for notice in staged.notices] == ["speech_missing"]


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("a.bvh", MotionFormat.BVH),
        ("A.GLB", MotionFormat.GLB),
        ("a.png", MotionFormat.SHEET),
        ("a.visemes.txt", MotionFormat.VISEMES),
    ],
)
def test_the_name_tells_the_format(name: str, expected: MotionFormat) -> None:
    assert format_of(name) is expected


def test_a_name_of_no_format_is_refused() -> None:
    with pytest.raises(InputError, match=r"\.bvh, \.glb"):
        format_of("motion.fbx")


def test_the_same_line_and_seed_give_the_same_bytes(understudy: Understudy, performance: Performance) -> None:
    schedule, realizer = schedule_of(performance), understudy.realizer
    motions = [realize(realizer, schedule, seed=seed) for seed in (1, 1, 2)]
    files = [write_motion(Realized(schedule, motion), realizer, MotionFormat.BVH) for motion in motions]
    assert files[0] == files[1]
    assert files[0] != files[2]


def test_a_clip_has_the_weights_of_the_visemes_if_something_is_said(
    understudy: Understudy, performance: Performance
) -> None:
    realizer, schedule = understudy.realizer, schedule_of(performance)
    for spoken in (schedule, replace(schedule, visemes=())):
        realized = Realized(spoken, realize(realizer, spoken))
        clip = json.loads(write_motion(realized, realizer, MotionFormat.JSON))
        assert ("visemes" in clip) == bool(spoken.visemes)
        assert max(clip["blendshapes"]["jawOpen"]) > 0.1 or not spoken.visemes
