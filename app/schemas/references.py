"""The file format of a speaker's reference, written by `understudy reference` and read by command line and HTTP API."""

from typing import Annotated, Literal, Self

import numpy as np
from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from ..errors import LONGEST_SHOWN, InputError
from ..model.voice.signal import SpeakerReference

Numbers = Annotated[list[Annotated[float, Field(allow_inf_nan=False)]], Field(min_length=1, max_length=1000)]


class ReferenceForm(BaseModel):
    """Mean and deviation of each feature over `recordings` recordings of one speaker."""

    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid", strict=True)

    features: Literal["paper", "full"]
    recordings: Annotated[int, Field(ge=1, le=1_000_000)]
    mean: Numbers
    deviation: Numbers

    @model_validator(mode="after")
    def _match(self) -> Self:
        if len(self.mean) != len(self.deviation) or min(self.deviation) < 0:
            raise ValueError("mean and deviation must have one number for each feature, no deviation below 0")
        return self

    @classmethod
    def of(cls, reference: SpeakerReference) -> Self:
        return cls.model_validate(
            {
                "features": reference.feature_set,
                "recordings": reference.recordings,
                "mean": reference.mean.tolist(),
                "deviation": reference.deviation.tolist(),
            }
        )

    def to_reference(self) -> SpeakerReference:
        return SpeakerReference(self.features, self.recordings, np.array(self.mean), np.array(self.deviation))


def read_reference(content: bytes, name: str) -> SpeakerReference:
    """The reference in the file `name`. Raises InputError `reference_unreadable`."""
    try:
        return ReferenceForm.model_validate_json(content).to_reference()
    except ValidationError as error:
        found = error.errors()[0]
    where = ".".join(str(part)[:LONGEST_SHOWN] for part in found["loc"]) or "file"
    told = f"{name[:LONGEST_SHOWN]}: not a speaker's reference ({where}: {found['msg']})"
    message = f"{told}; make one with understudy reference"
    raise InputError("reference_unreadable", message, field="reference")


def to_json(reference: SpeakerReference) -> bytes:
    """The reference as a file that `read_reference` reads."""
    return ReferenceForm.of(reference).model_dump_json().encode() + b"\n"
