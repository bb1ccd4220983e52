"""The clip that `POST /realize` answers as JSON, described for clients; `understudy.realizer.exporting.clip_json`
writes it track by track, and docs/motion-formats.md explains it.

Request and response for reading a pose from an avatar's file.
"""

from typing import Annotated, Literal, Self

from pydantic import BaseModel, ConfigDict, Field

from ..model import Hand
from ..realizer.avatars.pose import AvatarPose
from .line_parts import WarningResponse
from .requests import checked, read_object
from .response_model import Number, ResponseModel

Vector = Annotated[list[float], Field(min_length=3, max_length=3, description="x, y, z")]
Quaternion = Annotated[list[float], Field(min_length=4, max_length=4, description="x, y, z, w")]
Weights = dict[str, list[float]]


class JointResponse(ResponseModel):
    """A joint in the T-pose; `offset_m` is its position relative to its parent, that of the hips in the world."""

    name: str
    parent: str | None
    offset_m: Vector


class SkeletonResponse(ResponseModel):
    """The joints of the rig."""

    name: str
    unit_m: float
    up: str
    forward: str
    rest: str
    joints: list[JointResponse]


class EventResponse(ResponseModel):
    """The time at which a sync point was realized."""

    behavior: str
    point: str
    time_s: float


class DecisionResponse(ResponseModel):
    """Something that was dropped, replaced or held, and why."""

    behavior: str | None
    action: str
    reason: str


class ClipResponse(ResponseModel):
    """A clip: tracks by joint and by blendshape, one value per frame, or a single one where it is constant."""

    format: Literal["understudy-clip"]
    version: int
    skeleton: SkeletonResponse
    frames: int
    duration_s: float
    frame_rate_hz: int
    audio_offset_s: float
    events: list[EventResponse]
    decisions: list[DecisionResponse]
    notices: list[WarningResponse]
    hips_m: list[Vector]
    bones: dict[str, list[Quaternion]]
    blendshapes: Weights
    visemes: Weights | None = None


class AvatarPoseOptions(BaseModel):
    """Which pose to read from a file with animations: by default the beginning of the first animation."""

    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", strict=True, allow_inf_nan=False)

    animation: Annotated[str | None, Field(description="Its name in the file.")] = None
    time_s: Annotated[float, Field(description="Seconds from the animation's beginning.")] = 0.0


class AvatarPoseResponse(ResponseModel):
    """The joints of each arm that are turned, as `JOINT` has them: degrees about x, y and z, for the left arm; those of
    the right are mirrored. `missing` are joints that the avatar does not have."""

    file: str
    animation: str | None = None
    animations: list[str]
    time_s: Number
    arms: dict[Hand, dict[str, tuple[Number, Number, Number]]]
    missing: list[str]

    @classmethod
    def of(cls, pose: AvatarPose, file: str, time_s: float) -> Self:
        return cls(
            file=file,
            animation=pose.animation,
            animations=list(pose.animations),
            time_s=time_s,
            arms={side: dict(joints) for side, joints in pose.arms.items()},
            missing=list(pose.missing),
        )


def read_pose_options(content: bytes) -> AvatarPoseOptions:
    """The options. Raises UndecodableError `not_json`, InputError `not_an_object`, `value_wrong`."""
    return checked(AvatarPoseOptions, read_object(content, "options"))
