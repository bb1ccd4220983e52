"""Writes motion in every format, for our mannequin, a rig, or an avatar."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType

from ..authored_folders import lexicon_folder
from ..editorial.events import timeline_events, to_elan, to_event_table, to_textgrid, tracks_of
from ..editorial.timeline import to_otio
from ..model import FloatArray
from ..model.formats import EDITORIAL, SCENES, AudioFile, FileOptions, Keys, MotionFormat
from ..realizer.avatars.avatar import to_avatar_glb
from ..realizer.exporting.bvh import to_bvh
from ..realizer.exporting.clip_json import to_clip_json
from ..realizer.exporting.extras import require_usd
from ..realizer.exporting.face_lists import to_arkit_csv, to_viseme_text
from ..realizer.exporting.fbx import to_fbx
from ..realizer.exporting.glb import to_glb
from ..realizer.exporting.vrma import to_vrma
from ..realizer.face.lips import viseme_weights, with_glides
from ..realizer.mpeg4.bap import to_bap
from ..realizer.mpeg4.fap import TABLE, FapTable, to_fap
from ..realizer.pictures.contact_sheet import draw_sheet, moments_of
from ..realizer.pictures.speed_plot import draw_speeds
from ..realizer.realizing import Realizer
from .motion import RealizedSchedule

VRM, MIXAMO = "vrm", "mixamo"
_RIGS: Mapping[MotionFormat, str] = MappingProxyType({MotionFormat.BVH: MIXAMO})
"""The default rig of each format; VRM for all others."""


@dataclass(frozen=True, slots=True)
class AvatarOptions:
    """What the motion is written for: the rig that names the joints in BVH and clips, and an avatar (a GLB or VRM
    file) that replaces our mannequin in GLB."""

    rig: str | None = None
    avatar: bytes | None = None


OURS = AvatarOptions()
USUAL = FileOptions()


def write_motion(
    realized: RealizedSchedule,
    realizer: Realizer,
    form: MotionFormat,
    wearer: AvatarOptions = OURS,
    options: FileOptions = USUAL,
) -> bytes:
    """The motion in the given format.

    Raises InputError `unknown_skeleton` and `unknown_avatar`, UndecodableError `avatar_undecodable`.
    """
    motion, schedule = realized.motion, realized.schedule
    performer = realizer.performer(schedule.character)
    skeleton, looks = performer.skeleton, performer.looks
    rig = realizer.rig(wearer.rig or _RIGS.get(form, VRM))
    writers: Mapping[MotionFormat, Callable[[], bytes]] = {
        MotionFormat.BVH: lambda: to_bvh(
            motion, skeleton, rig, t_pose=options.t_pose, root_at_origin=options.root_at_origin
        ),
        MotionFormat.GLB: lambda: _glb(realized, realizer, wearer.avatar, options.keys),
        MotionFormat.VRMA: lambda: to_vrma(motion, skeleton),
        **{form: partial(_usd, realized, realizer, form, options.audio) for form in SCENES},
        MotionFormat.FBX: lambda: to_fbx(
            _glb(realized, realizer, wearer.avatar, Keys.BAKED),
            len(motion.body.times_s),
            motion.frame_rate_hz,
            blender=options.blender,
        ),
        MotionFormat.JSON: lambda: to_clip_json(motion, skeleton, rig, visemes=_viseme_weights(realized, realizer)),
        MotionFormat.CSV: lambda: to_arkit_csv(motion, skeleton),
        MotionFormat.VISEMES: lambda: to_viseme_text(schedule.visemes, schedule.duration_s),
        MotionFormat.BAP: lambda: to_bap(motion, skeleton, options.bap),
        MotionFormat.FAP: lambda: _fap(realized, realizer, options),
        **{form: partial(_editorial, realized, form, options.audio) for form in EDITORIAL},
        MotionFormat.SHEET: lambda: draw_sheet(motion, skeleton, moments_of(motion, schedule), looks=looks),
        MotionFormat.SPEEDS: lambda: draw_speeds(motion, skeleton, schedule),
    }
    return writers[form]()


def _glb(realized: RealizedSchedule, realizer: Realizer, avatar: bytes | None, keys: Keys) -> bytes:
    """On the caller's avatar, or on the character's mannequin."""
    performer = realizer.performer(realized.schedule.character)
    sparse_for = realized.schedule.behaviors if keys is Keys.SPARSE else None
    if avatar is None:
        return to_glb(realized.motion, performer.skeleton, performer.looks, sparse_for=sparse_for)
    return to_avatar_glb(realized.motion, performer.skeleton, avatar, realizer.rigs, sparse_for=sparse_for)


def _fap(realized: RealizedSchedule, realizer: Realizer, options: FileOptions) -> bytes:
    """Raises AuthoringError for the table of facial animation parameters."""
    skeleton = realizer.performer(realized.schedule.character).skeleton
    table = FapTable.load(lexicon_folder() / TABLE)
    return to_fap(realized.motion, skeleton, table, _viseme_weights(realized, realizer), options.bap)


def _usd(realized: RealizedSchedule, realizer: Realizer, form: MotionFormat, audio: AudioFile | None) -> bytes:
    """Raises ServiceError `usd_missing`."""
    require_usd()
    from ..realizer.exporting.usd import UsdForm, to_usd  # an optional extra

    performer = realizer.performer(realized.schedule.character)
    return to_usd(
        realized.motion,
        performer.skeleton,
        UsdForm(form.value.removeprefix(".")),
        performer.looks,
        behaviors=realized.schedule.behaviors,
        audio=audio,
    )


def _editorial(realized: RealizedSchedule, form: MotionFormat, audio: AudioFile | None) -> bytes:
    """Functions and movements as timed events, for editing, annotation and statistics."""
    schedule, motion = realized.schedule, realized.motion
    events, lead_in_s = timeline_events(schedule, motion.realized), schedule.lead_in_s
    match form:
        case MotionFormat.OTIO:
            lasting = {"lead_in_s": lead_in_s, "duration_s": schedule.duration_s}
            return to_otio(events, motion.frame_rate_hz, audio=audio, **lasting)
        case MotionFormat.EVENTS:
            return to_event_table(events, clock_starts_s=lead_in_s)
    tracks = tracks_of(events, clock_starts_s=lead_in_s, words=schedule.words)
    if form is MotionFormat.EAF:
        return to_elan(tracks, audio.name if audio else "")
    return to_textgrid(tracks, schedule.duration_s - lead_in_s)


def _viseme_weights(realized: RealizedSchedule, realizer: Realizer) -> FloatArray | None:
    """The weights (T, 15) of the speech's visemes; None when nothing is said."""
    schedule = realized.schedule
    spoken = with_glides(schedule.visemes, schedule.words)
    return viseme_weights(realizer.face.visemes, spoken, realized.motion.body.times_s) if spoken else None
