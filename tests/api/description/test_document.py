"""The OpenAPI document says of every operation what it takes and answers, and agrees with what checks and writes."""

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from fastapi import FastAPI
from fastapi.routing import APIRoute

from tests.support.motion.hand_made_motion import BODY, waving
from understudy.api import authoring
from understudy.api.admission.access import PROBES
from understudy.api.description.document import describe
from understudy.api.description.operations import AUTHORING_OPERATIONS, LIVE_MESSAGES, OPERATIONS
from understudy.api.problems import CODES, Problem
from understudy.api.routes import router
from understudy.files import resource_folder
from understudy.model import Level, Mode
from understudy.model.formats import DialectName, TimeForm
from understudy.realizer.exporting.clip_json import to_clip_json
from understudy.realizer.exporting.retargeting import load_rigs
from understudy.schemas.live import StartMessage
from understudy.schemas.motion import ClipResponse
from understudy.schemas.options import PerformOptions, RealizeOptions, check_options, check_realize_options

Json = dict[str, Any]
ERRORS_PAGE = (Path(__file__).parents[3] / "docs" / "errors.md").read_text(encoding="utf-8")

MET_BY_REQUESTS = {
    *("The recording", "The text", "Word timings", "BML input", "The request", "Rules and gestures", "Server errors"),
}


def described() -> Json:
    app = FastAPI()
    app.include_router(router)
    app.include_router(authoring.router)
    describe(app)
    return app.openapi()


DOCUMENT = described()
SCHEMAS: Json = DOCUMENT["components"]["schemas"]
FORM = "multipart/form-data"


def _all(value: object) -> Iterator[Json]:
    """Every object in it."""
    if isinstance(value, dict):
        yield value
        for part in value.values():
            yield from _all(part)
    elif isinstance(value, list):
        for part in value:
            yield from _all(part)


def test_every_path_is_described_and_no_other() -> None:
    routes = {
        (method.lower(), route.path_format)
        for route in (*router.routes, *authoring.router.routes)
        if isinstance(route, APIRoute)
        for method in route.methods or ()
    }
    assert routes == OPERATIONS.keys() | AUTHORING_OPERATIONS.keys()
    for (method, path), operation in OPERATIONS.items():
        told = DOCUMENT["paths"][path][method]
        assert told["operationId"] == operation.id
        assert told["description"]


def test_operation_ids_are_names_that_clients_can_use() -> None:
    ids = [operation.id for operation in OPERATIONS.values()]
    assert len(set(ids)) == len(ids)
    assert all(re.fullmatch("[a-z]+(_[a-z]+)*", each) for each in ids)
    assert OPERATIONS["post", "/perform"].id == "perform"


def test_live_streams_are_described_with_what_a_client_sends() -> None:
    told = DOCUMENT["paths"]["/live"]["get"]
    assert {"101", "401", "403", "421", "429"} == told["responses"].keys()
    for message in LIVE_MESSAGES:
        assert message.__name__ in told["description"]
        assert SCHEMAS[message.__name__]["additionalProperties"] is False
    assert SCHEMAS["StartMessage"]["properties"].keys() == StartMessage.model_fields.keys()


def test_probes_ask_for_no_key_and_all_others_may() -> None:
    is_open = {path for path, told in DOCUMENT["paths"].items() if told.get("get", {}).get("security") == []}
    assert is_open == PROBES
    assert DOCUMENT["security"] == [{}, {"key": []}]


def test_every_reference_leads_somewhere() -> None:
    for reference in (each["$ref"] for each in _all(DOCUMENT) if "$ref" in each):
        found: Any = DOCUMENT
        for name in reference.removeprefix("#/").split("/"):
            found = found[name]
        assert found


def test_options_are_a_schema_with_its_choices() -> None:
    parts = DOCUMENT["paths"]["/perform"]["post"]["requestBody"]["content"][FORM]["schema"]["properties"]
    assert parts["options"] == {"$ref": "#/components/schemas/PerformOptions"}
    options = SCHEMAS["PerformOptions"]
    assert options["properties"].keys() == PerformOptions.model_fields.keys()
    assert options["additionalProperties"] is False
    for name, choices in (("Level", Level), ("Mode", Mode), ("DialectName", DialectName), ("TimeForm", TimeForm)):
        assert SCHEMAS[name]["enum"] == [each.value for each in choices]
    assert SCHEMAS["RealizeOptions"]["properties"].keys() == RealizeOptions.model_fields.keys()


def test_a_text_may_not_be_empty() -> None:
    parts = DOCUMENT["paths"]["/perform"]["post"]["requestBody"]["content"][FORM]["schema"]["properties"]
    assert parts["text"]["minLength"] == SCHEMAS["FunctionsRequest"]["properties"]["text"]["minLength"] == 1


def test_the_examples_are_right() -> None:
    for path, check in (("/perform", check_options), ("/realize", check_realize_options)):
        check(DOCUMENT["paths"][path]["post"]["requestBody"]["content"][FORM]["example"]["options"])
    for response in DOCUMENT["components"]["responses"].values():
        Problem.model_validate(response["content"]["application/problem+json"]["example"])


def test_every_error_is_a_problem_with_its_codes() -> None:
    for path in DOCUMENT["paths"].values():
        for operation in path.values():
            errors = {status: told for status, told in operation["responses"].items() if status not in ("101", "200")}
            assert errors
            assert all(told["$ref"].startswith("#/components/responses/") for told in errors.values())
    assert {"type", "title", "status", "code", "detail"} == set(SCHEMAS["Problem"]["required"])
    assert "text_empty" in SCHEMAS["ErrorCode"]["enum"]


def test_the_codes_are_those_of_the_page_that_requests_can_meet() -> None:
    told: dict[int, set[str]] = {}
    for section in ERRORS_PAGE.split("\n## ")[1:]:
        if section.splitlines()[0] in MET_BY_REQUESTS:
            for code, status in re.findall(r"^\| `(\w+)` \| (\d+) \|", section, flags=re.MULTILINE):
                told.setdefault(int(status), set()).add(code)
    assert {status: set(codes) for status, codes in CODES.items()} == told


def test_answers_are_open_and_have_no_defaults() -> None:
    """A property with a default is taken for always there by generators of clients."""
    for name, schema in SCHEMAS.items():
        if name.endswith("Response") or name == "Problem":
            assert "additionalProperties" not in schema
        assert all("default" not in told for told in schema.get("properties", {}).values())


@pytest.mark.parametrize("rig", ["vrm", "mixamo"])
def test_a_clip_is_what_its_schema_says(rig: str) -> None:
    rigs = load_rigs(resource_folder("lexicon") / "retarget", BODY)
    content = to_clip_json(waving(), BODY, rigs[rig])
    assert ClipResponse.model_validate_json(content, strict=True).model_fields_set >= json.loads(content).keys()
