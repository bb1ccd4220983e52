"""The inputs on which a line's hashes depend."""

from dataclasses import replace
from pathlib import Path

import pytest

from understudy.batch.audio import AudioSource
from understudy.batch.manifest.hashes import input_hash, installation_hash, settings_hash
from understudy.batch.work.formats import LineFormat
from understudy.batch.work.jobs import LineJob, MotionForm, OutputTarget
from understudy.model import NEUTRAL, AffectTrack, Direction, Interval, Level, Mode, Target
from understudy.model.edits import Edits, WordEdit, WordMark, WordReference
from understudy.options import Options
from understudy.settings import Settings

JOB = LineJob("a", "No.", AudioSource(Path("a.wav")), Options(), (OutputTarget(LineFormat.BML, "a.bml"),))


@pytest.mark.parametrize(
    "changed",
    [
        replace(JOB, text="Yes."),
        replace(JOB, audio=AudioSource(Path("a.wav"), interval=Interval(0.0, 1.0))),
        replace(JOB, direction=Direction()),
        replace(JOB, options=Options(seed=1)),
        replace(JOB, options=Options(character="expansive")),
        replace(JOB, options=Options(agitation=Level.LOW)),
        replace(JOB, options=Options(affect=AffectTrack((0.0,), (NEUTRAL,)))),
        replace(JOB, options=Options(stillness=0.5)),
        replace(JOB, options=Options().with_edits(Edits(words=(WordEdit(WordReference(0), mark=WordMark.STILL),)))),
        replace(JOB, options=Options(targets=(Target("door", (1.0, 1.0, 1.0)),))),
        replace(JOB, options=Options(listeners=("Ben",), played_by=(("Ben", "default"),))),
        replace(JOB, targets=(OutputTarget(LineFormat.BML, "b.bml"),)),
    ],
)
def test_what_is_a_lines_own(changed: LineJob) -> None:
    assert input_hash(changed, "x") != input_hash(JOB, "x")


def test_the_recording_counts_by_its_content_and_not_by_its_name() -> None:
    assert input_hash(JOB, "y") != input_hash(JOB, "x")
    assert input_hash(replace(JOB, audio=AudioSource(Path("b.wav"))), "x") == input_hash(JOB, "x")


@pytest.mark.parametrize(
    "changed",
    [
        replace(JOB, options=Options(mode=Mode.RANDOM)),
        replace(JOB, options=Options(lead_in_s=0.5)),
        replace(JOB, targets=(*JOB.targets, OutputTarget(LineFormat.CTM, "a.ctm"))),
        replace(JOB, motion=MotionForm(30)),
    ],
)
def test_what_lines_have_in_common(changed: LineJob) -> None:
    assert settings_hash(changed, Settings(), "v") != settings_hash(JOB, Settings(), "v")


def test_version_and_settings_count_and_where_the_service_listens_does_not() -> None:
    usual = settings_hash(JOB, Settings(), "v")
    assert settings_hash(JOB, Settings(), "w") != usual
    assert settings_hash(JOB, Settings(choice="priority"), "v") != usual
    assert settings_hash(JOB, Settings(port=9000), "v") == usual


def test_the_installation_is_the_same_while_nothing_changes() -> None:
    assert installation_hash() == installation_hash()
