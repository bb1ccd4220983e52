"""BML as JSON contains everything in the document, in the format of docs/bml-json.md."""

import json
import re
from pathlib import Path
from typing import Any

import pytest

from tests.bml.writing.test_writer import ROOT, everything
from understudy.bml.markup.documents import (
    Document,
    Element,
    Reference,
    Value,
)
from understudy.bml.writing.writer import to_document, to_json
from understudy.model.formats import BmlForm, DialectName, TimeForm

PAGE = (ROOT / "docs" / "bml-json.md").read_text()
SCHEMA = json.loads(re.findall(r"```json\n(.*?)```", PAGE, re.DOTALL)[0])
DEFINITIONS: dict[str, Any] = SCHEMA["$defs"]

FORMS = [BmlForm(dialect=dialect, timing=timing) for dialect in DialectName for timing in TimeForm]


@pytest.mark.parametrize("form", FORMS, ids=lambda form: f"{form.dialect}-{form.timing}")
def test_the_document_can_be_made_of_it_again(form: BmlForm) -> None:
    document = to_document(everything(), form)
    told = json.loads(to_json(document))
    assert Document(DialectName(told["dialect"]), element_of(told["root"])) == document


@pytest.mark.parametrize("form", FORMS, ids=lambda form: f"{form.dialect}-{form.timing}")
def test_it_follows_the_schema_of_the_page(form: BmlForm) -> None:
    told = json.loads(to_json(to_document(everything(), form)))
    assert fits(told, SCHEMA)
    assert not fits(told | {"more": 1}, SCHEMA)
    assert not fits({"dialect": "xml", "root": told["root"]}, SCHEMA)


def test_the_example_of_the_page_is_right() -> None:
    example = re.findall(r"\n\n((?:    .*\n)+)", PAGE)[0]
    assert fits(json.loads(example), SCHEMA)


def test_other_blocks_are_named() -> None:
    head = Element("head", {"start": Reference("s", "end", -0.5, "bml1")})
    told = json.loads(to_json(Document(DialectName.BML, head)))
    start = told["root"]["attributes"]["start"]
    assert start == {"block": "bml1", "behavior": "s", "point": "end", "offset_s": -0.5}
    assert fits(start, DEFINITIONS["time"])


def element_of(told: dict[str, Any]) -> Element:
    attributes = {name: value_of(value) for name, value in told.get("attributes", {}).items()}
    content = tuple(part if isinstance(part, str) else element_of(part) for part in told.get("content", ()))
    return Element(told["element"], attributes, content)


def value_of(told: Value | dict[str, Any]) -> Value:
    if not isinstance(told, dict):
        return told
    return Reference(told["behavior"], told["point"], told["offset_s"], told.get("block"))


def fits(value: object, schema: dict[str, Any]) -> bool:
    """Whether `value` follows a JSON schema; the few keywords that the page uses."""
    if "$ref" in schema:
        return fits(value, DEFINITIONS[Path(schema["$ref"]).name])
    if "anyOf" in schema:
        return any(fits(value, each) for each in schema["anyOf"])
    if "enum" in schema:
        return value in schema["enum"]
    if schema["type"] == "object":
        return isinstance(value, dict) and _object_fits(value, schema)
    if schema["type"] == "array":
        return isinstance(value, list) and all(fits(each, schema["items"]) for each in value)
    return isinstance(value, {"string": str, "number": int | float}[schema["type"]])


def _object_fits(value: dict[str, object], schema: dict[str, Any]) -> bool:
    known = schema.get("properties", {})
    others = schema.get("additionalProperties", {})
    if not value.keys() >= set(schema.get("required", ())):
        return False
    return all(
        fits(each, known.get(name, others)) if known.get(name, others) else False for name, each in value.items()
    )
