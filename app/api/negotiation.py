"""Content negotiation by the Accept header (RFC 9110 §12.5.1)."""

from collections.abc import Mapping, Sequence
from types import MappingProxyType

from ..errors import NotAcceptableError
from ..model.formats import MotionFormat

XML = "application/xml"
JSON = "application/json"
GLB = "model/gltf-binary"
BVH = "text/x-bvh"
MOTION_TYPES: Mapping[str, MotionFormat] = MappingProxyType(
    {
        JSON: MotionFormat.JSON,
        GLB: MotionFormat.GLB,
        BVH: MotionFormat.BVH,
        "model/vnd.usda": MotionFormat.USDA,
        "model/vnd.usdz+zip": MotionFormat.USDZ,
        "application/vnd.pixar.opentimelineio+json": MotionFormat.OTIO,
        "text/praat-textgrid": MotionFormat.TEXTGRID,
        "text/x-eaf+xml": MotionFormat.EAF,
        "text/csv": MotionFormat.EVENTS,
        "model/vnd.vrm-animation": MotionFormat.VRMA,
        "model/vnd.usdc": MotionFormat.USDC,
        "application/vnd.autodesk.fbx": MotionFormat.FBX,
        "text/x-arkit-csv": MotionFormat.CSV,
        "text/x-visemes": MotionFormat.VISEMES,
        "text/x-bap": MotionFormat.BAP,
        "text/x-fap": MotionFormat.FAP,
    }
)
"""The media types of motion; the first is the default."""
GESTURE_TYPES: Mapping[str, MotionFormat] = MappingProxyType({name: MOTION_TYPES[name] for name in (JSON, GLB, BVH)})
"""The media types of the motion of one gesture."""
ANYTHING = "*/*"
LONGEST_ACCEPT = 1000
"""Longer Accept headers are cut off, characters."""


def chosen(accept: str | None, offered: Sequence[str], what: str) -> str:
    """The media type in which `what` is answered. Raises NotAcceptableError if none of the offered is accepted."""
    media_type = preferred(accept, offered)
    if media_type is None:
        one = "it" if len(offered) == 1 else "one"
        raise NotAcceptableError("not_acceptable", f"{what} comes as {' or '.join(offered)}; accept {one}")
    return media_type


def preferred(accept: str | None, offered: Sequence[str]) -> str | None:
    """The media type among `offered` that `accept` wants most, the earlier one on a tie; None when it wants none.

    The most specific range that matches a type gives its quality: "text/*;q=0.3, text/html;q=0.7" rates text/html
    at 0.7. No header accepts everything. Parameters other than q are not compared.
    """
    ranges = [_media_range(item) for item in (accept or ANYTHING)[:LONGEST_ACCEPT].split(",") if item.strip()]
    qualities = [_quality(media_type, ranges) for media_type in offered]
    best = max(qualities)
    return offered[qualities.index(best)] if best > 0 else None


def _media_range(item: str) -> tuple[str, float]:
    """The range in lower case and its quality, 0 where that cannot be read."""
    name, *parameters = (part.strip().lower() for part in item.split(";"))
    for parameter in parameters:
        key, _, value = parameter.partition("=")
        if key.strip() == "q":
            return name, _number(value.strip())
    return name, 1.0


def _number(text: str) -> float:
    """A quality value: 0 to 1 with at most three decimals."""
    whole, _, decimals = text.partition(".")
    if whole not in {"0", "1"} or len(decimals) > 3 or (decimals and not decimals.isdecimal()):
        return 0.0
    return min(float(text), 1.0)


def _quality(media_type: str, ranges: Sequence[tuple[str, float]]) -> float:
    kind = media_type.partition("/")[0] + "/*"
    for name in (media_type, kind, ANYTHING):
        found = [quality for range_name, quality in ranges if range_name == name]
        if found:
            return max(found)
    return 0.0
