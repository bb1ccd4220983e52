"""Exports USD: the skinned mannequin with blend shapes, its animation, the recording and markers.

Conventions: metres, Y up, facing +Z; time codes are frames from 0, at the motion's rate. `/Understudy` is the SkelRoot
and default prim; below it are `Skeleton`, `Animation`, one mesh for each material, and `Materials`. `Audio` is the
recording where there is one. The custom data `understudy` of the animation has frame rate, events, decisions and, for
each behaviour, a marker that tells function and rule.

Joints are paths, `hips/spine/chest`, in the skeleton's order; rotations are local to the parent as ours are, with the
real part first. In the bind pose no joint is rotated.

Meshes are bound to the skeleton by four influences a vertex; a blend shape has only the vertices that it moves. Colours
are linear, as ours are.
"""

import io
import tempfile
from collections.abc import Mapping, Sequence
from enum import StrEnum
from pathlib import Path, PurePath

import numpy as np
import soundfile
from pxr import Gf, Kind, Sdf, Usd, UsdGeom, UsdMedia, UsdShade, UsdSkel, UsdUtils, Vt

from ...model import Behavior, FloatArray
from ...model.figure import PLAIN, Looks
from ...model.formats import AudioFile
from ..body.motion import SHAPES, Motion
from ..body.skeleton import Skeleton
from ..geometry.rotations import with_continuous_signs
from ..mannequin.carrying import t_pose_m
from ..mannequin.looks import Colour
from ..mannequin.skinning import INFLUENCES, Mannequin, MeshPart, joined
from .animations import events_json, marker

ROOT = "/Understudy"

_PACKED_AUDIO = frozenset({".wav", ".mp3", ".m4a"})
"""What a usdz may hold; other recordings are packed as WAV."""


class UsdForm(StrEnum):
    """As text, in binary, or packed with the recording."""

    TEXT = "usda"
    BINARY = "usdc"
    PACKAGE = "usdz"


def to_usd(
    motion: Motion,
    skeleton: Skeleton,
    form: UsdForm,
    looks: Looks = PLAIN.looks,
    *,
    behaviors: Sequence[Behavior] = (),
    audio: AudioFile | None = None,
) -> bytes:
    """The file; `behaviors` are those that markers tell of. A usdz holds the recording, the others name it."""
    _quiet = UsdUtils.CoalescingDiagnosticDelegate()  # a time code makes USD tell of its file version on standard error
    with tempfile.TemporaryDirectory() as folder:
        layer = Path(folder) / f"understudy.{UsdForm.BINARY if form is UsdForm.PACKAGE else form}"
        if form is UsdForm.PACKAGE and audio:
            audio = _packed(audio, Path(folder))
        _write(layer, motion, Mannequin.around(skeleton, looks), behaviors, audio)
        if form is not UsdForm.PACKAGE:
            return layer.read_bytes()
        package = layer.with_suffix(f".{UsdForm.PACKAGE}")
        UsdUtils.CreateNewUsdzPackage(Sdf.AssetPath(str(layer)), str(package))
        return package.read_bytes()


def _write(
    path: Path, motion: Motion, mannequin: Mannequin, behaviors: Sequence[Behavior], audio: AudioFile | None
) -> None:
    stage = Usd.Stage.CreateNew(str(path))
    _set_conventions(stage, motion)
    root = UsdSkel.Root.Define(stage, ROOT)
    stage.SetDefaultPrim(root.GetPrim())
    Usd.ModelAPI(root).SetKind(Kind.Tokens.component)
    skeleton = define_skeleton(stage, f"{ROOT}/Skeleton", mannequin.skeleton)
    animation = define_animation(stage, f"{ROOT}/Animation", motion, mannequin.skeleton)
    UsdSkel.BindingAPI.Apply(skeleton.GetPrim()).CreateAnimationSourceRel().SetTargets([animation.GetPath()])
    materials = define_materials(stage, f"{ROOT}/Materials", mannequin.colours)
    for part in joined(mannequin.parts):
        define_mesh(stage, f"{ROOT}/{part.material}", part, skeleton, materials[part.material])
    animation.GetPrim().SetCustomDataByKey("understudy", _custom_data(motion, behaviors))
    if audio:
        _define_audio(stage, motion, audio)
    stage.GetRootLayer().Save()


def _set_conventions(stage: Usd.Stage, motion: Motion) -> None:
    UsdGeom.SetStageMetersPerUnit(stage, UsdGeom.LinearUnits.meters)
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    stage.SetTimeCodesPerSecond(motion.frame_rate_hz)
    stage.SetFramesPerSecond(motion.frame_rate_hz)
    stage.SetStartTimeCode(0)
    stage.SetEndTimeCode(len(motion.body.times_s) - 1)


def _custom_data(motion: Motion, behaviors: Sequence[Behavior]) -> dict[str, object]:
    """USD's dictionaries hold no lists of dictionaries: these become dictionaries by number or by id."""
    told = events_json(motion)
    start_s = float(motion.body.times_s[0])
    markers = {each.id: marker(motion, each, start_s) for each in behaviors if each.id in motion.realized}
    return {name: _plain(value) for name, value in {**told, "markers": markers}.items()}


def _plain(value: object) -> object:
    match value:
        case dict():
            return {name: _plain(inside) for name, inside in value.items() if inside is not None}
        case list():
            return {f"_{number}": _plain(inside) for number, inside in enumerate(value)}
        case str():
            return str(value)
    return value


def _define_audio(stage: Usd.Stage, motion: Motion, audio: AudioFile) -> None:
    """The recording, from the frame on with which it begins."""
    sound = UsdMedia.SpatialAudio.Define(stage, f"{ROOT}/Audio")
    sound.CreateFilePathAttr(Sdf.AssetPath(audio.name if audio.name.startswith((".", "/")) else f"./{audio.name}"))
    sound.CreateAuralModeAttr(UsdMedia.Tokens.nonSpatial)
    sound.CreatePlaybackModeAttr(UsdMedia.Tokens.onceFromStart)
    begins_s = motion.lead_in_s - float(motion.body.times_s[0])
    if begins_s:
        sound.CreateStartTimeAttr(Sdf.TimeCode(max(begins_s, 0.0) * motion.frame_rate_hz))
        sound.CreateMediaOffsetAttr(max(-begins_s, 0.0))


def _packed(audio: AudioFile, folder: Path) -> AudioFile:
    """The recording in the folder, in a format that a usdz may hold."""
    path = folder / PurePath(audio.name).name
    if path.suffix.lower() in _PACKED_AUDIO:
        path.write_bytes(audio.content)
        return AudioFile(path.name, audio.content)
    path = path.with_suffix(".wav")
    samples, rate_hz = soundfile.read(io.BytesIO(audio.content), dtype="int16", always_2d=True)
    soundfile.write(path, samples, rate_hz)
    return AudioFile(path.name, b"")


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


GLOSSY = frozenset({"eye_white", "iris", "pupil"})


def define_materials(stage: Usd.Stage, path: str, colours: Mapping[str, Colour]) -> Mapping[str, UsdShade.Material]:
    UsdGeom.Scope.Define(stage, path)
    return {name: _material(stage, f"{path}/{name}", name, colour) for name, colour in colours.items()}


def define_mesh(
    stage: Usd.Stage, path: str, part: MeshPart, skeleton: UsdSkel.Skeleton, material: UsdShade.Material
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


def _define_shapes(stage: Usd.Stage, binding: UsdSkel.BindingAPI, path: str, part: MeshPart) -> None:
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
