"""Realizes a BML schedule as motion, with the paper's controllers (§3.8) in order: the idle body first, the face last.

Each controller takes the body's motion so far and returns a new one. Gestures and gaze override the joints that they
move, head movements are added to the current rotations, and a last pass resolves collisions of the arms with the body.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..model import Behavior, Channel, FloatArray, Schedule, SyncPoints
from .arms.collisions import resolve_collisions
from .body.motion import Motion
from .body.skeleton import Skeleton
from .exporting.retargeting import Rig, find_rig, load_rigs
from .face.expressions import realized_faces, unknown_faces
from .face.face import face_weights
from .face.face_tables import FaceTables
from .gestures.gesture_plan import GesturePlan
from .gestures.library import Library
from .head_and_gaze.gaze import apply_gaze
from .head_and_gaze.head import apply_head_movements
from .head_and_gaze.head_movements import realized_heads
from .scheduling.gesture_controller import apply_gestures
from .scheduling.planning import plan_gestures
from .scheduling.unplayable import unplayable_behaviors
from .torso.idle import idle_motion


@dataclass(frozen=True, slots=True, eq=False)
class Realizer:
    """The resources that realization needs, loaded once: skeleton, gesture library, face tables and export rigs."""

    skeleton: Skeleton
    library: Library
    face: FaceTables
    rigs: Mapping[str, Rig]

    @classmethod
    def load(cls, lexicon: Path) -> "Realizer":
        """Load everything from a lexicon folder.

        Raises AuthoringError with all mistakes of the first kind of file that has any.
        """
        return cls.with_library(Library.load(lexicon / "gestures"), lexicon)

    @classmethod
    def with_library(cls, library: Library, lexicon: Path) -> "Realizer":
        """The same with gestures that are loaded already."""
        skeleton = Skeleton.standing()
        return cls(
            skeleton=skeleton,
            library=library,
            face=FaceTables.load(lexicon / "face.yaml"),
            rigs=load_rigs(lexicon / "retarget", skeleton),
        )

    def rig(self, name: str) -> Rig:
        """The rig of this name, with its joint names. Raises InputError `unknown_skeleton`."""
        return find_rig(self.rigs, name)


def realize(realizer: Realizer, schedule: Schedule, *, frame_rate_hz: int = 60, seed: int = 0) -> Motion:
    """The motion of a schedule, from time 0 until the audio is over and the hands are back at rest."""
    plan = plan_gestures(realizer.library, schedule, seed=seed)
    times_s = frame_times_s(max(schedule.duration_s, plan.end_s), frame_rate_hz)
    skeleton = realizer.skeleton
    body = idle_motion(skeleton, times_s, schedule, seed=seed)
    body = apply_gestures(skeleton, body, plan, seed=seed, noise_scale=1 - schedule.stillness)
    body = apply_gaze(skeleton, body, schedule, seed=seed)
    body = apply_head_movements(skeleton, body, schedule, seed=seed)
    body, moved = resolve_collisions(skeleton, body)
    shapes = face_weights(realizer.face, schedule, body, skeleton, seed=seed)
    return Motion(
        frame_rate_hz=frame_rate_hz,
        body=body,
        shapes=shapes,
        realized=_realized(schedule.behaviors, plan, frame_s=1 / frame_rate_hz),
        decisions=(
            *plan.decisions,
            *unplayable_behaviors(schedule),
            *unknown_faces(realizer.face.lexemes, schedule.behaviors),
            *moved,
        ),
        lead_in_s=schedule.lead_in_s,
    )


def frame_times_s(end_s: float, frame_rate_hz: int) -> FloatArray:
    """Times (T,) of the frames, at least two, up to the first one at or after `end_s`."""
    return np.arange(max(2, int(np.ceil(end_s * frame_rate_hz)) + 1)) / frame_rate_hz


def _realized(behaviors: tuple[Behavior, ...], plan: GesturePlan, *, frame_s: float) -> dict[str, SyncPoints]:
    """The sync points as realized: gestures as planned, faces and head movements within their speed limits, everything
    else as scheduled."""
    others = {each.id: each.sync for each in behaviors if each.kind is not Channel.GESTURE}
    return {**others, **realized_faces(behaviors, frame_s), **realized_heads(behaviors), **plan.realized}
