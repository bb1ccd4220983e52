"""FBX: what is said without Blender, and what an independent reader finds where there is one."""

import os
import shutil
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from tests.support.motion.hand_made_motion import BODY, waving
from understudy.errors import ServiceError
from understudy.realizer.body.skeleton import forward
from understudy.realizer.exporting.fbx import blender_command, to_fbx
from understudy.realizer.exporting.glb import to_glb

BLENDER = os.environ.get("UNDERSTUDY_BLENDER")
HAS_BLENDER = bool(BLENDER or shutil.which("blender") or find_spec("bpy"))


def test_without_blender_it_is_said_what_would_help(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv("PATH", str(tmp_path))
    if find_spec("bpy") is None:
        with pytest.raises(ServiceError, match="UNDERSTUDY_BLENDER") as caught:
            blender_command()
        assert caught.value.code == "blender_missing"
    with pytest.raises(ServiceError, match="nowhere/blender is not a program"):
        blender_command("nowhere/blender")


def test_a_python_gets_no_options_of_blender() -> None:
    python = shutil.which("python3")
    assert python is not None
    assert blender_command(python) == (python,)
    shell = shutil.which("sh")
    assert shell is not None
    assert blender_command(shell)[:2] == (shell, "--background")


def test_what_fails_in_blender_is_said() -> None:
    with pytest.raises(ServiceError) as caught:
        to_fbx(b"", 1, 60, blender=shutil.which("false"))
    assert caught.value.code == "blender_failed"


@pytest.mark.skipif(not HAS_BLENDER or find_spec("ufbx") is None, reason="needs Blender (or bpy) and pyufbx")
def test_an_independent_reader_finds_units_axes_frames_and_the_first_pose(tmp_path: Path) -> None:
    import ufbx

    motion = waving(0.5, 60)
    glb = to_glb(motion, BODY)
    path = tmp_path / "motion.fbx"
    path.write_bytes(to_fbx(glb, len(motion.body.times_s), 60, blender=BLENDER))
    scene = ufbx.load_file(str(path))
    assert (scene.settings.unit_meters, scene.settings.frames_per_second) == (1.0, 60.0)
    assert scene.settings.axes.up.name == "COORDINATE_AXIS_POSITIVE_Y"
    (stack,) = scene.anim_stacks
    assert (stack.time_begin, stack.time_end) == pytest.approx((0.0, (len(motion.body.times_s) - 1) / 60))
    found = {node.name: np.array(node.node_to_world)[3, :3] for node in scene.nodes}
    ours, _turns = forward(BODY, motion.body.rotations[0], motion.body.hips_m[0])
    assert found.keys() == {*BODY.names, "Armature", "Body", "Face", ""}
    assert np.abs(np.stack([found[name] for name in BODY.names]) - ours).max() < 1e-3
