"""Request and response for reading a pose from an avatar's file."""

from typing import Annotated, Self

from pydantic import BaseModel, ConfigDict, Field

from ..model import Hand
from ..realizer.exporting.avatars.pose import AvatarPose
from .requests import checked, read_object
from .response_model import Number, ResponseModel


class AvatarPoseOptions(BaseModel):
    """Which pose to read from a file with animations: by default the beginning of the first animation."""

    model_config = ConfigDict(frozen=True, extra="forbid", strict=True, allow_inf_nan=False)

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
