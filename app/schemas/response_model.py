"""The common base of all JSON responses.

A key is absent if there is no value. Numbers are rounded to `DECIMALS`, so that equal values give equal bytes on all
platforms. Most models read attributes of the same name: `PhraseResponse.model_validate(phrase)`.
"""

from typing import Annotated

from pydantic import AfterValidator, BaseModel, BeforeValidator, ConfigDict
from pydantic.config import JsonDict

from ..model import SyncPoints

DECIMALS = 6


def _rounded(number: float) -> float:
    return round(number, DECIMALS) + 0.0  # adding zero turns -0.0, which is written "-0.0", into 0.0


def _set_points(sync: SyncPoints) -> dict[str, float]:
    return dict(sync.in_order())


Number = Annotated[float, AfterValidator(_rounded)]
Times = Annotated[dict[str, Number], BeforeValidator(_set_points)]


def _open(schema: JsonDict) -> None:
    """Permits further fields in the schema, so that adding one breaks no client."""
    schema.pop("additionalProperties", None)


class ResponseModel(BaseModel):
    """Base class of all responses."""

    model_config = ConfigDict(
        defer_build=True, frozen=True, extra="forbid", from_attributes=True, json_schema_extra=_open
    )

    def to_json(self, indent: int | None = None) -> bytes:
        """The response as UTF-8 JSON without a final line break; on one line unless `indent` is given."""
        return self.model_dump_json(by_alias=True, exclude_none=True, indent=indent).encode()
