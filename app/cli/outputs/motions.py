"""Writes motion to files, in the format that each name ends in."""

from __future__ import annotations

import argparse
import os
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING

from ...library.motion_checks import check_skeleton, require_physics, require_writer
from ...model.formats import PICTURES, AudioFile, BapVersion, FileOptions, Keys, format_of
from ...models import load_realizer
from ...option_table import MOTION
from ...settings import Settings
from ..files import STANDARD, read_bytes, require_writable, write
from ..log import Log
from .plot import require_plot

if TYPE_CHECKING:
    from ...library.motion import Decision, PreparedSchedule, RealizedSchedule, Realizer
    from ...library.motion_models import MotionSource

LARGEST_AVATAR_BYTES = 256 << 20


def require_motions(names: Sequence[str], settings: Settings, *, field: str) -> None:
    """Checks the names before the work is done. Raises InputError for a name that could not be written; ServiceError if
    a dependency of the format is not installed: matplotlib for pictures, usd-core, Blender."""
    for name in names:
        form = format_of(name)
        if form in PICTURES:
            require_plot(name)
        require_writer(form, settings.blender)
        require_writable(name, field=field)


def physics_asked(arguments: argparse.Namespace, settings: Settings) -> bool:
    """Whether bodies have physics, by the command line or else by the settings. Raises ServiceError
    `physics_missing`."""
    asked = settings.physics if arguments.physics is None else bool(arguments.physics)
    if asked:
        require_physics()
    return asked


@dataclass(frozen=True, slots=True)
class MotionOptions:
    """How motion is made and written: frames per second, how much longer than the recording, with or without physics,
    the skeleton's name, the content of the avatar's file, and options of file formats."""

    frame_rate_hz: int
    tail_s: float
    physics: bool
    skeleton: str | None
    avatar: bytes | None
    files: FileOptions

    @classmethod
    def of(cls, arguments: argparse.Namespace, settings: Settings) -> MotionOptions:
        """Raises InputError `unknown_skeleton`, `value_wrong` and `file_unreadable`, ServiceError `physics_missing`."""
        check_skeleton(arguments.skeleton)
        MOTION["tail_s"].check(arguments.tail)
        physics = physics_asked(arguments, settings)
        name = arguments.avatar
        avatar = read_bytes(name, limit=LARGEST_AVATAR_BYTES, field="avatar") if name else None
        files = FileOptions(
            arguments.t_pose,
            arguments.root_at_origin,
            Keys(arguments.keys),
            blender=settings.blender,
            bap=BapVersion(arguments.bap_version),
        )
        return cls(arguments.fps, arguments.tail, physics, arguments.skeleton, avatar, files)


def write_motions(
    names: Sequence[str],
    staged: PreparedSchedule,
    options: MotionOptions,
    audio: AudioFile | None,
    log: Log,
    *,
    moving: MotionSource | None = None,
) -> None:
    """Realizes the schedule once, `moving` by a motion model if there is one, and writes it to every name; decisions
    are logged. Files refer to the recording by its path relative to them."""
    realizer = load_realizer()
    log.stage("realize")
    realized = _realized(realizer, staged, options, moving)
    log.warnings(realized.motion.notices[len(staged.notices) :])
    log.stage("export")
    export_motions(names, realized, realizer, options, audio)
    if realized.motion.decisions:
        log.note("\n".join(_told(decision) for decision in realized.motion.decisions))


def export_motions(
    names: Sequence[str],
    realized: RealizedSchedule,
    realizer: Realizer,
    options: MotionOptions,
    audio: AudioFile | None,
) -> None:
    """Writes a motion to every name."""
    from ...library.motion import AvatarOptions, write_realized

    wearer = AvatarOptions(options.skeleton, options.avatar)
    for name in names:
        files = replace(options.files, audio=audio and _from(name, audio))
        write(name, write_realized(realized, realizer, format_of(name), wearer, files))


def _realized(
    realizer: Realizer, staged: PreparedSchedule, options: MotionOptions, moving: MotionSource | None
) -> RealizedSchedule:
    if moving is not None:
        from ...library.motion_models import realize_moving

        return realize_moving(realizer, staged, moving, frame_rate_hz=options.frame_rate_hz, tail_s=options.tail_s)
    from ...library.motion import realize_prepared

    return realize_prepared(
        realizer,
        staged,
        frame_rate_hz=options.frame_rate_hz,
        tail_s=options.tail_s,
        physics=options.physics,
    )


def recording(name: str | None, content: bytes | None) -> AudioFile | None:
    """The recording; None if it has no name."""
    return None if name in (None, STANDARD) or content is None else AudioFile(str(name), content)


def _from(output: str, audio: AudioFile) -> AudioFile:
    """The recording with its path relative to the output's folder, with forward slashes."""
    folder = Path(output).resolve().parent
    try:
        name = os.path.relpath(Path(audio.name).resolve(), folder)
    except ValueError:  # on Windows, it is on another drive
        name = str(Path(audio.name).resolve())
    return replace(audio, name=Path(name).as_posix())


def _told(decision: Decision) -> str:
    return f"{decision.behavior or 'the body'} {decision.action}: {decision.reason}"
