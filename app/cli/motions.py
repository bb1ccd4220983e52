"""Motion as files, in the format that each name ends in."""

import argparse
from collections.abc import Sequence
from dataclasses import replace

from ..errors import InputError
from ..realization import (
    PICTURES,
    AvatarOptions,
    PreparedSchedule,
    Realized,
    Realizer,
    format_of,
    realize,
    write_motion,
)
from ..realizer.body.motion import Decision
from .files import read_bytes, require_writable, write
from .log import Log
from .plot import require_plot

LARGEST_AVATAR_BYTES = 256 << 20


def require_motions(names: Sequence[str], *, field: str) -> None:
    """Raises InputError for a name that could not be written, before the work is done; ServiceError for a picture when
    matplotlib is not there."""
    for name in names:
        if format_of(name) in PICTURES:
            require_plot(name)
        require_writable(name, field=field)
    if len(set(names)) < len(names):
        raise InputError("usage", "the same file is named twice", field=field)


def write_motions(
    names: Sequence[str], realizer: Realizer, staged: PreparedSchedule, arguments: argparse.Namespace, log: Log
) -> None:
    """Realizes the schedule once and writes it to every name; decisions are told."""
    if not names:
        return
    wearer = _wearer(arguments, realizer)
    log.stage("realize")
    motion = realize(realizer, staged.schedule, frame_rate_hz=arguments.fps, seed=arguments.seed)
    realized = Realized(staged.schedule, replace(motion, notices=staged.notices))
    log.stage("export")
    for name in names:
        write(name, write_motion(realized, realizer, format_of(name), wearer))
    if motion.decisions:
        log.note("\n".join(_told(decision) for decision in motion.decisions))


def _wearer(arguments: argparse.Namespace, realizer: Realizer) -> AvatarOptions:
    """Raises InputError `unknown_skeleton` and `file_unreadable` before anything is realized."""
    if arguments.skeleton:
        realizer.rig(arguments.skeleton)
    avatar = read_bytes(arguments.avatar, limit=LARGEST_AVATAR_BYTES, field="avatar") if arguments.avatar else None
    return AvatarOptions(arguments.skeleton, avatar)


def _told(decision: Decision) -> str:
    return f"{decision.behavior or 'the body'} {decision.action}: {decision.reason}"
