"""`understudy realize` and `perform --realize`: files in the format of their names, written completely or not at
all."""

import json
import sys
from pathlib import Path

import pytest

from understudy.cli.main import main

Captured = pytest.CaptureFixture[bytes]

AUDIO_FOLDER = Path(__file__).parents[1] / "audio"
AUDIO = str(AUDIO_FOLDER / "figure8.flac")
TEXT_FILE = str(AUDIO_FOLDER / "figure8.txt")
BEAT = """<bml xmlns="http://www.bml-initiative.org/bml/bml-1.0" id="b" characterId="default">
<gesture id="g" lexeme="BEAT" mode="RIGHT_HAND" start="0.2" stroke="1.0" relax="1.4"/>
<head id="h" lexeme="NOD" stroke="1.0"/></bml>"""


def _run(capture: Captured, *argv: str) -> tuple[int, str]:
    """Exit code and standard error."""
    capture.readouterr()
    code = main(argv)
    return code, capture.readouterr()[1].decode()


@pytest.fixture
def beat(tmp_path: Path) -> Path:
    path = tmp_path / "beat.bml"
    path.write_text(BEAT)
    return path


def test_mpeg4_parameters_are_read_back_as_motion(capfdbinary: Captured, tmp_path: Path, beat: Path) -> None:
    """Body and face come back to the same files, within a unit; the body goes to a picture and an avatar's clip too."""
    bap, fap, again = tmp_path / "a.bap", tmp_path / "a.fap", tmp_path / "b.bap"
    written = ("-o", str(bap), "-o", str(fap), "--fps", "30")
    assert _run(capfdbinary, "realize", str(beat), *written)[0] == 0
    outputs = [part for name in ("b.bap", "b.bvh", "b.glb") for part in ("-o", str(tmp_path / name))]
    code, err = _run(capfdbinary, "realize", str(bap), "--fap", str(fap), *outputs)
    assert (code, err) == (0, "")
    assert (tmp_path / "b.bvh").read_bytes().startswith(b"HIERARCHY")
    lines = zip(bap.read_text().splitlines()[2::2], again.read_text().splitlines()[2::2], strict=True)
    values = [(list(map(int, one.split())), list(map(int, other.split()))) for one, other in lines]
    assert max(abs(one - other) for row in values for one, other in zip(*row, strict=True)) <= 1
    bap.write_bytes(bap.read_bytes()[:5000])
    code, err = _run(capfdbinary, "realize", str(bap), "-o", str(tmp_path / "c.bvh"))
    assert (code, "the file ends" in err, (tmp_path / "c.bvh").exists()) == (2, True, False)


def test_one_schedule_goes_to_every_format_named(capfdbinary: Captured, tmp_path: Path, beat: Path) -> None:
    names = [tmp_path / f"a{ending}" for ending in (".bvh", ".glb", ".vrma", ".json", ".csv", ".visemes.txt")]
    outputs = [part for name in names for part in ("-o", str(name))]
    code, _err = _run(capfdbinary, "realize", str(beat), *outputs, "--fps", "30")
    assert code == 0
    assert names[0].read_bytes().startswith(b"HIERARCHY")
    assert names[1].read_bytes()[:4] == names[2].read_bytes()[:4] == b"glTF"
    assert json.loads(names[3].read_bytes())["frame_rate_hz"] == 30
    assert b"0.0333333" in names[0].read_bytes()


def test_joints_go_by_the_names_of_the_skeleton_asked_for(capfdbinary: Captured, tmp_path: Path, beat: Path) -> None:
    output = tmp_path / "a.bvh"
    assert _run(capfdbinary, "realize", str(beat), "-o", str(output), "--skeleton", "unreal")[0] == 0
    assert b"JOINT upperarm_l" in output.read_bytes()


def test_files_are_written_as_asked(capfdbinary: Captured, tmp_path: Path, beat: Path) -> None:
    bvh, glb, plain = (tmp_path / name for name in ("a.bvh", "a.glb", "b.bvh"))
    argv = ("realize", str(beat), "-o", str(bvh), "-o", str(glb), "--fps", "30", "--tail", "1")
    assert _run(capfdbinary, *argv, "--t-pose", "--root-at-origin", "--keys", "sparse")[0] == 0
    assert _run(capfdbinary, "realize", str(beat), "-o", str(plain), "--fps", "30")[0] == 0
    frames = [int(name.read_text().partition("Frames: ")[2].split()[0]) for name in (bvh, plain)]
    assert frames[0] == frames[1] + 30 + 1
    assert b'"id":"g"' in glb.read_bytes()
    code, err = _run(capfdbinary, *argv[:-1], "11")
    assert (code, err.count("\n")) == (2, 1)
    assert "give 0 to 10" in err


