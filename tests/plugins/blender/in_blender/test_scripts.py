"""A script laid as sound strips, and all of them performed."""

import json
import shutil
from pathlib import Path
from typing import Any

import pytest

from tests.plugins.blender.in_blender.conftest import AUDIO, ROOT
from tests.plugins.blender.in_blender.tracks import tracks

Bpy = Any
LINES = ROOT / "examples" / "previs" / "lines"
WORDS = "Look at that lamp, Ben! It was not here yesterday, and I never touched it."
SCRIPT = """ID,Character,Line
lamp,Ann,"Look at that lamp, Ben! It was not here yesterday, and I never touched it."
nobody,Ben,"No, no. You worry far too much. Nobody comes into this room but us."
gone,Ben,"I have never been recorded."
"""
pytestmark = pytest.mark.usefixtures("sounds")


@pytest.fixture
def script(tmp_path: Path) -> Path:
    for name in ("lamp.flac", "nobody.flac"):
        shutil.copy(LINES / name, tmp_path / name)
    path = tmp_path / "night.csv"
    path.write_text(SCRIPT)
    return path


def test_a_script_is_laid_with_words_and_speakers(blender: Bpy, script: Path, capfd: Any) -> None:
    blender.context.scene.frame_current = 10
    blender.ops.understudy.import_script(filepath=str(script))
    lamp, nobody = sorted(blender.context.scene.sequence_editor.strips_all, key=lambda each: each.frame_final_start)
    assert (lamp.name, lamp["text"], lamp["character"]) == ("lamp", WORDS, "Ann")
    assert lamp.frame_final_start == 10
    assert nobody.frame_final_start == pytest.approx(lamp.frame_final_end + 15, abs=1)
    assert "gone has no recording" in capfd.readouterr().out


def test_subtitles_are_cut_out_of_one_recording(blender: Bpy, tmp_path: Path) -> None:
    shutil.copy(AUDIO, tmp_path / "line.flac")
    (tmp_path / "line.srt").write_text("1\n00:00:00,200 --> 00:00:03,500\nANN: No, I have never seen those.\n\n")
    blender.context.scene.frame_current = 1
    blender.ops.understudy.import_script(filepath=str(tmp_path / "line.srt"))
    (strip,) = blender.context.scene.sequence_editor.strips_all
    assert (strip.frame_final_start, strip.frame_final_duration) == (7, 99)
    assert strip["character"] == "ANN"


def test_all_strips_are_performed_by_those_who_speak_them(blender: Bpy, script: Path, capfd: Any) -> None:
    """Each listens to the other; the second time nothing is left to do."""
    cast = []
    for name in ("Ann", "Ben"):
        blender.ops.understudy.add_mannequin()
        cast.append(blender.context.object)
        cast[-1].name = name
    cast[1].location.x = 1.2
    settings = blender.context.scene.understudy
    settings.source, settings.performer, settings.listener = "STRIP", *cast
    blender.ops.understudy.import_script(filepath=str(script))
    capfd.readouterr()
    blender.ops.understudy.perform_all()
    told = capfd.readouterr().out
    for armature in cast:
        assert [each.name for each in armature.understudy.performances] == ["lamp", "nobody"]
        bodies = tracks(armature)["Understudy body"]
        assert [each.action["understudy_performance"] for each in bodies] == ["lamp", "nobody"]
    spoken = json.loads(cast[0].understudy.performances["lamp"].order)
    assert spoken["options"]["listener"] == ["Ben=default"]
    assert "no character is called" not in told
    listening = [each.name for strips in tracks(cast[1]).values() for each in strips]
    assert "gaze: Ann" in listening
    with pytest.raises(RuntimeError, match="no sound strip that was not performed"):
        blender.ops.understudy.perform_all()


def test_a_strip_of_nobody_is_told_and_the_others_performed(
    blender: Bpy, mannequin: Bpy, script: Path, capfd: Any
) -> None:
    mannequin.name = "Ann"
    blender.ops.understudy.import_script(filepath=str(script))
    blender.ops.understudy.perform_all()
    assert [each.name for each in mannequin.understudy.performances] == ["lamp"]
    assert "no armature is called 'Ben'" in capfd.readouterr().out
