"""The skeleton and its animation in USD, with the blend-shape weights (UsdSkel).

Joints are paths, `hips/spine/chest`, in the skeleton's order; rotations are local to the parent as ours are, with the
real part first. In the bind pose no joint is rotated.
"""

import numpy as np
from pxr import Gf, Usd, UsdSkel, Vt

from ....model import FloatArray
from ...body.motion import SHAPES, Motion
from ...body.skeleton import Skeleton
from ...geometry.rotations import with_continuous_signs
from ...mannequin.carrying import t_pose_m


def joint_paths(skeleton: Skeleton) -> list[str]:
    """The path of each joint from the hips on."""
    paths: list[str] = []
    for name, parent in zip(skeleton.names, skeleton.parents, strict=True):
        paths.append(name if parent < 0 else f"{paths[parent]}/{name}")
    return paths


def define_skeleton(stage: Usd.Stage, path: str, skeleton: Skeleton) -> UsdSkel.Skeleton:
    defined = UsdSkel.Skeleton.Define(stage, path)
    defined.CreateJointsAttr(joint_paths(skeleton))
    defined.CreateBindTransformsAttr(_translations(t_pose_m(skeleton)))
    defined.CreateRestTransformsAttr(_translations(skeleton.offsets_m))
    return defined


def define_animation(stage: Usd.Stage, path: str, motion: Motion, skeleton: Skeleton) -> UsdSkel.Animation:
    """A key in every frame; joints other than the hips keep their places in their parents."""
    animation = UsdSkel.Animation.Define(stage, path)
    animation.CreateJointsAttr(joint_paths(skeleton))
    animation.CreateBlendShapesAttr(list(SHAPES))
    animation.CreateScalesAttr(Vt.Vec3hArray([Gf.Vec3h(1, 1, 1)] * len(skeleton.names)))
    rotations, translations = animation.CreateRotationsAttr(), animation.CreateTranslationsAttr()
    weights = animation.CreateBlendShapeWeightsAttr()
    offsets_m = np.array(skeleton.offsets_m, dtype=np.float32)
    turns = np.stack([with_continuous_signs(joint) for joint in np.swapaxes(motion.body.rotations, 0, 1)], axis=1)
    for frame, (turn, hips_m, shapes) in enumerate(zip(turns, motion.body.hips_m, motion.shapes, strict=True)):
        offsets_m[0] = hips_m
        rotations.Set(Vt.QuatfArray([Gf.Quatf(w, x, y, z) for x, y, z, w in turn.tolist()]), frame)
        translations.Set(Vt.Vec3fArray.FromNumpy(offsets_m), frame)
        weights.Set(Vt.FloatArray.FromNumpy(np.clip(shapes, 0.0, 1.0).astype(np.float32)), frame)
    return animation


def _translations(places_m: FloatArray) -> Vt.Matrix4dArray:
    return Vt.Matrix4dArray([Gf.Matrix4d(1).SetTranslate(Gf.Vec3d(*map(float, place))) for place in places_m])
