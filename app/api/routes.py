"""The paths of the service."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path, PurePath
from types import MappingProxyType
from typing import Any

from fastapi import APIRouter, Request, Response
from starlette.exceptions import HTTPException
from starlette.responses import PlainTextResponse

from ..authoring.catalogue import Kind
from ..errors import InputError, UnsupportedFormatError
from ..model import Notice
from ..performance import Line, Options, Progress, Understudy, find_functions, perform, write_bml, write_listener
from ..realization import AvatarOptions, BmlInput, MotionFormat, Realized, prepare_schedule, realize, write_motion
from ..realizer.body.motion import check_tail
from ..schemas.direction import read_direction
from ..schemas.given_functions import read_functions
from ..schemas.library import CharactersResponse, GesturesResponse, RulesResponse
from ..schemas.requests import (
    RealizeOptions,
    read_object,
    read_options,
    read_realize_options,
    read_request,
    read_timings,
)
from ..schemas.responses import FunctionsResponse, PerformResponse, ResponseModel
from .capacity import Deadline
from .form import Part, read_form
from .metrics import MEDIA_TYPE as METRICS
from .negotiation import preferred
from .problems import MEDIA_TYPE as PROBLEM
from .service import Shared
from .speaker import with_reference

XML = "application/xml"
JSON = "application/json"
GLB = "model/gltf-binary"
BVH = "text/x-bvh"
REALIZE_FIELDS = ("bml", "audio", "avatar", "options")
PERFORM_FIELDS = ("audio", "text", "options", "words", "functions", "direction", "reference")
WARNINGS_HEADER = "Understudy-Warnings"

_TEXT = {"type": "string"}
_FILE = {"type": "string", "format": "binary"}
_PERFORM_BODY = {
    "requestBody": {
        "required": True,
        "content": {
            "multipart/form-data": {
                "schema": {
                    "type": "object",
                    "required": ["audio", "text"],
                    "properties": {
                        "audio": _FILE,
                        "text": _TEXT,
                        "options": _TEXT,
                        "words": _FILE,
                        "functions": _FILE,
                        "direction": _FILE,
                        "reference": _FILE,
                    },
                }
            }
        },
    }
}
_FUNCTIONS_BODY = {
    "requestBody": {
        "required": True,
        "content": {JSON: {"schema": {"type": "object", "required": ["text"], "properties": {"text": _TEXT}}}},
    }
}
_ERRORS: dict[int | str, dict[str, Any]] = {"4XX": {"content": {PROBLEM: {}}}, "5XX": {"content": {PROBLEM: {}}}}
_PERFORMED: dict[int | str, dict[str, Any]] = {200: {"content": {XML: {}}, "model": PerformResponse}}

_REALIZED: dict[int | str, dict[str, Any]] = {200: {"content": {JSON: {}, GLB: {}, BVH: {}}}}
_REALIZE_BODY = {
    "requestBody": {
        "required": True,
        "content": {
            XML: {"schema": _TEXT},
            "multipart/form-data": {
                "schema": {
                    "type": "object",
                    "required": ["bml"],
                    "properties": {"bml": _FILE, "audio": _FILE, "avatar": _FILE, "options": _TEXT},
                }
            },
        },
    }
}
_MOTION_FORMATS: Mapping[str, MotionFormat] = MappingProxyType(
    {JSON: MotionFormat.JSON, GLB: MotionFormat.GLB, BVH: MotionFormat.BVH}
)
_BML_TYPES = frozenset({XML, "text/xml"})

router = APIRouter()


@router.post("/perform", responses=_PERFORMED | _ERRORS, openapi_extra=_PERFORM_BODY)
async def post_perform(request: Request, shared: Shared) -> Response:
    """One line: audio and text in, BML or (by `Accept`) JSON out. `options` is JSON: character, agitation,
    seed, mode, listener (a list of names; then only JSON is answered), dialect, timing, lead_in_s (0 to 3), stillness
    (0 to 1), reference (what `understudy reference` writes). The file `reference` is the same as a .json, or another
    recording of the speaker; `functions` are functions known already, `direction` is a director's notes
    (docs/directing.md).
    """
    media_type = _media_type(request, (XML, JSON), "a performance comes")
    shared.capacity.require_place()
    deadline = Deadline.starting_now(shared.settings.deadline_s)
    form = await deadline.within(read_form(request, PERFORM_FIELDS))
    line = _line(form)
    options = _options(form)
    if options.listeners:
        media_type = _media_type(request, (JSON,), "a performance with listeners comes")
    work = partial(_performed, shared.understudy, line, options, media_type=media_type, reference=form.get("reference"))
    return await shared.capacity.run(work, deadline)


@router.post("/realize", responses=_REALIZED | _ERRORS, openapi_extra=_REALIZE_BODY)
async def post_realize(request: Request, shared: Shared) -> Response:
    """BML in, motion out: the BML alone as the body, or a form with `bml`, the `audio` of its speech, an `avatar`
    (GLB or VRM) and `options` (JSON: agitation, character, fps, seed, skeleton, stillness). Answers a clip as JSON, GLB
    or BVH.
    """
    media_type = _media_type(request, tuple(_MOTION_FORMATS), "motion comes")
    shared.capacity.require_place()
    deadline = Deadline.starting_now(shared.settings.deadline_s)
    work = partial(_realized, shared.understudy, await deadline.within(_asked(request)), media_type)
    return await shared.capacity.run(work, deadline)


@router.post("/functions", response_model=FunctionsResponse, responses=_ERRORS, openapi_extra=_FUNCTIONS_BODY)
async def post_functions(request: Request, shared: Shared) -> Response:
    """What words alone do."""
    if request.headers.get("content-type", "").partition(";")[0].strip().lower() != JSON:
        raise UnsupportedFormatError("media_type", f'send {JSON}: {{"text": "…"}}')
    deadline = Deadline.starting_now(shared.settings.deadline_s)
    question = read_request(read_object(await deadline.within(request.body()), "body"))
    analysis = await shared.capacity.run(lambda _: find_functions(shared.understudy.language, question.text), deadline)
    return _json(FunctionsResponse.of(analysis, question.id))


@router.get("/characters", response_model=CharactersResponse)
def get_characters(shared: Shared) -> Response:
    """Who can perform, and how they move."""
    return _json(CharactersResponse.of(shared.catalogue.characters.by_name.values()))


@router.get("/gestures", response_model=GesturesResponse)
def get_gestures(shared: Shared) -> Response:
    """The library of gestures: what shows which lexeme, and how it is made at each level of agitation."""
    return _json(GesturesResponse.of(shared.understudy.realizer.library.definitions))


@router.get("/rules", response_model=RulesResponse)
def get_rules(shared: Shared) -> Response:
    """Every function rule, mapping rule and table entry."""
    return _json(RulesResponse.of(item for item in shared.catalogue.items if item.kind is not Kind.WORD))


@router.get("/lexicon", response_model=RulesResponse)
def get_lexicon(shared: Shared) -> Response:
    """Every word and phrase."""
    return _json(RulesResponse.of(item for item in shared.catalogue.items if item.kind is Kind.WORD))


@router.get("/healthz")
async def get_healthz() -> dict[str, str]:
    """The process answers."""
    return {"status": "alive"}


@router.get("/readyz")
async def get_readyz(shared: Shared) -> dict[str, str]:
    """Everything is loaded; `not_reloaded` says why files that were saved since are not (`serve --reload`)."""
    return {"status": "ready"} | ({"not_reloaded": shared.not_reloaded} if shared.not_reloaded else {})


@router.get("/metrics", response_class=PlainTextResponse)
def get_metrics(shared: Shared) -> Response:
    """The service's figures, for Prometheus."""
    return Response(shared.metrics.text(), media_type=METRICS)


