"""Exports the body as Biovision BVH text.

Conventions (docs/references.md): centimetres, Y up, facing +Z; zero rotation is the T-pose, with the feet on the
ground. The root has six channels, its absolute position and its rotation; each other joint has three. Rotations are Z X
Y in degrees, about the joint's own axes in that order, so R = Rz · Rx · Ry. The first frame is the motion's first,
unless a T-pose comes before it.

Readers differ about the root's OFFSET, which is its place in the T-pose. For Blender and many others its positions are
absolute, and without an offset the body they make stands in the ground to its hips; three.js and others add the two,
and with an offset it floats. The offset is the hips' height, and zero for readers of the second kind if asked.
"""

import io
from collections.abc import Iterator

import numpy as np

from ...model import FloatArray
from ..body.motion import Motion
from ..body.skeleton import FINGERS, Offset, Skeleton
from .fixed_decimals import RowFormat, written_rows
from .retargeting import Rig

CENTIMETRES = 100.0
DECIMALS = 4

CHUNK = 1_000
"""Frames formatted at a time, to limit memory in long motions."""

_ENDS_M: dict[str, Offset] = {
    "head": (0.0, 0.2, 0.0),
    "Eye": (0.0, 0.0, 0.02),
    "Toes": (0.0, 0.0, 0.06),
    "ThumbDistal": (0.02, 0.0, 0.01),
    **{f"{finger}Distal": (0.02, 0.0, 0.0) for finger in FINGERS[1:]},
}


def to_bvh(
    motion: Motion, skeleton: Skeleton, rig: Rig, *, t_pose: bool = False, root_at_origin: bool = False
) -> bytes:
    """The body's motion with the rig's joint names; BVH has no face.

    With `t_pose`, the T-pose is a frame before the motion's first; with `root_at_origin`, the root's OFFSET is zero.
    """
    order = list(_depth_first(skeleton, 0))
    frames = len(motion.body.times_s)
    root_m = np.zeros(3) if root_at_origin else skeleton.offsets_m[0]
    lines = [
        "HIERARCHY",
        *_hierarchy(skeleton, rig, 0, "", root_m),
        "MOTION",
        f"Frames: {frames + t_pose}",
        f"Frame Time: {1 / motion.frame_rate_hz:.10f}",
        "",
    ]
    values = _channels(motion, order)
    row = RowFormat(DECIMALS, between=" ", after="\n")
    content = io.BytesIO()
    content.write("\n".join(lines).encode())
    if t_pose:
        upright = np.concatenate([skeleton.offsets_m[0] * CENTIMETRES, np.zeros(values.shape[1] - 3)])
        content.writelines(written_rows(upright[None, None], row))
    for chunk in np.array_split(values, -(-frames // CHUNK)):
        content.writelines(written_rows(chunk[None], row))
    return content.getvalue()


def zxy_degrees(rotations: FloatArray) -> FloatArray:
    """The angles about Z, X and Y (…, 3) whose product Rz · Rx · Ry is each rotation (…, 4)."""
    x, y, z, w = (rotations[..., k] for k in range(4))
    sine = np.clip(2 * (y * z + w * x), -1.0, 1.0)
    angles = [
        np.arctan2(2 * (w * z - x * y), 1 - 2 * (x * x + z * z)),
        np.arcsin(sine),
        np.arctan2(2 * (w * y - x * z), 1 - 2 * (x * x + y * y)),
    ]
    locked = np.abs(sine) > 1 - 1e-9
    angles[0] = np.where(locked, 2 * np.arctan2(z, w), angles[0])
    angles[2] = np.where(locked, 0.0, angles[2])
    return np.asarray(np.degrees(np.stack(angles, axis=-1)))


def _channels(motion: Motion, order: list[int]) -> FloatArray:
    """The values of the MOTION section, one row per frame. Angles are unwrapped past 180° so that curves are
    continuous."""
    values = np.empty((len(motion.body.times_s), 3 + 3 * len(order)))
    values[:, :3] = motion.body.hips_m * CENTIMETRES
    for place, joint in enumerate(order):
        angles = np.unwrap(zxy_degrees(motion.body.rotations[:, joint]), period=360, axis=0)
        values[:, 3 + 3 * place : 6 + 3 * place] = angles
    return values


def _depth_first(skeleton: Skeleton, joint: int) -> Iterator[int]:
    yield joint
    for child in _children(skeleton, joint):
        yield from _depth_first(skeleton, child)


def _children(skeleton: Skeleton, joint: int) -> list[int]:
    return [child for child, parent in enumerate(skeleton.parents) if parent == joint]


def _hierarchy(skeleton: Skeleton, rig: Rig, joint: int, indent: str, root_m: FloatArray) -> Iterator[str]:
    root = skeleton.parents[joint] < 0
    offset = root_m if root else skeleton.offsets_m[joint]
    channels = "6 Xposition Yposition Zposition" if root else "3"
    yield f"{indent}{'ROOT' if root else 'JOINT'} {rig.names[skeleton.names[joint]]}"
    yield f"{indent}{{"
    yield f"{indent}\t{_offset(offset)}"
    yield f"{indent}\tCHANNELS {channels} Zrotation Xrotation Yrotation"
    children = _children(skeleton, joint)
    for child in children:
        yield from _hierarchy(skeleton, rig, child, indent + "\t", root_m)
    if not children:
        end = _end_m(skeleton.names[joint])
        yield from (f"{indent}\tEnd Site", f"{indent}\t{{", f"{indent}\t\t{_offset(end)}", f"{indent}\t}}")
    yield f"{indent}}}"


def _end_m(joint: str) -> Offset:
    """The end of the last bone of a chain."""
    x, y, z = _ENDS_M[joint.removeprefix("left").removeprefix("right")]
    return (-x if joint.startswith("right") else x, y, z)


def _offset(offset_m: FloatArray | Offset) -> str:
    x, y, z = (float(part) * CENTIMETRES + 0.0 for part in offset_m)
    return f"OFFSET {x:.{DECIMALS}f} {y:.{DECIMALS}f} {z:.{DECIMALS}f}"
