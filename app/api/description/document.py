"""The OpenAPI document of the service, made from the schemas that validate requests and write answers."""

import json

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi
from pydantic import BaseModel
from pydantic.json_schema import JsonSchemaMode, models_json_schema

from ...schemas.direction import DirectionRequest
from ...schemas.edits import EditsForm
from ...schemas.gestures.definitions import GestureCheckRequest, GestureCheckResponse, GestureMotionRequest
from ...schemas.gestures.language import GestureLanguageResponse
from ...schemas.library import CharactersResponse, GesturesResponse, RulesResponse
from ...schemas.motion import AvatarPoseOptions, AvatarPoseResponse, ClipResponse
from ...schemas.options import PerformOptions, RealizeOptions
from ...schemas.requests import FunctionsRequest, GivenFunctionRequest
from ...schemas.responses import FunctionsResponse, PerformResponse, StatusResponse
from ...schemas.rules import (
    RuleCheckResponse,
    RuleComparisonRequest,
    RuleComparisonResponse,
    RuleEditsRequest,
    RuleExplanationRequest,
    RuleExplanationsResponse,
    RuleFileResponse,
    RuleFilesResponse,
)
from ..problems import Problem
from .answers import SHARED_HEADERS, Json, shared_errors
from .operations import AUTHORING_OPERATIONS, LIVE, LIVE_MESSAGES, OPERATIONS, live_operation

_ASKED: tuple[type[BaseModel], ...] = (
    *(PerformOptions, RealizeOptions, FunctionsRequest, GivenFunctionRequest, DirectionRequest, EditsForm),
    *(GestureCheckRequest, GestureMotionRequest, AvatarPoseOptions),
    *(RuleEditsRequest, RuleExplanationRequest, RuleComparisonRequest),
    *LIVE_MESSAGES,
)
_ANSWERED: tuple[type[BaseModel], ...] = (
    *(PerformResponse, FunctionsResponse, ClipResponse, Problem, StatusResponse),
    *(CharactersResponse, GesturesResponse, RulesResponse),
    *(GestureLanguageResponse, GestureCheckResponse, AvatarPoseResponse),
    *(RuleFilesResponse, RuleFileResponse, RuleCheckResponse, RuleExplanationsResponse, RuleComparisonResponse),
)
_KEY = "key"

PATHS = tuple(sorted({path for _method, path in (*OPERATIONS, *AUTHORING_OPERATIONS)}))
"""Those that the document describes."""


def describe(app: FastAPI) -> None:
    """Makes `app` serve this document at `/openapi.json`."""
    app.openapi = lambda: app.openapi_schema or _made(app)  # type: ignore[method-assign]


def _made(app: FastAPI) -> Json:
    document = get_openapi(title=app.title, version=app.version, description=app.description, routes=app.routes)
    for (method, path), operation in {**OPERATIONS, **AUTHORING_OPERATIONS}.items():
        if path in document["paths"]:
            told = document["paths"][path][method]
            document["paths"][path][method] = operation.described() | {
                kept: told[kept] for kept in ("description", "parameters") if kept in told
            }
    document["paths"][LIVE] = {"get": live_operation()}
    document["components"] = {
        "schemas": _schemas(),
        "responses": shared_errors(),
        "headers": SHARED_HEADERS,
        "securitySchemes": {
            _KEY: {"type": "http", "scheme": "bearer", "description": "An API key, if the service requires one."}
        },
    }
    document["security"] = [{}, {_KEY: []}]
    app.openapi_schema = document
    return document


def _schemas() -> Json:
    """Every schema by name. Requests forbid unknown members, answers allow them."""
    modes: list[tuple[type[BaseModel], JsonSchemaMode]] = [
        *((model, "validation") for model in _ASKED),
        *((model, "serialization") for model in _ANSWERED),
    ]
    _, definitions = models_json_schema(modes, ref_template="#/components/schemas/{model}")
    schemas: Json = definitions["$defs"]
    for schema in schemas.values():
        for told in schema.get("properties", {}).values():
            _say_default(told)
    return schemas


def _say_default(told: Json) -> None:
    """Moves the default into the description: generators take a property with a default as always present."""
    default = told.pop("default", None)
    if default not in (None, "", []):
        told["description"] = f"{told.get('description', '')} Default: {json.dumps(default)}.".strip()
