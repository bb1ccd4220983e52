"""The clip that `POST /realize` answers as JSON, described for clients; `understudy.realizer.exporting.clip_json`
writes it track by track, and docs/motion-formats.md explains it."""

from typing import Annotated, Literal

from pydantic import Field

from .line_parts import WarningResponse
from .response_model import ResponseModel

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
