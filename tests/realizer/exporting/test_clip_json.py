"""The clip JSON keeps to its schema, which is written here once more, and holds the motion."""

from pathlib import Path
from typing import Annotated, Literal

import numpy as np
import pytest
from pydantic import BaseModel, ConfigDict, Field

from tests.support.motion.hand_made_motion import BODY, waving
from understudy.realizer.body.motion import SHAPES
from understudy.realizer.exporting.clip_json import to_clip_json
from understudy.realizer.exporting.retargeting import load_rigs
from understudy.realizer.face.face_tables import VISEMES

RIGS = load_rigs(Path(__file__).parents[3] / "lexicon" / "retarget", BODY)
MOTION = waving()
FRAMES = len(MOTION.body.times_s)

Triple = tuple[float, float, float]
Quaternion = tuple[float, float, float, float]
Weight = Annotated[float, Field(ge=0, le=1)]


class Strict(BaseModel):
    model_config = ConfigDict(extra="forbid", strict=True)


class Joint(Strict):
    name: str
    parent: str | None
    offset_m: list[float] = Field(min_length=3, max_length=3)


class SkeletonPart(Strict):
    name: str
    unit_m: float
    up: Literal["+Y"]
    forward: Literal["+Z"]
    rest: Literal["T-pose"]
    joints: list[Joint]


class EventPart(Strict):
    behavior: str
    point: Literal["start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end"]
    time_s: float


class DecisionPart(Strict):
    behavior: str
    action: str
    reason: str


class NoticePart(Strict):
    code: str
    message: str


class ClipFile(Strict):
    format: Literal["understudy-clip"]
    version: Literal[1]
    skeleton: SkeletonPart
    frame_rate_hz: int
    frames: int
    duration_s: float
    audio_offset_s: float
    events: list[EventPart]
    decisions: list[DecisionPart]
    notices: list[NoticePart]
    hips_m: list[list[float]]
    bones: dict[str, list[list[float]]]
    blendshapes: dict[str, list[Weight]]
    visemes: dict[str, list[Weight]] | None = None


def clip(rig: str = "vrm") -> ClipFile:
    return ClipFile.model_validate_json(to_clip_json(MOTION, BODY, RIGS[rig]))


def test_it_keeps_to_its_schema_and_has_every_joint_and_shape() -> None:
    found = clip()
    assert list(found.bones) == list(BODY.names) == [joint.name for joint in found.skeleton.joints]
    assert tuple(found.blendshapes) == SHAPES
    assert (found.frames, found.frame_rate_hz, found.audio_offset_s) == (FRAMES, 30, 0)


def test_tracks_have_a_value_a_frame_or_one_for_all() -> None:
    found = clip()
    assert {len(track) for track in found.bones.values()} == {1, FRAMES}
    assert {len(track) for track in found.blendshapes.values()} == {1, FRAMES}
    assert found.bones["rightLowerArm"] == pytest.approx(
        MOTION.body.rotations[:, BODY.index["rightLowerArm"]], abs=1e-5
    )
    assert found.blendshapes["jawOpen"] == pytest.approx(MOTION.shapes[:, SHAPES.index("jawOpen")], abs=1e-4)
    assert found.blendshapes["mouthSmileLeft"] == [0.5]
    assert np.array(found.hips_m) == pytest.approx(MOTION.body.hips_m, abs=1e-4)


def test_events_have_bml_ids() -> None:
    found = clip()
    assert [event.point for event in found.events] == [
        "start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end",
    ]  # fmt: skip
    assert {event.behavior for event in found.events} == {"wave1"}
    assert found.decisions[0].action == "dropped"


def test_other_rigs_rename_joints_and_their_parents() -> None:
    found = clip("unreal")
    forearm = next(joint for joint in found.skeleton.joints if joint.name == "lowerarm_r")
    assert forearm.parent == "upperarm_r"
    assert found.bones["lowerarm_r"] == clip().bones["rightLowerArm"]


def test_viseme_weights_go_along_if_they_are_given() -> None:
    weights = np.zeros((FRAMES, len(VISEMES)))
    weights[3, VISEMES.index("PP")] = 1.0
    found = ClipFile.model_validate_json(to_clip_json(MOTION, BODY, RIGS["vrm"], visemes=weights))
    assert found.visemes is not None
    assert list(found.visemes) == [
        "sil",
        "PP",
        "FF",
        "TH",
        "DD",
        "kk",
        "CH",
        "SS",
        "nn",
        "RR",
        "aa",
        "E",
        "I",
        "O",
        "U",
    ]
    assert found.visemes["PP"][3] == 1
    assert found.visemes["aa"] == [0]
    assert clip().visemes is None