def test_physics_is_asked_for_on_the_command_line_or_in_the_settings(
    capfdbinary: Captured, tmp_path: Path, beat: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The setting counts where the command line says nothing; the motion has as many frames."""

    def bvh(*argv: str) -> str:
        path = tmp_path / "a.bvh"
        assert _run(capfdbinary, "realize", str(beat), "-o", str(path), "--fps", "30", *argv)[0] == 0
        return path.read_text()

    plain, moved = bvh(), bvh("--physics")
    assert plain != moved
    assert plain.partition("MOTION")[2].splitlines()[1] == moved.partition("MOTION")[2].splitlines()[1]
    monkeypatch.setenv("UNDERSTUDY_PHYSICS", "1")
    assert (bvh(), bvh("--no-physics")) == (moved, plain)


def test_physics_without_mujoco_names_the_extra(
    capfdbinary: Captured, tmp_path: Path, beat: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, "mujoco", None)
    code, err = _run(capfdbinary, "realize", str(beat), "-o", str(tmp_path / "a.bvh"), "--physics")
    assert (code, err.count("\n")) == (2, 1)
    assert ".[physics]" in err


def test_an_avatar_of_ones_own_wears_the_motion(capfdbinary: Captured, tmp_path: Path, beat: Path) -> None:
    """The mannequin's own file serves as the avatar: its joints go by VRM's names."""
    mannequin, worn = tmp_path / "mannequin.glb", tmp_path / "worn.glb"
    assert _run(capfdbinary, "realize", str(beat), "-o", str(mannequin), "--fps", "30")[0] == 0
    argv = ("realize", str(beat), "-o", str(worn), "--avatar", str(mannequin), "--fps", "30")
    assert _run(capfdbinary, *argv)[0] == 0
    assert worn.read_bytes()[:4] == b"glTF"
    beat.with_suffix(".glb").write_bytes(b"no avatar")
    code, err = _run(capfdbinary, *argv[:-3], str(beat.with_suffix(".glb")))
    assert (code, err.count("\n")) == (2, 1)


def test_a_performance_writes_its_motion_too(capfdbinary: Captured, tmp_path: Path) -> None:
    bml, bvh = tmp_path / "a.bml", tmp_path / "a.bvh"
    argv = ("perform", AUDIO, "--text-file", TEXT_FILE, "-o", str(bml), "--realize", str(bvh), "--fps", "30")
    assert _run(capfdbinary, *argv)[0] == 0
    assert bml.read_bytes().startswith(b"<?xml")
    assert bvh.read_bytes().startswith(b"HIERARCHY")


@pytest.mark.parametrize(
    ("output", "told"),
    [("a.max", "motion is written as .bvh"), ("missing/a.bvh", "there is no folder")],
)
def test_a_wrong_output_is_told_in_one_line_before_the_work(
    capfdbinary: Captured, tmp_path: Path, beat: Path, output: str, told: str
) -> None:
    code, err = _run(capfdbinary, "realize", str(beat), "-o", str(tmp_path / output))
    assert code == 2
    assert told in err
    assert err.count("\n") == 1
    assert sorted(path.name for path in tmp_path.iterdir()) == ["beat.bml"]


@pytest.mark.parametrize(
    ("bml", "told"),
    [("<bml", "line 1"), (BEAT.replace("BEAT", "SERENADE"), "SERENADE"), (BEAT.replace("NOD", "SPIN"), "SPIN")],
    ids=["no XML", "a gesture we have not", "a head movement we have not"],
)
def test_what_cannot_be_played_is_told(capfdbinary: Captured, tmp_path: Path, beat: Path, bml: str, told: str) -> None:
    beat.write_text(bml)
    _code, err = _run(capfdbinary, "realize", str(beat), "-o", str(tmp_path / "a.bvh"))
    assert told in err


def test_an_unknown_skeleton_is_told_with_those_there_are(capfdbinary: Captured, tmp_path: Path, beat: Path) -> None:
    code, err = _run(capfdbinary, "realize", str(beat), "-o", str(tmp_path / "a.bvh"), "--skeleton", "biped")
    assert code == 2
    assert "mixamo" in err
    assert not (tmp_path / "a.bvh").exists()


def test_a_scene_names_the_recording_from_where_it_lies(capfdbinary: Captured, tmp_path: Path, beat: Path) -> None:
    pytest.importorskip("pxr", reason="usd-core is not installed: pip install 'understudy[usd]'")
    (tmp_path / "scenes").mkdir()
    (tmp_path / "line.flac").write_bytes(Path(AUDIO).read_bytes())
    output = tmp_path / "scenes" / "a.usda"
    code, _err = _run(capfdbinary, "realize", str(beat), "--audio", str(tmp_path / "line.flac"), "-o", str(output))
    assert code == 0
    assert b"@../line.flac@" in output.read_bytes()


def test_a_performance_is_written_as_a_timeline_instead_of_bml(capfdbinary: Captured, tmp_path: Path) -> None:
    names = [tmp_path / name for name in ("a.TextGrid", "a.eaf", "a.events.csv")]
    realized = [part for name in names for part in ("--realize", str(name))]
    output = tmp_path / "a.otio"
    code, _err = _run(capfdbinary, "perform", AUDIO, "--text-file", TEXT_FILE, "-o", str(output), *realized)
    assert code == 0
    timeline = json.loads(output.read_bytes())
    assert timeline["OTIO_SCHEMA"] == "Timeline.1"
    functions = next(track for track in timeline["tracks"]["children"] if track["name"] == "functions")
    assert any(child["OTIO_SCHEMA"] == "Clip.2" for child in functions["children"])
    assert b"functions" in names[0].read_bytes()
    assert b"figure8.flac" in names[1].read_bytes()
    assert len(names[2].read_text().splitlines()) > 10


def test_without_blender_nothing_is_done_in_vain(
    capfdbinary: Captured, tmp_path: Path, beat: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("UNDERSTUDY_BLENDER", str(tmp_path / "blender"))
    code, err = _run(capfdbinary, "realize", str(beat), "-o", str(tmp_path / "a.fbx"), "-o", str(tmp_path / "a.bvh"))
    assert code != 0
    assert "UNDERSTUDY_BLENDER" in err
    assert not (tmp_path / "a.bvh").exists()
