"""`understudy motion-model` and what performs by its models, on recordings with motion that are made here."""

import json
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from tests.motion_models.pairs import POINTS, write_bvh, write_points
from understudy.bvh import Bvh, read_bvh
from understudy.cli.main import main
from understudy.motion_models.model import MotionModel

Captured = pytest.CaptureFixture[str]
AUDIO, TEXT = "examples/example.flac", "examples/example.txt"


@pytest.fixture(scope="module")
def pairs(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Three recordings of BVH and sound, of which one has its affect annotated."""
    folder = tmp_path_factory.mktemp("pairs")
    for seed in range(3):
        write_bvh(folder, f"a_{seed}_line", seed)
    track = "time_s,activation,valence,dominance\n0,-1,-1,-1\n12,1,1,1\n"
    (folder / "a_1_line.affect.csv").write_text(track)
    return folder


@pytest.fixture(scope="module")
def model(pairs: Path) -> Path:
    assert main(["motion-model", "train", str(pairs), "-o", str(pairs / "model.npz"), "--kinds", "4", "--quiet"]) == 0
    return pairs / "model.npz"


def motion(path: Path) -> Bvh:
    return read_bvh(path.read_bytes(), path.name)


def test_a_folder_teaches_a_model(pairs: Path, model: Path, capsys: Captured) -> None:
    """The same seed gives the same bytes; annotated affect is what units have."""
    again = pairs / "again.npz"
    assert main(["motion-model", "train", str(pairs), "-o", str(again), "--kinds", "4"]) == 0
    assert "4 kinds of movements of 3 recordings of 3 sessions, 0.6 min, seed 0" in capsys.readouterr().err
    assert again.read_bytes() == model.read_bytes()
    learnt = MotionModel.load(model)
    assert sum(len(unit.rotations) for unit in learnt.units) == pytest.approx(3 * 12 / 0.025, abs=12)
    feelings = np.array([unit.affect for unit in learnt.units])
    assert feelings.min() < -0.8
    assert feelings.max() > 0.8
    assert np.ptp(feelings, axis=1).min() < 1e-5, "annotated alike in all three dimensions"


def test_a_line_is_performed_by_its_units(model: Path, tmp_path: Path, capsys: Captured) -> None:
    """Arms move as in the recordings, where the right one always hangs, but for a hand's breadth out of the leg; legs
    do as usual."""
    out, usual = tmp_path / "by_model.bvh", tmp_path / "usual.bvh"
    line = ["perform", AUDIO, "--text-file", TEXT, "-o", str(tmp_path / "x.bml"), "--skeleton", "vrm"]
    assert main([*line, "--realize", str(out), "--motion-model", str(model)]) == 0
    assert "replaced: the motion model moves that part of the body" in capsys.readouterr().err
    assert main([*line, "--realize", str(usual), "--quiet"]) == 0
    moved, ordinary = motion(out), motion(usual)
    names = [joint.name for joint in moved.joints]
    middle = slice(60, -60)
    hanging = moved.rotations(names.index("rightUpperArm"))[middle, :, 0]
    assert hanging == pytest.approx(np.tile([0, 1, 0], (len(hanging), 1)), abs=0.15), "its x axis points up"
    forearm = moved.rotations(names.index("leftLowerArm"))[middle]
    assert np.ptp(forearm[:, 0, 0]) > 0.3, "the left forearm bends"
    leg = names.index("leftUpperLeg")
    assert moved.rotations(leg) == pytest.approx(ordinary.rotations(leg), abs=0.2), "but for the weight of gestures"
    assert len(moved.values) == len(ordinary.values)


def test_the_shipped_model_says_what_it_is_and_moves_a_line(tmp_path: Path, capsys: Captured) -> None:
    """Without any recording of people; hands stay out of the body."""
    shipped = Path("models/motion/default.npz")
    assert shipped.stat().st_size < 2_000_000
    assert MotionModel.load(shipped).about.startswith("our own performed motion, said by synthetic voices: 10 kinds")
    out = tmp_path / "by_model.bvh"
    line = ["perform", AUDIO, "--text-file", TEXT, "-o", str(tmp_path / "x.bml"), "--skeleton", "vrm"]
    assert main([*line, "--realize", str(out), "--motion-model", "default", "--scenario", "S4", "--fps", "30"]) == 0
    assert "cm inside something" not in capsys.readouterr().err
    moved = motion(out)
    forearm = moved.rotations([joint.name for joint in moved.joints].index("leftLowerArm"))
    assert np.ptp(forearm[:, 0, 0]) > 0.1


def test_scenarios_can_be_chosen_and_the_same_one_moves_the_same(model: Path, tmp_path: Path) -> None:
    """Of four, three at least move differently by one feeling that lasts."""
    line = ["perform", AUDIO, "--text-file", TEXT, "-o", str(tmp_path / "x.bml"), "--quiet"]
    line += ["--motion-model", str(model), "--affect", "1,1,1"]
    scenarios = ("S2", "S3", "S6", "RTS", "RTS")
    moved = list[bytes]()
    for number, scenario in enumerate(scenarios):
        out = tmp_path / f"{number}.bvh"
        assert main([*line, "--realize", str(out), "--scenario", scenario]) == 0
        moved.append(out.read_bytes())
    assert moved[-1] == moved[-2]
    assert len(set(moved)) >= 3


def test_arrays_of_points_teach_arms(tmp_path: Path, capsys: Captured) -> None:
    for seed in range(2):
        write_points(tmp_path, f"a_b_{seed}", seed)
    assert main(["motion-model", "train", str(tmp_path), "-o", str(tmp_path / "model")]) == 0
    assert "units that move 4 joints" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("wrong", "told"),
    [
        ("nothing", "no recordings with motion, but notes.txt; give NAME.bvh with NAME.wav beside it"),
        ("silent", "a_0.bvh: no sound beside it; give a_0.wav"),
        ("broken", "a_0.bvh: not a BVH that can be read: it does not begin with HIERARCHY"),
        ("arrays", "b.npz: lacks f0_hz, envelope, joints, body, body_time_s"),
        ("affect", "a_0.affect.csv: the first line must be time_s,activation,valence,dominance"),
        ("short", "1.0 s of sound with motion; 2 s at least"),
        ("kinds", "are too little for 150 kinds: give 112.5 s or fewer --kinds"),
    ],
)
def test_what_is_wrong_with_a_folder_is_told(tmp_path: Path, capsys: Captured, wrong: str, told: str) -> None:
    (tmp_path / "notes.txt").write_text("not motion")
    if wrong != "nothing":
        write_bvh(tmp_path, "a_0", seconds=1.0 if wrong == "short" else 4.0)
    match wrong:
        case "silent":
            (tmp_path / "a_0.wav").unlink()
        case "broken":
            (tmp_path / "a_0.bvh").write_text("hello")
        case "arrays":
            np.savez(tmp_path / "b.npz", other=np.zeros(3))
        case "affect":
            (tmp_path / "a_0.affect.csv").write_text("time,feeling\n")
    model = tmp_path / "model.npz"
    kinds = ["--kinds", "150"] if wrong == "kinds" else []
    assert main(["motion-model", "train", str(tmp_path), "-o", str(model), *kinds]) == 2
    assert told in capsys.readouterr().err
    assert not model.exists()


@pytest.mark.parametrize(
    ("name", "array", "told"),
    [
        ("envelope", np.full(1200, np.nan), "`envelope` has values that are not finite numbers"),
        ("f0_hz", np.full(1200, -100.0), "`f0_hz` is below 0; NaN is unvoiced"),
        ("f0_hz", np.full(1200, "low"), "`f0_hz` has no numbers"),
        ("f0_hz", np.ones((1200, 2)), "are one number each for a frame"),
        ("body_time_s", np.arange(360)[::-1] / 30, "`body_time_s` are seconds, each later than the one before"),
        ("body_time_s", np.full(360, np.nan), "`body_time_s` are seconds, each later than the one before"),
        ("body", np.zeros((360, len(POINTS), 4)), "all points of `body` are in one place"),
        ("width_to_height", np.array(0.0), "`width_to_height` is one number above 0"),
    ],
)
def test_arrays_that_cannot_be_are_told(
    tmp_path: Path, capsys: Captured, name: str, array: NDArray[Any], told: str
) -> None:
    write_points(tmp_path, "a_b_0", 0)
    path = tmp_path / "a_b_0.npz"
    with np.load(path) as arrays:
        np.savez(path, **{**arrays, name: array})
    assert main(["motion-model", "train", str(tmp_path), "-o", str(tmp_path / "m.npz"), "--kinds", "3"]) == 2
    (line,) = [line for line in capsys.readouterr().err.splitlines() if line.startswith("understudy: ")]
    assert "a_b_0.npz: " in line
    assert told in line


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ([], "--motion-model needs --realize"),
        (["--realize", "x.bvh", "--scenario", "S7"], "scenario: 'S7'; give one of S1, S2"),
        (
            ["--realize", "x.bvh", "--motion-model", TEXT],
            "not a motion model (understudy motion-model train writes one)",
        ),
        (["--realize", "x.bvh", "--motion-model", TEXT], "it is not an .npz file"),
        (["--realize", "x.bvh", "--motion-model", "gone.npz"], "gone.npz: cannot be read"),
    ],
)
def test_what_cannot_move_is_told(model: Path, tmp_path: Path, capsys: Captured, options: list[str], told: str) -> None:
    given = [] if "--motion-model" in options else ["--motion-model", str(model)]
    options = [str(tmp_path / "x.bvh") if each == "x.bvh" else each for each in options]
    line = ["perform", AUDIO, "--text-file", TEXT, "-o", str(tmp_path / "x.bml"), *given, *options]
    assert main(line) == 2
    assert told in capsys.readouterr().err
    assert not (tmp_path / "x.bml").exists()


def test_a_scenario_needs_a_model(tmp_path: Path, capsys: Captured) -> None:
    line = ["perform", AUDIO, "--text-file", TEXT, "-o", str(tmp_path / "x.bml"), "--realize", str(tmp_path / "x.bvh")]
    assert main([*line, "--scenario", "S1"]) == 2
    assert "--scenario needs --motion-model" in capsys.readouterr().err
    assert not (tmp_path / "x.bml").exists()


def test_motion_is_scored_against_the_recorded_one(pairs: Path, tmp_path: Path, capsys: Captured) -> None:
    """Each session by models of the others, the papers' figures beside; a search for all is the full one."""
    report, figure = tmp_path / "scores.json", tmp_path / "scores.png"
    line = ["motion-model", "score", str(pairs), "--kinds", "3", "--scenario", "S1", "--scenario", "RTS", "--search"]
    assert main([*line, "-o", str(report), "--plot", str(figure)]) == 0
    told = capsys.readouterr().out
    assert "3 recordings, 0.6 min; a session is moved by a model of the others" in told
    assert "S1" in told
    assert "0.566" in told, "the paper's"
    scores = json.loads(report.read_text())
    assert set(scores["scenarios"]) == {"S1", "RTS"}
    assert set(scores["features"]) == {"p", "a", "ap", "AP", "labels"}
    assert scores["searches"][0]["similarity"] == 1.0
    assert {(each["search"]["step"], each["search"]["best"]) for each in scores["searches"]} >= {(10, 3), (5, 3)}
    assert scores["energy"] > 0
    assert figure.read_bytes().startswith(b"\x89PNG")


def test_a_single_recording_cannot_be_left_out(tmp_path: Path, capsys: Captured) -> None:
    write_bvh(tmp_path, "a_0")
    assert main(["motion-model", "score", str(tmp_path), "--kinds", "3"]) == 2
    assert "a single recording; give at least two" in capsys.readouterr().err


@pytest.mark.parametrize("search", [[], ["--search", "5", "3"]])
def test_live_speech_is_moved_by_units(model: Path, capsys: Captured, search: list[str]) -> None:
    """Phrases are announced, then decided; the right arm hangs as in the recordings, and the body makes no beats."""
    assert main(["live", AUDIO, "--model", str(model), "--frames", "30", "--quiet", *search]) == 0
    ready, *told = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    phrases = [each for each in told if each["type"] == "phrase"]
    assert {each["decided"] for each in phrases} == {True, False}
    announced = [each for each in phrases if not each["decided"]]
    assert max(each["heard_s"] - each["start_s"] for each in announced) < 0.5
    assert not [each for each in told if each["type"] == "gesture"]
    place = ready["joints"].index("rightUpperArm")
    last = [each for each in told if each["type"] == "frame"][-30]
    x, y, z, w = np.reshape(last["rotations"], (-1, 4))[place]
    assert 2 * (x * y + w * z) == pytest.approx(1, abs=0.02), "the x axis of the hanging arm points up"


def test_live_speech_is_moved_by_the_shipped_model_by_its_name(capsys: Captured) -> None:
    """Phrases are announced and decided; both arms move, and nothing jumps."""
    assert main(["live", AUDIO, "--model", "default", "--frames", "30", "--quiet"]) == 0
    ready, *told = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert {each["decided"] for each in told if each["type"] == "phrase"} == {True, False}
    assert not [each for each in told if each["type"] == "gesture"]
    turns = np.array([each["rotations"] for each in told if each["type"] == "frame"]).reshape(
        -1, len(ready["joints"]), 4
    )
    arms = turns[:, [ready["joints"].index(f"{side}LowerArm") for side in ("left", "right")]]
    assert np.ptp(arms, axis=0).max(axis=1).min() > 0.05
    between = np.abs((turns[1:] * turns[:-1]).sum(axis=2)).clip(max=1)
    assert (2 * np.arccos(between) * 30).max() < 20, "rad/s"


def test_a_search_needs_a_model(capsys: Captured) -> None:
    assert main(["live", AUDIO, "--search", "5", "3"]) == 2
    assert "--search needs --model" in capsys.readouterr().err
