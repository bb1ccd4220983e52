"""USD as Pixar's own library reads it back."""

import io
import zipfile
from pathlib import Path

import numpy as np
import pytest
import soundfile

pytest.importorskip("pxr", reason="usd-core is not installed: pip install 'understudy[usd]'")

from pxr import Usd, UsdGeom, UsdMedia, UsdShade, UsdSkel, UsdValidation

from tests.support.motion.hand_made_motion import BODY, waving
from understudy.model import Behavior, Channel, FloatArray, SyncPoints
from understudy.model.formats import AudioFile
from understudy.realizer.body.motion import SHAPES, Motion
from understudy.realizer.body.skeleton import forward
from understudy.realizer.exporting.usd import ROOT, UsdForm, to_usd
from understudy.realizer.mannequin.skinning import Mannequin, joined, posed

MOTION = waving(0.5, 60)
FRAME = 20


def audio(name: str = "line.wav") -> AudioFile:
    content = io.BytesIO()
    soundfile.write(content, np.zeros(800), 16_000, format=Path(name).suffix.removeprefix("."))
    return AudioFile(name, content.getvalue())


def opened(folder: Path, form: UsdForm = UsdForm.BINARY, motion: Motion = MOTION, **given: object) -> Usd.Stage:
    """The stage, with its recording beside it."""
    path = folder / f"motion.{form}"
    path.write_bytes(to_usd(motion, BODY, form, **given))  # type: ignore[arg-type]
    return Usd.Stage.Open(str(path))


def skeleton_query(stage: Usd.Stage) -> tuple[UsdSkel.Cache, UsdSkel.SkeletonQuery]:
    cache = UsdSkel.Cache()
    root = UsdSkel.Root(stage.GetPrimAtPath(ROOT))
    cache.Populate(root, Usd.PrimDefaultPredicate)
    return cache, cache.GetSkelQuery(UsdSkel.Skeleton(stage.GetPrimAtPath(f"{ROOT}/Skeleton")))


def joints_m(query: UsdSkel.SkeletonQuery, frame: int) -> FloatArray:
    return np.array([list(one.ExtractTranslation()) for one in query.ComputeJointSkelTransforms(frame)])


@pytest.mark.parametrize("form", UsdForm)
def test_no_validator_finds_a_mistake(tmp_path: Path, form: UsdForm) -> None:
    (tmp_path / "line.wav").write_bytes(audio().content)
    stage = opened(tmp_path, form, audio=audio())
    validators = UsdValidation.ValidationRegistry().GetOrLoadAllValidators()
    assert len(validators) > 20
    found = UsdValidation.ValidationContext(validators).Validate(stage)
    assert [error.GetErrorAsString() for error in found] == []


@pytest.mark.parametrize("form", UsdForm)
def test_joints_are_where_our_kinematics_has_them(tmp_path: Path, form: UsdForm) -> None:
    stage = opened(tmp_path, form)
    _cache, query = skeleton_query(stage)
    ours, _turns = forward(BODY, MOTION.body.rotations, MOTION.body.hips_m)
    assert len(query.GetJointOrder()) == len(BODY.names)
    for frame in (0, FRAME, len(ours) - 1):
        assert np.abs(joints_m(query, frame) - ours[frame]).max() < 1e-5


def test_units_axes_and_frames_are_stated(tmp_path: Path) -> None:
    stage = opened(tmp_path)
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    assert UsdGeom.GetStageUpAxis(stage) == UsdGeom.Tokens.y
    assert (stage.GetStartTimeCode(), stage.GetEndTimeCode()) == (0, len(MOTION.body.times_s) - 1)
    assert (stage.GetTimeCodesPerSecond(), stage.GetFramesPerSecond()) == (60, 60)
    assert stage.GetDefaultPrim().GetPath() == ROOT


def test_the_skin_moves_as_the_mannequin_does(tmp_path: Path) -> None:
    stage = opened(tmp_path)
    cache, query = skeleton_query(stage)
    mannequin = Mannequin.around(BODY)
    still = np.zeros(len(SHAPES))
    ours = posed(mannequin, MOTION.body.rotations[FRAME], MOTION.body.hips_m[FRAME], still)
    by_material = [(part.material, surface) for part, surface in zip(mannequin.parts, ours, strict=True)]
    for part in joined(mannequin.parts):
        mesh = UsdGeom.Mesh(stage.GetPrimAtPath(f"{ROOT}/{part.material}"))
        skinning = cache.GetSkinningQuery(mesh.GetPrim())
        points = mesh.GetPointsAttr().Get()
        assert skinning.ComputeSkinnedPoints(query.ComputeSkinningTransforms(FRAME), points, FRAME)
        expected = np.concatenate([surface.positions_m for name, surface in by_material if name == part.material])
        assert np.abs(np.array(points) - expected).max() < 1e-4


