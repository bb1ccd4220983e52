"""Exports FBX: the GLB of the same motion, converted by Blender in a process of its own (`fbx_in_blender.py`).

Conventions: the file says metres, Y up, facing +Z; frame 0 is the motion's first and the range ends with its last.
Blender is found as `told` (a Blender, or a Python that has `bpy`), as `blender` in the PATH, or as the module `bpy`
beside us, which is never imported here.
"""

import importlib.util
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from ...errors import ServiceError

LONGEST_S = 600.0
_SCRIPT = Path(__file__).with_name("fbx_in_blender.py")
_BLENDER_OPTIONS = ("--background", "--factory-startup", "--python-exit-code", "1", "--python")


def blender_command(told: str | None = None) -> tuple[str, ...]:
    """The beginning of the command that runs a script. Raises ServiceError `blender_missing`."""
    program = told or shutil.which("blender")
    if program is None and importlib.util.find_spec("bpy") is not None:
        program = sys.executable
    if program is None or shutil.which(program) is None:
        where = f"{told} is not a program" if told else "there is no blender in the PATH, nor the module bpy"
        message = f"FBX is written by Blender: {where}; install it, or say where it is with UNDERSTUDY_BLENDER"
        raise ServiceError("blender_missing", message)
    is_python = Path(program).name.startswith("python")
    return (program,) if is_python else (program, *_BLENDER_OPTIONS)


def to_fbx(glb: bytes, frames: int, frame_rate_hz: int, *, blender: str | None = None) -> bytes:
    """The GLB as FBX. Raises ServiceError `blender_missing` and `blender_failed`."""
    command = blender_command(blender)
    with tempfile.TemporaryDirectory() as folder:
        source, target = Path(folder) / "motion.glb", Path(folder) / "motion.fbx"
        source.write_bytes(glb)
        given = (str(_SCRIPT), "--", str(source), str(target), str(frame_rate_hz), str(frames))
        _run((*command, *given))
        return target.read_bytes()


def _run(command: tuple[str, ...]) -> None:
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=LONGEST_S)
    except (OSError, subprocess.TimeoutExpired) as error:
        raise ServiceError("blender_failed", f"{command[0]}: {error}") from None
    if done.returncode:
        said = (done.stderr or done.stdout).strip().splitlines() or ["it says nothing"]
        raise ServiceError("blender_failed", f"{command[0]} ended with {done.returncode}: {said[-1]}")
