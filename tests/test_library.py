"""The public interface: its names, their types, what importing it costs, and what each function does with its input.

That the whole of it works is shown by the examples of docs/python.md.
"""

import json
import subprocess
import sys
from dataclasses import fields
from math import ceil
from pathlib import Path
from typing import assert_type

import pytest

import understudy as library
from tests.support.bml.bml_checker import check
from tests.support.bml.bml_records import without_record
from understudy.bml.writing.writer import write_bml
from understudy.model import Line, Performance
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform

AUDIO = Path(__file__).parent / "audio" / "numbers.flac"
TEXT = AUDIO.with_suffix(".txt").read_text(encoding="utf-8")
TIMINGS = AUDIO.with_suffix(".json")


@pytest.fixture(scope="module")
def performance(understudy: Understudy) -> Performance:
    return library.perform(understudy, AUDIO, TEXT, words=TIMINGS, listener=["Ann"], seed=3)


def test_every_public_name_is_there_and_says_what_it_is() -> None:
    assert len(library.__all__) == len(set(library.__all__))
    assert set(library.__all__) <= set(dir(library))
    undocumented = [name for name in library.__all__ if not getattr(library, name).__doc__]
    assert undocumented == []
    with pytest.raises(AttributeError, match="preform"):
        _ = library.preform  # type: ignore[attr-defined]


def test_importing_it_imports_nothing_else() -> None:
    program = (
        "import sys; before = set(sys.modules); import understudy; dir(understudy)\n"
        "print(sorted(name for name in set(sys.modules) - before if 'understudy' in name or 'numpy' in name))\n"
        "from understudy import *\n"
        "print(perform.__module__, Level.__module__, Motion.__module__)"
    )
    run = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True)
    assert run.stdout.splitlines() == [
        "['understudy', 'understudy.lazy_names', 'understudy.version']",
        "understudy.library.performing understudy.model.voice.speech understudy.realizer.body.motion",
    ]


def test_types_are_known_to_a_type_checker(understudy: Understudy, performance: Performance) -> None:
    assert_type(performance, library.Performance)
    assert_type(performance.behaviors[0].kind, library.Channel)
    assert_type(library.find_functions(understudy, "No."), library.Analysis)


def test_a_performance_is_that_of_the_other_doors(understudy: Understudy) -> None:
    audio = AUDIO.read_bytes()
    expected = perform(understudy, Line(audio, TEXT), Options(seed=5, agitation=library.Level.LOW))
    found = library.perform(understudy, audio, TEXT, seed=5, agitation="low")
    assert [getattr(found, each.name) for each in fields(found)] == [
        getattr(expected, each.name) for each in fields(expected)
    ]
    assert library.write_bml(found) == write_bml(expected)


def test_every_form_of_bml_passes_the_checker(performance: Performance) -> None:
    assert check(library.write_bml(performance, timing="sync")) == []
    assert check(library.write_bml(performance, listener="Ann")) == []
    assert b'ref="numbers"' in library.write_bml(performance, dialect="smartbody", audio_name="numbers")
    assert b"<lips" in library.write_speech_file(performance, "numbers")
    assert json.loads(library.write_bml_json(performance))


def test_json_of_each_result_is_that_of_its_command(understudy: Understudy, performance: Performance) -> None:
    assert json.loads(library.write_json(performance))["seed"] == 3
    aligned = library.align(understudy.acoustic, AUDIO, TEXT)
    assert [word["text"] for word in json.loads(library.write_json(aligned))["words"]] == TEXT.split()
    analysis = library.analyze(understudy, AUDIO, TEXT, words=TIMINGS)
    assert "memberships" in json.loads(library.write_json(analysis))
    assert list(json.loads(library.write_json(library.find_functions(understudy, "No.")))) == ["functions"]


def test_words_in_time_come_from_whatever_has_them(understudy: Understudy, performance: Performance) -> None:
    analysis = library.analyze(understudy, AUDIO, TEXT, words=TIMINGS)
    assert library.write_textgrid(analysis) == library.write_textgrid(performance)
    assert library.write_ctm(analysis, "numbers").startswith(b"numbers 1 ")
    with pytest.raises(library.InputError, match="nothing was heard"):
        library.write_ctm(library.find_functions(understudy, "No."))


def test_a_reference_is_made_of_recordings(understudy: Understudy) -> None:
    reference = library.make_reference(understudy, [AUDIO, AUDIO.read_bytes()])
    assert reference.recordings == 2
    heard = [library.analyze(understudy, AUDIO, TEXT, words=TIMINGS, reference=each) for each in (None, reference)]
    assert heard[0].utterance.agitation != heard[1].utterance.agitation


