"""Gestures as silhouettes: what an audience far away sees at the end of a stroke, and which gestures look alike there.

Two strokes look alike if both wrists are less than `NEAR_M` and both palms less than `NEAR_DEG` apart at the end, and
the hand has the same form. They are twins if that holds where the stroke begins as well: then nothing but the words
tells them apart. An arm that takes no part hangs.

Conventions: metres in the world, facing +Z; rows are the left and the right arm. Fingers of a relaxed, a flat and a
spread hand are not told apart from far away.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from understudy.model import FloatArray, Hand
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.body.skeleton import Skeleton, forward
from understudy.realizer.geometry.rotations import rotate
from understudy.realizer.gestures.gesture import Clip, HandForm
from understudy.realizer.mannequin.skinning import Mannequin, posed
from understudy.realizer.pictures.contact_sheet import (
    BACKGROUND,
    BODY_HEIGHT,
    CAPTION_HEIGHT,
    CELL_WIDTH,
    FRONT,
    THREE_QUARTERS,
    Still,
    display,
    draw_cells,
)
from understudy.realizer.pictures.gesture_sheet import KeyPose, key_poses
from understudy.realizer.pictures.rasterizer import ColouredMesh, draw, joined

NEAR_M, NEAR_DEG = 0.15, 40.0

_SAME_TIME_S = 1e-6
_PALM: FloatArray = np.array([0.0, -1.0, 0.0])
"""The palm's normal in the hand's own axes: down in the T-pose."""
_OPEN_FORMS = frozenset({HandForm.DEFAULT, HandForm.FLAT, HandForm.SPREAD})
_INK: FloatArray = np.array([0.03, 0.03, 0.04])


@dataclass(frozen=True, slots=True, eq=False)
class HandsPose:
    """Where both wrists are (2, 3) and where the palms face (2, 3)."""

    wrists_m: FloatArray
    palms: FloatArray


@dataclass(frozen=True, slots=True, eq=False)
class StrokePose:
    """A clip's pose where its stroke begins and where it ends, and the form of the leading hand; `rotations` (J, 4) are
    those of the whole body at the end."""

    clip: Clip
    begins: HandsPose
    ends: HandsPose
    form: HandForm
    rotations: FloatArray


@dataclass(frozen=True, slots=True)
class Likeness:
    """Two gestures that look alike: how far their wrists and palms are apart at the stroke's end, the wider of both
    hands, and whether their strokes begin alike too."""

    one: str
    other: str
    apart_m: float
    apart_deg: float
    twins: bool


def stroke_pose(skeleton: Skeleton, clip: Clip) -> StrokePose:
    """The pose of a clip at its stroke."""
    poses, markers = key_poses(skeleton, clip), clip.markers
    last = max((each for each in poses if each.key.time_s <= markers.stroke_end + _SAME_TIME_S), key=_time_s)
    first = min((each for each in poses if each.key.time_s >= markers.stroke_start - _SAME_TIME_S), key=_time_s)
    return StrokePose(clip, _hands(skeleton, first), _hands(skeleton, last), _form(clip), last.rotations)


def _time_s(pose: KeyPose) -> float:
    return pose.key.time_s


def _hands(skeleton: Skeleton, pose: KeyPose) -> HandsPose:
    places_m, turns = forward(skeleton, pose.rotations, skeleton.offsets_m[0])
    rows = [skeleton.index[f"{side}Hand"] for side in (Hand.LEFT, Hand.RIGHT)]
    return HandsPose(places_m[rows], rotate(turns[rows], _PALM))


def _form(clip: Clip) -> HandForm:
    """The leading hand's form at the stroke's end; relaxed, flat and spread hands count as relaxed."""
    form = HandForm.DEFAULT
    for key in clip.keys:
        arm = key.left if clip.hand is Hand.LEFT else key.right
        if arm is not None and arm.hand is not None and key.time_s <= clip.markers.stroke_end + _SAME_TIME_S:
            form = arm.hand.form
    return HandForm.DEFAULT if form in _OPEN_FORMS else form


def likenesses(poses: Sequence[StrokePose]) -> Iterator[Likeness]:
    """The pairs that look alike, those of one category too."""
    ends_m, ends_deg = _apart([each.ends for each in poses])
    begins_m, begins_deg = _apart([each.begins for each in poses])
    alike = np.triu(_near(ends_m, ends_deg), k=1)
    twins = _near(begins_m, begins_deg)
    for row, column in np.argwhere(alike):
        one, other = poses[row], poses[column]
        if one.form is other.form:
            apart_m, apart_deg = float(ends_m[row, column]), float(ends_deg[row, column])
            yield Likeness(one.clip.name, other.clip.name, apart_m, apart_deg, bool(twins[row, column]))


def _apart(hands: Sequence[HandsPose]) -> tuple[FloatArray, FloatArray]:
    """How far the wrists (metres) and the palms (degrees) of each two are apart (N, N), the wider of both hands."""
    wrists_m = np.stack([each.wrists_m for each in hands])
    palms = np.stack([each.palms for each in hands])
    away_m = np.linalg.norm(wrists_m[:, None] - wrists_m, axis=-1).max(axis=-1)
    cosines = np.clip(np.einsum("ish,jsh->ijs", palms, palms), -1.0, 1.0)
    return away_m, np.degrees(np.arccos(cosines.min(axis=-1)))


def _near(apart_m: FloatArray, apart_deg: FloatArray) -> NDArray[np.bool_]:
    return np.asarray((apart_m < NEAR_M) & (apart_deg < NEAR_DEG))


def draw_silhouettes(skeleton: Skeleton, poses: Sequence[StrokePose], *, columns: int = 8, named: bool = True) -> bytes:
    """The gestures in black at the ends of their strokes, from the front and three quarters, as PNG;
    their names below them if `named`. Needs matplotlib."""
    mannequin = Mannequin.around(skeleton)
    standing = skeleton.offsets_m[0]
    cells = [silhouette(mannequin, each.rotations, standing) for each in poses]
    stills = [Still(each.clip.name if named else "", each.rotations) for each in poses]
    return draw_cells(cells, stills, columns=columns)


def silhouette(mannequin: Mannequin, rotations: FloatArray, hips_m: FloatArray) -> NDArray[np.uint8]:
    """A body in black from the front and three quarters above each other, and room for a caption, in display values."""
    surfaces = posed(mannequin, rotations, hips_m, np.zeros(len(SHAPES)))
    meshes = (
        ColouredMesh(each.positions_m, each.normals, each.triangles, np.broadcast_to(_INK, each.normals.shape))
        for each in surfaces
    )
    figure = joined(tuple(meshes))
    views = [
        draw(figure, camera, height=BODY_HEIGHT, width=CELL_WIDTH, ground=BACKGROUND)
        for camera in (FRONT, THREE_QUARTERS)
    ]
    caption = np.broadcast_to(BACKGROUND, (CAPTION_HEIGHT, CELL_WIDTH, 3))
    return display(np.concatenate([*views, caption]))
