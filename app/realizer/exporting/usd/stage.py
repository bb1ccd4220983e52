"""Exports USD: the skinned mannequin with blend shapes, its animation, the recording and markers.

Conventions: metres, Y up, facing +Z; time codes are frames from 0, at the motion's rate. `/Understudy` is the SkelRoot
and default prim; below it are `Skeleton`, `Animation`, one mesh for each material, and `Materials`. `Audio` is the
recording where there is one. The custom data `understudy` of the animation has frame rate, events, decisions and, for
each behaviour, a marker that tells function and rule.
"""

import io
import tempfile
from collections.abc import Sequence
from enum import StrEnum
from pathlib import Path, PurePath

import soundfile
from pxr import Kind, Sdf, Usd, UsdGeom, UsdMedia, UsdSkel, UsdUtils

from ....model import Behavior
from ....model.figure import PLAIN, Looks
from ....model.formats.motion_formats import AudioFile
from ...body.motion import Motion
from ...body.skeleton import Skeleton
from ...mannequin.mannequin import Mannequin, joined
from ..animations import marker
from ..events import events_json
from .meshes import define_materials, define_mesh
from .skeletons import define_animation, define_skeleton

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
