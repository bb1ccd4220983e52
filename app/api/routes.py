"""The routes of the service."""

from fastapi import APIRouter, Request, Response
from starlette.responses import PlainTextResponse

from ..errors import ServiceError, UnsupportedFormatError
from .bodies import media_type_of
from .metrics import MEDIA_TYPE as METRICS
from .negotiation import JSON, MOTION_TYPES, XML, chosen
from .service import Service, Shared, worked
from .workers.messages import Task

router = APIRouter()


@router.post("/perform")
async def post_perform(request: Request, shared: Shared) -> Response:
    """One line: audio and text in, BML or (by `Accept`) JSON out. Without `audio` the text is timed as it is usually
    spoken, or as `words` says, and may have marks of emphasis and tags (docs/say.md).

    `options` is JSON: character, agitation, affect (a tone, three numbers, or rows of a time and these), seed, mode,
    listener (a list of names; then only JSON is answered), dialect, timing, visemes, bmlt_audio, lead_in_s (0 to 3),
    stillness (0 to 1), profile (whose gestures), choice (terms or priority), contours (JSON has f0 and energy, too),
    targets (names, each with [x, y, z] in metres), reference (what `understudy reference` writes). The file `reference`
    is the same as a .json, or another recording of the speaker; `functions` are functions known already, `direction` is
    a director's notes (docs/directing.md), `edits` are what an author changed (docs/edits.md), `profile` is a gesture
    profile's file (docs/profiles.md).
    """
    chosen(request.headers.get("accept"), (XML, JSON), "a performance")
    return await worked(request, shared, Task.PERFORM)


@router.post("/realize")
async def post_realize(request: Request, shared: Shared) -> Response:
    """BML in, motion out: the BML alone as the body, or a form with `bml`, the `audio` of its speech, an `avatar`
    (GLB or VRM) and `options` (JSON: agitation, character, fps, seed, skeleton, stillness, targets).
    Answers a clip as JSON, GLB, BVH, VRMA, USD, FBX, MPEG-4, CSV of the face or visemes, or a timeline
    (OpenTimelineIO, TextGrid, ELAN, CSV), by `Accept`.
    """
    chosen(request.headers.get("accept"), tuple(MOTION_TYPES), "motion")
    return await worked(request, shared, Task.REALIZE)


@router.post("/functions")
async def post_functions(request: Request, shared: Shared) -> Response:
    """Finds the communicative functions of a text, without audio."""
    if media_type_of(request.headers.get("content-type", "")) != JSON:
        raise UnsupportedFormatError("media_type", f'send {JSON}: {{"text": "…"}}')
    return await worked(request, shared, Task.FUNCTIONS)


@router.get("/characters")
async def get_characters(shared: Shared) -> Response:
    """The characters and how they move."""
    return _known(shared, "/characters")


@router.get("/gestures")
async def get_gestures(shared: Shared) -> Response:
    """The library of gestures: what shows which lexeme, and how it is made at each level of agitation."""
    return _known(shared, "/gestures")


@router.get("/rules")
async def get_rules(shared: Shared) -> Response:
    """Every function rule, mapping rule and table entry."""
    return _known(shared, "/rules")


@router.get("/lexicon")
async def get_lexicon(shared: Shared) -> Response:
    """Every word and phrase."""
    return _known(shared, "/lexicon")


@router.get("/healthz")
async def get_healthz() -> dict[str, str]:
    """Whether the process runs."""
    return {"status": "alive"}


@router.get("/readyz")
async def get_readyz(shared: Shared) -> dict[str, str]:
    """Whether every worker is ready, else 503 with the reason; `not_reloaded` says why saved files are not in use
    (`serve --reload`)."""
    trouble = await shared.pool.trouble()
    if trouble:
        raise ServiceError("not_ready", trouble, retry_after_s=1.0)
    return {"status": "ready"} | ({"not_reloaded": shared.not_reloaded} if shared.not_reloaded else {})


@router.get("/metrics", response_class=PlainTextResponse)
def get_metrics(shared: Shared) -> Response:
    """Metrics for Prometheus."""
    return Response(shared.metrics.text(), media_type=METRICS)


def _known(shared: Service, path: str) -> Response:
    """The part of the library at this path."""
    return Response(shared.pool.nursery.library[path], media_type=JSON)
