"""Motion as files, in the format that each name ends in."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

from ...loading import load_realizer
from ...motion_formats import PICTURES, FileOptions, Keys, format_of
from ...realizer.body.motion import Decision, check_tail
from ...realizer.body.skeleton import Skeleton
from ...realizer.exporting.retargeting import find_rig, load_rigs
from ...resources import resource_folder
from ..files import read_bytes, require_writable, write
from ..log import Log
from .plot import require_plot

if TYPE_CHECKING:
    from ...realization import PreparedSchedule

LARGEST_AVATAR_BYTES = 256 << 20


def require_motions(names: Sequence[str], *, field: str) -> None:
    """Raises InputError for a name that could not be written, before the work is done; ServiceError for a picture when
    matplotlib is not there."""
    for name in names:
        if format_of(name) in PICTURES:
            require_plot(name)
        require_writable(name, field=field)


def require_skeleton(name: str | None) -> None:
    """Raises InputError `unknown_skeleton`."""
    if name is not None:
        find_rig(load_rigs(resource_folder("lexicon") / "retarget", Skeleton.standing()), name)


@dataclass(frozen=True, slots=True)
class MotionOptions:
    """How motion is made and written: frames a second, how much longer than the recording, the skeleton's name, the
    content of the avatar's file, and what is special in files."""

    frame_rate_hz: int
    tail_s: float
    skeleton: str | None
    avatar: bytes | None
    files: FileOptions

    @classmethod
    def of(cls, arguments: argparse.Namespace) -> MotionOptions:
        """Raises InputError `unknown_skeleton`, `value_wrong` and `file_unreadable`."""
        require_skeleton(arguments.skeleton)
        check_tail(arguments.tail)
        name = arguments.avatar
        avatar = read_bytes(name, limit=LARGEST_AVATAR_BYTES, field="avatar") if name else None
        files = FileOptions(arguments.t_pose, arguments.root_at_origin, Keys(arguments.keys))
        return cls(arguments.fps, arguments.tail, arguments.skeleton, avatar, files)


def write_motions(names: Sequence[str], staged: PreparedSchedule, options: MotionOptions, log: Log) -> None:
    """Realizes the schedule once and writes it to every name; decisions are told."""
    from ...realization import AvatarOptions, realize_prepared, write_motion

    realizer = load_realizer()
    log.stage("realize")
    realized = realize_prepared(realizer, staged, frame_rate_hz=options.frame_rate_hz, tail_s=options.tail_s)
    log.warnings(realized.motion.notices[len(staged.notices) :])
    log.stage("export")
    wearer = AvatarOptions(options.skeleton, options.avatar)
    for name in names:
        write(name, write_motion(realized, realizer, format_of(name), wearer, options.files))
    if realized.motion.decisions:
        log.note("\n".join(_told(decision) for decision in realized.motion.decisions))


def _told(decision: Decision) -> str:
    return f"{decision.behavior or 'the body'} {decision.action}: {decision.reason}"
