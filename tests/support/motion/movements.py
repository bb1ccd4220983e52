"""Schedules and bodies for the controllers' tests."""

import numpy as np

from understudy.model import Behavior, Channel, FloatArray, Schedule, SyncPoints
from understudy.realizer.body.motion import BodyMotion
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.head_and_gaze.gaze import EYES, Face, chest, face, fixation_point_m

BODY = Skeleton.standing()

TIMES_S: FloatArray = np.arange(0, 6 * 60) / 60


def behavior(kind: Channel, lexeme: str, *times_s: float, **changes: object) -> Behavior:
    """A behaviour from `times_s`: start and end, or start, ready, relax and end, or all seven points."""
    names = {
        2: ("start", "end"),
        4: ("start", "ready", "relax", "end"),
        7: ("start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end"),
    }[len(times_s)]
    sync = SyncPoints(**dict(zip(names, times_s, strict=True)))
    return Behavior(f"{lexeme} {times_s}", kind, lexeme, sync, 0, 0, 1.0, **changes)  # type: ignore[arg-type]


def faced(body: BodyMotion) -> Face:
    """Head and eyes in the world."""
    neck, head = (body.rotations[:, joint] for joint in BODY.chain("neck", "head"))
    return face(BODY, chest(BODY, body.rotations, body.hips_m), neck, head)


def seen_by(body: BodyMotion) -> FloatArray:
    """The points (T, 3) that the eyes look at."""
    return fixation_point_m(faced(body), body.rotations[:, BODY.chain(*EYES)])


def schedule(*behaviors: Behavior) -> Schedule:
    return Schedule(behaviors, 6.0)
