"""The mannequin's meshes, blend shapes and materials in USD.

One mesh for each material, bound to the skeleton by four influences a vertex; a blend shape has only the vertices that
it moves. Colours are linear, as ours are.
"""

from collections.abc import Mapping

import numpy as np
from pxr import Sdf, Usd, UsdGeom, UsdShade, UsdSkel, Vt

from ....model import FloatArray
from ...mannequin.colours import Colour
from ...mannequin.mannequin import INFLUENCES, Part

GLOSSY = frozenset({"eye_white", "iris", "pupil"})


def define_materials(stage: Usd.Stage, path: str, colours: Mapping[str, Colour]) -> Mapping[str, UsdShade.Material]:
    UsdGeom.Scope.Define(stage, path)
    return {name: _material(stage, f"{path}/{name}", name, colour) for name, colour in colours.items()}


def define_mesh(
    stage: Usd.Stage, path: str, part: Part, skeleton: UsdSkel.Skeleton, material: UsdShade.Material
) -> UsdGeom.Mesh:
    """The surface of a part, triangles that are not subdivided."""
    surface = part.surface
    mesh = UsdGeom.Mesh.Define(stage, path)
    points = _vectors(surface.positions_m)
    mesh.CreatePointsAttr(points)
    mesh.CreateNormalsAttr(_vectors(surface.normals))
    mesh.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
    mesh.CreateFaceVertexCountsAttr(Vt.IntArray(len(surface.triangles), 3))
    mesh.CreateFaceVertexIndicesAttr(_integers(surface.triangles.ravel()))
    mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
    mesh.CreateExtentAttr(UsdGeom.PointBased.ComputeExtent(points))
    UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(material)
    binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets([skeleton.GetPath()])
    joints = np.where(part.weights > 0, part.joints, 0)
    binding.CreateJointIndicesPrimvar(constant=False, elementSize=INFLUENCES).Set(_integers(joints.ravel()))
    weights = Vt.FloatArray.FromNumpy(part.weights.astype(np.float32).ravel())
    binding.CreateJointWeightsPrimvar(constant=False, elementSize=INFLUENCES).Set(weights)
    _define_shapes(stage, binding, path, part)
    return mesh


def _define_shapes(stage: Usd.Stage, binding: UsdSkel.BindingAPI, path: str, part: Part) -> None:
    """A blend shape for each of ARKit's that moves the part; ours for visemes are mixtures of these."""
    moving = {name: offsets_m for name, offsets_m in part.shapes.items() if not name.startswith("viseme_")}
    for name, offsets_m in moving.items():
        moved = np.flatnonzero(np.any(offsets_m != 0, axis=1))
        shape = UsdSkel.BlendShape.Define(stage, f"{path}/{name}")
        shape.CreateOffsetsAttr(_vectors(offsets_m[moved]))
        shape.CreatePointIndicesAttr(_integers(moved))
    if moving:
        binding.CreateBlendShapesAttr(list(moving))
        binding.CreateBlendShapeTargetsRel().SetTargets([Sdf.Path(f"{path}/{name}") for name in moving])


def _material(stage: Usd.Stage, path: str, name: str, colour: Colour) -> UsdShade.Material:
    material = UsdShade.Material.Define(stage, path)
    shader = UsdShade.Shader.Define(stage, f"{path}/Surface")
    shader.CreateIdAttr("UsdPreviewSurface")
    shader.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f).Set(colour)
    shader.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(0.35 if name in GLOSSY else 0.8)
    material.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
    return material


def _vectors(values: FloatArray) -> Vt.Vec3fArray:
    return Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(values, dtype=np.float32))


def _integers(values: np.ndarray[tuple[int], np.dtype[np.integer]]) -> Vt.IntArray:
    return Vt.IntArray.FromNumpy(np.ascontiguousarray(values, dtype=np.int32))
