"""Checks what is asked of motion before any work is done: the format's writer, the rig's name, the physics."""

from ..authored_folders import lexicon_folder
from ..realizer.body.skeleton import Skeleton
from ..realizer.exporting.extras import require_writer
from ..realizer.exporting.retargeting import find_rig, load_rigs
from ..realizer.physics.tracking import require_physics

__all__ = ["check_skeleton", "require_physics", "require_writer"]


def check_skeleton(name: str | None) -> None:
    """Raises InputError `unknown_skeleton`."""
    if name is not None:
        find_rig(load_rigs(lexicon_folder() / "retarget", Skeleton.standing()), name)
