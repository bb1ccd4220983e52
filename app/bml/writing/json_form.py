"""Writes BML documents as JSON; docs/bml-json.md has the schema.

An element is an object with the keys `element`, `attributes` and `content`, the last two only if not empty. Numbers are
numbers, a reference is an object, everything else is text.
"""

import json

from ..markup.documents import Document, Element, Reference, Value

Json = str | int | float | dict[str, "Json"] | list["Json"]


def to_json(document: Document) -> bytes:
    """The document as indented UTF-8 JSON; deterministic."""
    told: Json = {"dialect": document.dialect.value, "root": _element(document.root)}
    return json.dumps(told, ensure_ascii=False, indent=1).encode() + b"\n"


def _element(element: Element) -> Json:
    told: dict[str, Json] = {"element": element.name}
    if element.attributes:
        told["attributes"] = {name: _value(value) for name, value in element.attributes.items()}
    if element.content:
        told["content"] = [part if isinstance(part, str) else _element(part) for part in element.content]
    return told


def _value(value: Value) -> Json:
    if not isinstance(value, Reference):
        return value
    block: dict[str, Json] = {"block": value.block} if value.block else {}
    return {**block, "behavior": value.behavior, "point": value.point, "offset_s": value.offset_s}