def _media_type(request: Request, offered: Sequence[str], what: str) -> str:
    """Raises HTTPException 406 where the request accepts none of what is offered."""
    media_type = preferred(request.headers.get("accept"), offered)
    if media_type is None:
        raise HTTPException(406, f"{what} as {' or '.join(offered)}; accept {'it' if len(offered) == 1 else 'one'}")
    return media_type


def _line(form: dict[str, Part]) -> Line:
    """Raises InputError `field_missing`, and what the parts' own checks raise."""
    for name in ("audio", "text"):
        if name not in form:
            raise InputError("field_missing", f"the field {name} is missing; send audio and text", field=name)
    words = form.get("words")
    timings = None if words is None else read_timings(words.file_name or "", words.content)
    functions = read_functions(form["functions"].content) if "functions" in form else ()
    direction = read_direction(form["direction"].content) if "direction" in form else None
    return Line(form["audio"].content, form["text"].text, timings, functions, direction)


def _options(form: dict[str, Part]) -> Options:
    """What `options` says; the recording goes by the name of its file."""
    options = read_options(form["options"].content) if "options" in form else Options()
    audio_name = PurePath(form["audio"].file_name or "").stem or None
    return replace(options, form=replace(options.form, audio_name=audio_name))


@dataclass(frozen=True, slots=True)
class _Asked:
    """BML that is to be played, how, and for whom."""

    sheet: BmlInput
    question: RealizeOptions
    avatar: bytes | None = None


