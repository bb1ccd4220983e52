"""The zip is what Blender's own tool accepts."""

import subprocess
import sys
from pathlib import Path


def test_blenders_own_check_finds_nothing_wrong(extension: Path) -> None:
    import bpy

    tool = Path(bpy.utils.system_resource("SCRIPTS")) / "addons_core" / "bl_pkg" / "cli" / "blender_ext.py"
    run = subprocess.run(
        [sys.executable, str(tool), "validate", str(extension)], capture_output=True, text=True, check=False
    )
    assert run.returncode == 0, run.stdout + run.stderr


def test_it_is_switched_off_and_on_again(extension: Path) -> None:
    import addon_utils
    import bpy

    assert extension.exists()
    addon_utils.disable("bl_ext.user_default.understudy")
    assert not hasattr(bpy.types.Scene, "understudy")
    addon_utils.enable("bl_ext.user_default.understudy")
    assert hasattr(bpy.types.Scene, "understudy")
