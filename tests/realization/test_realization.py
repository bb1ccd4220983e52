"""Schedules for the realizer: our own performance and the BML written of it must have the body do the same."""

import io
import json
import re
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import soundfile

from tests.support.bml.bml_records import without_record
from understudy.bml.writing.writer import write_bml
from understudy.errors import InputError
from understudy.model import Channel, Level, Line, Mode, Performance, Side, Slots
from understudy.model.formats import BmlForm, TimeForm
from understudy.model.limits import MotionLimits
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.realization import (
    BmlInput,
    MotionFormat,
    PreparedSchedule,
    RealizedSchedule,
    format_of,
    prepare_schedule,
    realize,
    realize_prepared,
    schedule_of,
    write_motion,
)

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
AUDIO = (AUDIO_FOLDER / "figure8.flac").read_bytes()
TEXT = (AUDIO_FOLDER / "figure8.txt").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def performance(understudy: Understudy) -> Performance:
    return perform(understudy, Line(AUDIO, TEXT), Options(character="expansive"))


WAYS = {
    "as it is": Options(),
    "lead-in": Options(lead_in_s=0.8, seed=5),
    "still": Options(character="expansive", stillness=0.3, lead_in_s=1.2345),
    "agitated": Options(character="reserved", agitation=Level.HIGH),
    "by chance": Options(mode=Mode.RANDOM, seed=3),
}
FORMATS = (MotionFormat.BVH, MotionFormat.JSON, MotionFormat.GLB)


@pytest.mark.parametrize("options", WAYS.values(), ids=WAYS)
def test_our_bml_is_realized_as_performed_byte_for_byte(understudy: Understudy, options: Options) -> None:
    performance = perform(understudy, Line(AUDIO, TEXT), options)
    direct = realize_prepared(understudy.realizer, PreparedSchedule.of(performance), frame_rate_hz=30)
    for audio in (None, AUDIO):
        staged = prepare_schedule(understudy.acoustic, BmlInput(write_bml(performance), Path("a.bml"), audio))
        assert staged == PreparedSchedule.of(performance)
    read = realize_prepared(understudy.realizer, staged, frame_rate_hz=30)
    for form in FORMATS:
        files = [write_motion(realized, understudy.realizer, form) for realized in (direct, read)]
        assert files[0] == files[1]


def test_times_by_marks_are_read_as_performed_too(performance: Performance) -> None:
    bml = write_bml(performance, BmlForm(timing=TimeForm.SYNC))
    assert prepare_schedule(None, BmlInput(bml, Path("a.bml"))) == PreparedSchedule.of(performance)


def test_slots_are_read_as_they_were_written(performance: Performance) -> None:
    slots = Slots(height_m=0.95, count=2, side=Side.LEFT, elevation_deg=-30.0, referent="wall_2")
    filled = replace(
        performance,
        behaviors=tuple(
            replace(each, slots=slots) if each.kind is Channel.GESTURE else each for each in performance.behaviors
        ),
    )
    staged = prepare_schedule(None, BmlInput(write_bml(filled), Path("a.bml")))
    assert staged == PreparedSchedule.of(filled)
    assert slots in {each.slots for each in staged.schedule.behaviors}


