"""Which fields a request's body may have, and how large each and the whole may be."""

from collections.abc import Mapping

from ..settings import Settings
from .negotiation import JSON, XML
from .workers.messages import Task

BML_TYPES = frozenset({XML, "text/xml"})
_FORM_ROOM = 64 * 1024
"""Bytes of a form besides the contents of its fields."""


def media_type_of(content_type: str) -> str:
    """What a Content-Type header says, without its parameters."""
    return content_type.partition(";")[0].strip().lower()


def form_limits(task: Task, settings: Settings) -> Mapping[str, int]:
    """The fields that a form may have, and the most bytes of each."""
    limits = {**settings.part_limits, "audio": settings.max_audio_bytes, "reference": settings.max_audio_bytes}
    return {name: limits[name] for name in FORM_FIELDS.get(task, ())}


FORM_FIELDS: Mapping[Task, tuple[str, ...]] = {
    Task.PERFORM: (
        *("audio", "text", "options", "words", "functions", "direction", "edits", "profile", "reference", "rules"),
    ),
    Task.REALIZE: ("bml", "audio", "avatar", "options"),
    Task.GESTURE_POSE: ("avatar", "options"),
}
"""The tasks that take a form."""


def body_limit(task: Task, content_type: str, settings: Settings) -> int:
    """The most bytes of a body: of a form as much as its fields may have together, if no setting says less."""
    sent = media_type_of(content_type)
    if sent == "multipart/form-data":
        return min(settings.max_body_bytes, sum(form_limits(task, settings).values()) + _FORM_ROOM)
    if sent == JSON:
        return min(settings.max_body_bytes, settings.part_limits["json"])
    return min(settings.max_body_bytes, settings.part_limits["bml"])
