"""The scripts for Unity, compiled and run by Mono with stand-ins for Unity's classes (`tests/clients/unity`)."""

import json
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from tests.support.served import served
from understudy.api.workers.processes import Nursery

ROOT = Path(__file__).parents[2]
AUDIO = ROOT / "tests" / "audio" / "figure8.flac"
JOINTS = {"hips": None, "spine": "hips", "chest": "spine", "leftUpperArm": "chest", "leftLowerArm": "leftUpperArm"}
RIG = ("Armature", "Hips", "Spine", "LeftUpperArm", "LeftLowerArm")
MIRROR = np.array([-1.0, 1.0, 1.0])
ROOT_TURN = Rotation.from_quat([0, 0.6, 0, 0.8])
ROOT_PLACE = np.array([2.0, 0.0, -1.0])
RATE_HZ, REST_M, HEIGHT_M = 30, [0.0, 0.9, 0.0], 1.2


@pytest.fixture(scope="module")
def program(tmp_path_factory: pytest.TempPathFactory) -> list[str]:
    """The command that runs the scripts."""
    compiler, mono = shutil.which("mcs"), shutil.which("mono")
    library = next(Path("/usr/lib/mono").glob("gac/Newtonsoft.Json/*/Newtonsoft.Json.dll"), None)
    if compiler is None or mono is None or library is None:
        pytest.skip("needs Debian's mono-mcs, mono-runtime and libnewtonsoft-json5.0-cil")
    made = tmp_path_factory.mktemp("unity") / "client.exe"
    sources = [*(ROOT / "clients/unity").glob("*.cs"), *(ROOT / "tests/clients/unity").glob("*.cs")]
    subprocess.run([compiler, f"-r:{library}", "-warnaserror", "-nowarn:649", f"-out:{made}", *sources], check=True)
    return [mono, str(made)]


def turns(seed: int) -> list[list[float]]:
    """Two rotations, less than half a turn apart."""
    first = Rotation.random(random_state=seed)
    return [list(first.as_quat()), list((first * Rotation.from_rotvec([0.3, 0.2, -0.4])).as_quat())]


def clip_of(tracks: Mapping[str, Sequence[Sequence[float]]]) -> dict[str, object]:
    joints = [{"name": name, "parent": parent, "offset_m": REST_M} for name, parent in JOINTS.items()]
    return {
        "format": "understudy-clip",
        "version": 1,
        "skeleton": {"joints": joints},
        "frames": 2,
        "frame_rate_hz": RATE_HZ,
        "audio_offset_s": -0.25,
        "hips_m": [REST_M, [0.06, 0.84, 0.03]],
        "bones": tracks,
        "blendshapes": {"jawOpen": [0.0, 0.5], "mouthClose": [0.1]},
    }


def bones_of(rests: Mapping[str, Rotation]) -> list[dict[str, object]]:
    """A rig in Unity's axes; the rests are those of bones in the character's axes, whatever their parents' are."""
    bones: list[dict[str, object]] = []
    for name, above in zip(RIG, (None, *RIG), strict=False):
        local = rests[name] if above is None else rests[above].inv() * rests[name]
        position = rests[above].inv().apply([0, HEIGHT_M, 0]) if name == "Hips" and above else np.zeros(3)
        bones.append({"name": name, "parent": above, "position": list(position), "rotation": list(local.as_quat())})
    return bones


def in_unity(turn: Rotation) -> Rotation:
    """The same rotation seen in axes of which the first points the other way: M R M."""
    return Rotation.from_matrix(np.diag(MIRROR) @ turn.as_matrix() @ np.diag(MIRROR))


def test_bones_stand_as_the_clip_says_whatever_axes_they_have(program: list[str], tmp_path: Path) -> None:
    tracks = {name: turns(seed) for seed, name in enumerate(JOINTS)}
    rests = {name: Rotation.random(random_state=100 + seed) for seed, name in enumerate(RIG)}
    (tmp_path / "clip.json").write_text(json.dumps(clip_of(tracks)))
    (tmp_path / "rig.json").write_text(json.dumps(bones_of(rests)))
    for frame in (0, 1):
        command = [*program, "show", str(tmp_path / "clip.json"), str(tmp_path / "rig.json"), repr(frame / RATE_HZ)]
        shown = json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)
        above: dict[str | None, Rotation] = {None: Rotation.identity()}
        for name, parent in JOINTS.items():
            above[name] = above[parent] * Rotation.from_quat(tracks[name][frame])
            bone = name[0].upper() + name[1:]
            if bone in RIG:
                wanted = ROOT_TURN * in_unity(above[name]) * rests[bone]
                assert (Rotation.from_quat(shown[bone][:4]) * wanted.inv()).magnitude() < 1e-3
        moved = (np.array([0.06, 0.84, 0.03]) - REST_M) * MIRROR * HEIGHT_M / REST_M[1] * frame
        wanted_place = ROOT_PLACE + ROOT_TURN.apply(np.array([0, HEIGHT_M, 0]) + moved)
        assert shown["Hips"][4:] == pytest.approx(wanted_place, abs=1e-4)
        assert shown["jawOpen"] == pytest.approx([50.0 * frame], abs=1e-3)


def test_what_is_no_clip_is_refused(program: list[str], tmp_path: Path) -> None:
    (tmp_path / "clip.json").write_text('{"format": "understudy-clip", "version": 2}')
    (tmp_path / "rig.json").write_text("[]")
    command = [*program, "show", str(tmp_path / "clip.json"), str(tmp_path / "rig.json"), "0"]
    assert (
        "no understudy-clip of version 1" in subprocess.run(command, check=False, capture_output=True, text=True).stderr
    )


def test_a_service_performs_a_line_and_its_refusal_is_told(program: list[str], nursery: Nursery) -> None:
    text = AUDIO.with_suffix(".txt").read_text(encoding="utf-8").strip()
    with served(nursery, workers=1) as service:
        command = [*program, "perform", f"http://127.0.0.1:{service.port}", str(AUDIO)]
        performed = subprocess.run([*command, text], check=True, capture_output=True, text=True).stdout
        refused = subprocess.run([*command, " "], check=True, capture_output=True, text=True).stdout
    assert performed.startswith("frames ")
    assert int(performed.split()[1]) > 100
    assert refused.startswith("refused: ")
    assert "word" in refused