def test_another_recording_of_the_words_is_heard_anew(understudy: Understudy, performance: Performance) -> None:
    samples, rate = soundfile.read(io.BytesIO(AUDIO), dtype="int16")
    later = io.BytesIO()
    soundfile.write(later, np.concatenate([np.zeros(rate // 2, np.int16), samples]), rate, format="FLAC")
    bml = write_bml(performance, BmlForm(timing=TimeForm.SYNC))
    staged = prepare_schedule(understudy.acoustic, BmlInput(bml, Path("a.bml"), later.getvalue())).schedule
    direct = schedule_of(performance)
    assert staged.duration_s == pytest.approx(direct.duration_s + 0.5, abs=1e-3)
    read = {behavior.id: behavior for behavior in staged.behaviors}
    for before in direct.behaviors:
        if before.kind is Channel.GESTURE:
            after = read[before.id]
            assert after.priority == before.priority
            assert after.sync.stroke == pytest.approx((before.sync.stroke or 0.0) + 0.5, abs=0.1)


def test_words_that_are_others_than_those_of_the_record_are_not_known(performance: Performance) -> None:
    bml = write_bml(performance).replace(b"guess", b"really guess")
    staged = prepare_schedule(None, BmlInput(bml, Path("a.bml")))
    assert staged.schedule.words == ()
    assert "lips_unheard" in {notice.code for notice in staged.notices}


def test_a_body_that_is_made_still_twice_is_stiller(understudy: Understudy) -> None:
    performance = perform(understudy, Line(AUDIO, TEXT), Options(stillness=0.5))
    sheet = BmlInput(write_bml(performance), Path("a.bml"))
    assert prepare_schedule(None, sheet, stillness=0.5).schedule.stillness == pytest.approx(0.75)


def test_a_lexeme_that_nobody_knows_is_told_with_the_nearest(understudy: Understudy, performance: Performance) -> None:
    bml = re.sub(rb'(<gesture id="gesture1" lexeme=)"[A-Z_]+"', rb'\1"NEGATON"', write_bml(performance))
    realized = realize_prepared(understudy.realizer, prepare_schedule(None, BmlInput(bml, Path("a.bml"))))
    (told,) = (notice for notice in realized.motion.notices if notice.code == "gesture_unknown")
    assert "gesture1 is played as a BEAT: no gesture is called 'NEGATON'; did you mean 'NEGATION'?" in told.message


def test_a_gesture_that_is_moved_onto_another_says_which_and_what_would_help(
    understudy: Understudy, performance: Performance
) -> None:
    schedule = schedule_of(performance)
    first = next(each for each in schedule.behaviors if each.kind is Channel.GESTURE)
    second = replace(first, id="second", sync=first.sync.shifted(0.6))
    behaviors = (first, second)
    realized = realize_prepared(understudy.realizer, PreparedSchedule(replace(schedule, behaviors=behaviors), ()))
    (told,) = realized.motion.notices
    assert told.code == "gesture_not_played"
    assert f"Both are played if {second.id} comes" in told.message


def test_what_the_caller_says_goes_before_what_is_heard(understudy: Understudy, performance: Performance) -> None:
    sheet = BmlInput(write_bml(performance), Path("a.bml"), AUDIO)
    staged = prepare_schedule(understudy.acoustic, sheet, agitation=Level.HIGH, character="reserved")
    assert (staged.schedule.agitation, staged.schedule.character) == (Level.HIGH, "reserved")


def test_without_record_and_recording_lips_stay_shut_and_it_is_said(performance: Performance) -> None:
    staged = prepare_schedule(None, BmlInput(without_record(write_bml(performance)), Path("a.bml")))
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
        format_of("motion.mp4")


def test_the_same_line_and_seed_give_the_same_bytes(understudy: Understudy, performance: Performance) -> None:
    schedule, realizer = schedule_of(performance), understudy.realizer
    motions = [realize(realizer, schedule, seed=seed) for seed in (1, 1, 2)]
    files = [write_motion(RealizedSchedule(schedule, motion), realizer, MotionFormat.BVH) for motion in motions]
    assert files[0] == files[1]
    assert files[0] != files[2]


def test_a_clip_has_the_weights_of_the_visemes_if_something_is_said(
    understudy: Understudy, performance: Performance
) -> None:
    realizer, schedule = understudy.realizer, schedule_of(performance)
    for spoken in (schedule, replace(schedule, visemes=())):
        realized = RealizedSchedule(spoken, realize(realizer, spoken))
        clip = json.loads(write_motion(realized, realizer, MotionFormat.JSON))
        assert ("visemes" in clip) == bool(spoken.visemes)
        assert max(clip["blendshapes"]["jawOpen"]) > 0.1 or not spoken.visemes


def test_behaviors_are_counted_before_their_times_are_sought() -> None:
    """Waits among them, of which nothing is left in the schedule."""
    waits = "".join(f'<wait id="w{n}" start="0" end="1"/>' for n in range(3))
    bml = f'<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b" characterId="c">{waits}</bml>'.encode()
    assert not prepare_schedule(
        None, BmlInput(bml, Path("a.bml"), limits=MotionLimits(3, 10, 600, 1))
    ).schedule.behaviors
    with pytest.raises(InputError, match="3 behaviours; at most 2"):
        prepare_schedule(None, BmlInput(bml, Path("a.bml"), limits=MotionLimits(2, 10, 600, 1)))