def test_the_face_has_its_shapes_and_their_weights(tmp_path: Path) -> None:
    stage = opened(tmp_path)
    animation = UsdSkel.Animation(stage.GetPrimAtPath(f"{ROOT}/Animation"))
    assert list(animation.GetBlendShapesAttr().Get()) == list(SHAPES)
    weights = np.array(animation.GetBlendShapeWeightsAttr().Get(FRAME))
    assert np.abs(weights - MOTION.shapes[FRAME]).max() < 1e-6
    assert weights.max() > 0
    skin = next(part for part in joined(Mannequin.around(BODY).parts) if part.material == "skin")
    shape = UsdSkel.BlendShape(stage.GetPrimAtPath(f"{ROOT}/skin/jawOpen"))
    offsets = np.zeros_like(skin.surface.positions_m)
    offsets[np.array(shape.GetPointIndicesAttr().Get())] = np.array(shape.GetOffsetsAttr().Get())
    assert np.abs(offsets - skin.shapes["jawOpen"]).max() < 1e-6


def test_each_material_is_bound_with_its_colour(tmp_path: Path) -> None:
    stage = opened(tmp_path)
    mannequin = Mannequin.around(BODY)
    for material in {part.material for part in mannequin.parts}:
        bound, _relationship = UsdShade.MaterialBindingAPI(
            stage.GetPrimAtPath(f"{ROOT}/{material}")
        ).ComputeBoundMaterial()
        shader = UsdShade.Shader(stage.GetPrimAtPath(bound.GetPath().AppendChild("Surface")))
        assert tuple(shader.GetInput("diffuseColor").Get()) == pytest.approx(mannequin.colours[material], abs=1e-6)


def test_markers_tell_function_and_rule(tmp_path: Path) -> None:
    nod = Behavior(
        "wave", Channel.GESTURE, "GREETING", SyncPoints(0.1, 0.9), 0, 1, 1.0, rule="wave_hello", function="greeting1"
    )
    realized = {"wave": SyncPoints(start=0.1, ready=0.2, stroke=0.3, relax=0.4, end=0.5)}
    motion = Motion(60, MOTION.body, MOTION.shapes, realized)
    stage = opened(tmp_path, UsdForm.TEXT, motion, behaviors=[nod])
    told = stage.GetPrimAtPath(f"{ROOT}/Animation").GetCustomDataByKey("understudy")
    assert told["frame_rate_hz"] == 60
    marker = told["markers"]["wave"]
    assert (marker["function"], marker["rule"], marker["lexeme"]) == ("greeting1", "wave_hello", "GREETING")
    assert marker["points_s"]["stroke"] == 0.3
    assert told["events"]["_2"] == {"behavior": "wave", "point": "stroke", "time_s": 0.3}


@pytest.mark.parametrize(("lead_in_s", "begins_at"), [(0.0, 0.0), (0.2, 12.0)])
def test_the_recording_begins_with_its_frame(tmp_path: Path, lead_in_s: float, begins_at: float) -> None:
    motion = Motion(60, MOTION.body, MOTION.shapes, {}, lead_in_s=lead_in_s)
    stage = opened(tmp_path, UsdForm.TEXT, motion, audio=audio())
    sound = UsdMedia.SpatialAudio(stage.GetPrimAtPath(f"{ROOT}/Audio"))
    assert sound.GetFilePathAttr().Get().path == "./line.wav"
    assert float(sound.GetStartTimeAttr().Get().GetValue()) == begins_at


@pytest.mark.parametrize("name", ["line.wav", "takes/line.flac"])
def test_a_package_holds_the_recording_as_wav(tmp_path: Path, name: str) -> None:
    opened(tmp_path, UsdForm.PACKAGE, audio=audio(name))
    with zipfile.ZipFile(tmp_path / "motion.usdz") as package:
        (packed,) = [entry for entry in package.namelist() if entry.endswith(".wav")]
        samples, rate_hz = soundfile.read(io.BytesIO(package.read(packed)))
        assert all(entry.compress_type == zipfile.ZIP_STORED for entry in package.infolist())
    assert (len(samples), rate_hz) == (800, 16_000)