async def _asked(request: Request) -> _Asked:
    """Raises InputError `field_missing`, UnsupportedFormatError `media_type`, and what the form's own checks raise."""
    sent = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if sent in _BML_TYPES:
        return _Asked(BmlInput(await request.body(), Path("bml")), RealizeOptions())
    if sent != "multipart/form-data":
        raise UnsupportedFormatError("media_type", f"send BML as {XML}, or multipart/form-data with bml and audio")
    form = await read_form(request, REALIZE_FIELDS)
    if "bml" not in form:
        raise InputError("field_missing", "the field bml is missing; send the BML that is to be played", field="bml")
    content = {name: part.content for name, part in form.items()}
    question = read_realize_options(content["options"]) if "options" in content else RealizeOptions()
    sheet = BmlInput(content["bml"], Path(form["bml"].file_name or "bml"), content.get("audio"))
    return _Asked(sheet, question, content.get("avatar"))


def _realized(understudy: Understudy, asked: _Asked, media_type: str, progress: Progress) -> Response:
    """The motion in the form asked for."""
    question, realizer = asked.question, understudy.realizer
    check_tail(question.tail_s)
    if question.skeleton:
        realizer.rig(question.skeleton)
    staged = prepare_schedule(
        understudy.acoustic,
        asked.sheet,
        agitation=question.agitation,
        character=question.character,
        stillness=question.stillness,
        progress=progress,
    )
    progress("realize")
    motion = realize(realizer, staged.schedule, frame_rate_hz=question.fps, seed=question.seed, tail_s=question.tail_s)
    progress("export")
    realized = Realized(staged.schedule, replace(motion, notices=staged.notices))
    wearer = AvatarOptions(question.skeleton, asked.avatar)
    content = write_motion(realized, realizer, _MOTION_FORMATS[media_type], wearer, question.files)
    return Response(content, media_type=media_type, headers=_headers(staged.notices))


def _headers(notices: Sequence[Notice]) -> dict[str, str]:
    """The codes of what was degraded, dropped or guessed, each once."""
    codes = ", ".join(dict.fromkeys(notice.code for notice in notices))
    return {"Vary": "Accept"} | ({WARNINGS_HEADER: codes} if codes else {})


def _performed(
    understudy: Understudy,
    line: Line,
    options: Options,
    progress: Progress,
    *,
    media_type: str,
    reference: Part | None,
) -> Response:
    """The answer, also written out in the thread that made it."""
    options = with_reference(options, reference, understudy)
    performance = perform(understudy, line, options, progress)
    progress("write")
    bml = write_bml(performance, options.form)
    listeners = {each.name: write_listener(performance, each, options.form) for each in performance.listeners}
    content = bml if media_type == XML else PerformResponse.of(performance, bml, listeners).to_json()
    return Response(content, media_type=media_type, headers=_headers(performance.notices))


def _json(answer: ResponseModel) -> Response:
    return Response(answer.to_json(), media_type=JSON)
