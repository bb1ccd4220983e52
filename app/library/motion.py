"""From a performance, or from any BML, to motion and its files (paper §3.8)."""

import os
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path, PurePath
from typing import Literal, TypedDict, Unpack

from ..model import Performance
from ..model.formats import AudioFile, BapVersion, Keys, MotionFormat, format_of
from ..model.targets import targets_of
from ..models import Understudy
from ..realization import (
    OURS,
    AvatarOptions,
    BmlInput,
    PreparedSchedule,
    RealizedSchedule,
    Realizer,
    prepare_schedule,
    realize_prepared,
)
from ..realization import write_motion as write_realized
from ..realization.mpeg4 import read_mpeg4
from ..realizer.body.motion import Decision
from ..schemas.options import RealizeOptions, check_realize_options
from ..settings import read_settings
from .sources import FileSource, LevelName, content_of

__all__ = [
    "OURS",
    "AvatarOptions",
    "BmlInput",
    "Decision",
    "MotionFileKeywords",
    "MotionFormat",
    "PreparedSchedule",
    "RealizeKeywords",
    "RealizedSchedule",
    "Realizer",
    "prepare_schedule",
    "read_mpeg4",
    "realize",
    "realize_bml",
    "realize_prepared",
    "write_motion",
    "write_realized",
]


class RealizeKeywords(TypedDict, total=False):
    """How BML is to be played: `agitation` overrides the measured level, `character` the one named in the file; `fps`
    is 30 or 60, `seed` varies idle movement, `stillness` (0 to 1) reduces all movement, `targets` are the positions of
    things (as for performances), `tail_s` (0 to 10) is how long the motion goes on after the recording; `physics`
    simulates a body with mass."""

    agitation: LevelName | None
    character: str | None
    fps: Literal[30, 60]
    seed: int
    stillness: float
    targets: Mapping[str, Sequence[float]]
    tail_s: float
    physics: bool


class MotionFileKeywords(TypedDict, total=False):
    """How a motion's file is written; for what is left out, the defaults of `FileOptions` hold.

    With `t_pose` BVH begins with a T-pose, with `root_at_origin` its root has OFFSET zero; `keys` are those of GLB,
    `bap_version` says whose body parameters BAP has;
    `audio` is the recording's file, which USD refers to or contains (docs/motion-formats.md).
    """

    t_pose: bool
    root_at_origin: bool
    keys: Keys | Literal["baked", "sparse"]
    bap_version: BapVersion | Literal["3.1", "2.1"]
    audio: str | os.PathLike[str] | None


def realize(
    models: Understudy | Realizer,
    performance: Performance,
    *,
    fps: Literal[30, 60] = 60,
    seed: int | None = None,
    tail_s: float = 0.0,
    physics: bool = False,
) -> RealizedSchedule:
    """The motion of a performance (§3.8), frame by frame, as long as its recording plus `tail_s`, in which the hands
    come to rest; `seed` is the performance's own unless given. `physics` simulates a body with mass (ServiceError
    `physics_missing` without understudy[physics]). `Realizer` suffices.

    `realized.motion.decisions` says what could not be played as it was asked for, and why.
    """
    checked = check_realize_options({"fps": fps, "seed": seed, "tail_s": tail_s, "physics": physics})
    prepared = PreparedSchedule.of(performance)
    return _played(models, prepared if seed is None else replace(prepared, seed=seed), checked)


def realize_bml(
    models: Understudy, bml: FileSource, audio: FileSource | None = None, **options: Unpack[RealizeKeywords]
) -> RealizedSchedule:
    """The motion of BML, ours or others'. With the recording the lips move, and marks of the speech fall where its
    words are heard; without it `realized.motion.notices` says what was missing.

    Raises WrongBmlError with every mistake in the BML, InputError for audio, words and options that cannot be used.
    """
    checked = check_realize_options({**options})
    heard = None if audio is None else content_of(audio)
    name = Path("BML") if isinstance(bml, bytes) else Path(bml)
    prepared = prepare_schedule(
        models.acoustic,
        BmlInput(content_of(bml), name, heard),
        agitation=checked.agitation,
        character=checked.character,
        stillness=checked.stillness,
        targets=targets_of(checked.targets),
        seed=checked.seed,
    )
    return _played(models, prepared, checked)


def write_motion(
    models: Understudy | Realizer,
    realized: RealizedSchedule,
    form: MotionFormat | str,
    *,
    skeleton: str | None = None,
    avatar: FileSource | None = None,
    **written: Unpack[MotionFileKeywords],
) -> bytes:
    """The motion as `form`, a `MotionFormat` or the name of a file that ends in one ("line.glb", or "glb" alone).

    `skeleton` names the joints of BVH and JSON as another rig does, `avatar` is a GLB or VRM file to which the motion
    is applied in GLB. Raises InputError `motion_format`, `unknown_skeleton`, `unknown_avatar`, UndecodableError
    `avatar_undecodable`, ServiceError `usd_missing`, `blender_missing` and `blender_failed`, and ModuleNotFoundError
    for a picture without matplotlib.
    """
    motion_format = form if isinstance(form, MotionFormat) else format_of(f".{PurePath(form).name}")
    wearer = AvatarOptions(skeleton, None if avatar is None else content_of(avatar))
    audio = written.pop("audio", None)
    options = check_realize_options(dict(written))
    recording = None if audio is None else AudioFile(os.fspath(audio), content_of(audio))
    files = replace(options.files, audio=recording, blender=read_settings().blender)
    return write_realized(realized, _realizer(models), motion_format, wearer, files)


def _played(models: Understudy | Realizer, prepared: PreparedSchedule, options: RealizeOptions) -> RealizedSchedule:
    return realize_prepared(
        _realizer(models),
        prepared,
        frame_rate_hz=options.fps,
        tail_s=options.tail_s,
        physics=bool(options.physics),
    )


def _realizer(models: Understudy | Realizer) -> Realizer:
    return models.realizer if isinstance(models, Understudy) else models
