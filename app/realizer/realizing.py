"""BML in, motion out, in the order of the paper's controllers (§3.8): the whole body first, the eyelids last.

Each controller takes the body's motion so far and gives it back changed: gestures and gaze override the joints that
they move, head movements are added to what is there, and what would go through the body is moved out of it at the end.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..model import Behavior, Channel, FloatArray, Schedule, SyncPoints
from .arms.collisions import clear
from .body.motion import Motion
from .body.skeleton import Skeleton
from .exporting.retargeting import Rig, find_rig, load_rigs
from .face.expressions import realized_faces, unknown_faces
from .face.face import face
from .face.face_tables import FaceTables
from .gestures.gesture_plan import GesturePlan
from .gestures.library import Library
from .head_and_gaze.gaze import gaze
from .head_and_gaze.head import head
from .scheduling.gesturing import gesture
from .scheduling.planning import plan_gestures
from .scheduling.unplayed import unplayed
from .torso.idle import idle


@dataclass(frozen=True, slots=True, eq=False)
class Realizer:
    """What realizing needs, loaded once: the body, its gestures and its face."""

    skeleton: Skeleton
    library: Library
    face: FaceTables
    rigs: Mapping[str, Rig]

    @classmethod
    def load(cls, lexicon: Path) -> "Realizer":
        """From a lexicon folder. Raises AuthoringError with every mistake in the first kind of file that has any."""
        skeleton = Skeleton.standing()
        return cls(
            skeleton=skeleton,
            library=Library.load(lexicon / "gestures"),
            face=FaceTables.load(lexicon / "face.yaml"),
            rigs=load_rigs(lexicon / "retarget", skeleton),
        )

    def rig(self, name: str) -> Rig:
        """The joints' names in a rig; raises InputError `unknown_skeleton`."""
        return find_rig(self.rigs, name)


def realize(realizer: Realizer, schedule: Schedule, *, frame_rate_hz: int = 60, seed: int = 0) -> Motion:
    """The motion of a schedule, from 0 until it is over and the hands are at rest."""
    plan = plan_gestures(realizer.library, schedule, seed=seed)
    times_s = frame_times_s(max(schedule.duration_s, plan.end_s), frame_rate_hz)
    skeleton = realizer.skeleton
    body = idle(skeleton, times_s, schedule, seed=seed)
    body = gesture(skeleton, body, plan, seed=seed, life=1 - schedule.stillness)
    body = gaze(skeleton, body, schedule, seed=seed)
    body = head(skeleton, body, schedule, seed=seed)
    body, moved = clear(skeleton, body)
    shapes = face(realizer.face, schedule, body, skeleton, seed=seed)
    return Motion(
        frame_rate_hz=frame_rate_hz,
        body=body,
        shapes=shapes,
        realized=_realized(schedule.behaviors, plan, frame_s=1 / frame_rate_hz),
        decisions=(
            *plan.decisions,
            *unplayed(schedule),
            *unknown_faces(realizer.face.words, schedule.behaviors),
            *moved,
        ),
        lead_in_s=schedule.lead_in_s,
    )


def frame_times_s(end_s: float, frame_rate_hz: int) -> FloatArray:
    """The times of the frames, two at least, until the first that is not before `end_s`."""
    return np.arange(max(2, int(np.ceil(end_s * frame_rate_hz)) + 1)) / frame_rate_hz


def _realized(behaviors: tuple[Behavior, ...], plan: GesturePlan, *, frame_s: float) -> dict[str, SyncPoints]:
    """When everything really happens: gestures as planned, faces as fast as they can, all else as scheduled."""
    others = {each.id: each.sync for each in behaviors if each.kind is not Channel.GESTURE}
    return {**others, **realized_faces(behaviors, frame_s), **plan.realized}