def test_motion_is_named_by_its_format_or_by_a_file(understudy: Understudy, performance: Performance) -> None:
    realized = library.realize(understudy.realizer, performance, fps=30)
    assert realized.motion.frame_rate_hz == 30
    glb = library.write_motion(understudy, realized, "glb")
    assert glb == library.write_motion(understudy, realized, library.MotionFormat.GLB)
    assert glb == library.write_motion(understudy, realized, "some/line.GLB")
    with pytest.raises(library.InputError) as caught:
        library.write_motion(understudy, realized, "line.gltf")
    assert caught.value.code == "motion_format"


def test_motion_is_as_long_as_its_recording_and_files_are_as_asked(
    understudy: Understudy, performance: Performance
) -> None:
    realized = library.realize(understudy.realizer, performance, fps=30)
    frames = len(realized.motion.body.times_s)
    assert frames == ceil((performance.utterance.duration_s or 0.0) * 30)
    assert len(library.realize(understudy.realizer, performance, fps=30, tail_s=1.5).motion.body.times_s) == frames + 45
    bvh = library.write_motion(understudy, realized, "line.bvh", t_pose=True, root_at_origin=True)
    assert f"Frames: {frames + 1}\n".encode() in bvh
    assert b"\tOFFSET 0.0000 0.0000 0.0000\n\tCHANNELS 6" in bvh
    assert b'"name":"face"' in library.write_motion(understudy, realized, "line.glb", keys="sparse")
    pytest.importorskip("pxr", reason="usd-core is not installed")
    assert b"numbers.flac" in library.write_motion(understudy, realized, "line.usda", audio=AUDIO)
    with pytest.raises(library.InputError, match="keys"):
        library.write_motion(understudy, realized, "line.glb", keys="few")  # type: ignore[arg-type]


def test_motion_of_bml_is_as_wished_and_tells_what_is_missing(
    understudy: Understudy, performance: Performance, tmp_path: Path
) -> None:
    bml = tmp_path / "line.bml"
    bml.write_bytes(without_record(library.write_bml(performance)))
    realized = library.realize_bml(understudy, bml, agitation="high", fps=30)
    assert (realized.schedule.agitation, realized.motion.frame_rate_hz) == (library.Level.HIGH, 30)
    assert [notice.code for notice in realized.motion.notices] == ["lips_unheard"]
    bml.write_bytes(b"<bml")
    with pytest.raises(library.WrongBmlError, match=r"line\.bml"):
        library.realize_bml(understudy, bml)


@pytest.mark.parametrize(
    ("options", "field"),
    [
        ({"agitation": "loud"}, "agitation"),
        ({"sead": 1}, "sead"),
        ({"mode": "poetic"}, "mode"),
        ({"seed": "1"}, "seed"),
    ],
)
def test_a_wrong_option_is_named(understudy: Understudy, options: dict[str, object], field: str) -> None:
    with pytest.raises(library.InputError) as caught:
        library.perform(understudy, AUDIO, TEXT, **options)  # type: ignore[arg-type]
    assert (caught.value.code, caught.value.field) == ("value_wrong", field)


def test_other_mistakes_are_told_too(understudy: Understudy, performance: Performance) -> None:
    with pytest.raises(FileNotFoundError):
        library.align(understudy, "nowhere.wav", TEXT)
    with pytest.raises(library.InputError, match="no listener is called 'Bob'; Ann listens"):
        library.write_bml(performance, listener="Bob")
    with pytest.raises(library.InputError, match="Timings"):
        library.perform(understudy, AUDIO, TEXT, words=b"{}")
    with pytest.raises(library.InputError) as caught:
        library.realize(understudy, performance, fps=24)  # type: ignore[arg-type]
    assert (caught.value.code, caught.value.field) == ("value_wrong", "fps")
    with pytest.raises(library.InputError, match="at least one"):
        library.make_reference(understudy, [])


def test_words_are_written_in_the_time_of_the_recording_whatever_the_lead_in(
    understudy: Understudy, performance: Performance
) -> None:
    later = library.perform(understudy, AUDIO, TEXT, words=TIMINGS, lead_in_s=1.5)
    assert library.write_ctm(later) == library.write_ctm(performance)
    assert library.write_textgrid(later) == library.write_textgrid(performance)


def test_directors_notes_are_checked_and_their_conflicts_told(understudy: Understudy) -> None:
    notes = tuple(library.DirectedMoment(0, 1, 1, gesture=(family,)) for family in ("self", "beat"))
    directed = library.perform(understudy, AUDIO, TEXT, direction=library.Direction(notes))
    assert "direction_strokes" in {notice.code for notice in directed.notices}
    wrong = library.Direction(avoid=(library.Avoidance(0, 900, ("smile",)),))
    with pytest.raises(library.InputError) as caught:
        library.perform(understudy, AUDIO, TEXT, direction=wrong)
    assert caught.value.code == "direction_span"
