"""Routes for authors: composing and playing gestures that are in no library yet, and trying edited rules.

Requests have no side effects: edited rules apply to the request that carries them. Only a service started with a folder
for an author's rules writes files, only there, and only for callers on its own machine.
"""

from fastapi import APIRouter, Request, Response
from starlette.exceptions import HTTPException

from ..authoring.rule_edits import FIELD, is_new_file
from ..authoring.rule_files import read_rule_text, saved_names, write_rule_text
from ..errors import ForbiddenError, UndecodableError
from ..schemas.rules import RuleFileResponse, RuleFilesResponse
from .admission.hosts import is_loopback
from .bodies import declared_bytes
from .negotiation import GESTURE_TYPES, JSON, chosen
from .service import Shared, worked
from .workers.messages import Task

router = APIRouter()


@router.get("/gestures/language")
async def get_gesture_language(shared: Shared) -> Response:
    """Every word of the gesture language, and which combine: palms at a right angle to each direction of the fingers,
    the thumbs that a form leaves free, the order of frames, ranges of numbers, sectors out of reach.
    """
    return Response(shared.pool.nursery.library["/gestures/language"], media_type=JSON)


@router.post("/gestures/check")
async def post_gestures_check(request: Request, shared: Shared) -> Response:
    """Gestures as text, as values or by name in; the text, every mistake with its line and column, and what was defined
    as values out. What is written wrong is no error of the request.
    """
    return await worked(request, shared, Task.GESTURE_CHECK)


@router.post("/gestures/motion")
async def post_gestures_motion(request: Request, shared: Shared) -> Response:
    """The motion of one gesture of a text, from rest to rest, at a level of agitation: a clip as JSON, GLB or BVH, by
    `Accept`.
    """
    chosen(request.headers.get("accept"), tuple(GESTURE_TYPES), "motion")
    return await worked(request, shared, Task.GESTURE_MOTION)


@router.post("/gestures/pose")
async def post_gestures_pose(request: Request, shared: Shared) -> Response:
    """The pose of the arms in a GLB or VRM file as angles of joints, to override what the language can say by."""
    return await worked(request, shared, Task.GESTURE_POSE)


@router.get("/rules/files")
async def get_rule_files(shared: Shared) -> Response:
    """The files of rules, priorities and words that can be edited."""
    files = [path.removeprefix("/rules/files/") for path in shared.pool.nursery.library if path.startswith("/rules/f")]
    saved = list(saved_names(shared.rules_folder))
    told = RuleFilesResponse(files=files, saved=saved, writable=shared.rules_folder is not None)
    return Response(told.to_json(), media_type=JSON)


@router.get("/rules/files/{name:path}")
async def get_rule_file(name: str, shared: Shared) -> Response:
    """The text of a file of rules or words: as its author saved it, else as it is in use."""
    known = shared.pool.nursery.library.get(f"/rules/files/{name}")
    if known is None and not is_new_file(name):
        raise HTTPException(404, "no file of rules or words has that name; GET /rules/files lists them")
    if known is not None and shared.rules_folder is None:
        return Response(known, media_type=JSON)
    return Response(RuleFileResponse.of(read_rule_text(name, shared.rules_folder)).to_json(), media_type=JSON)


@router.put("/rules/files/{name:path}")
async def put_rule_file(name: str, request: Request, shared: Shared) -> Response:
    """Saves a file of rules or words, as plain text, in the folder of `understudy studio --rules DIR`; other services
    refuse."""
    if f"/rules/files/{name}" not in shared.pool.nursery.library and not is_new_file(name):
        raise HTTPException(404, "no file of rules or words has that name; GET /rules/files lists them")
    if shared.rules_folder is not None and not _is_own_machine(request):
        raise ForbiddenError("rules_read_only", "rules are saved from this machine alone", field=FIELD)
    most_bytes, declared = shared.settings.part_limits["rules"], declared_bytes(request.headers)
    async with shared.uploads.body(request.receive, most_bytes=most_bytes, declared_bytes=declared) as body:
        try:
            text = bytes(body).decode("utf-8")
        except UnicodeDecodeError as error:
            message = f"{FIELD} is not UTF-8 at byte {error.start}; send it as UTF-8"
            raise UndecodableError("text_not_utf8", message, field=FIELD) from None
        write_rule_text(name, text, shared.rules_folder)
    return Response(RuleFileResponse.of(read_rule_text(name, shared.rules_folder)).to_json(), media_type=JSON)


@router.post("/rules/check")
async def post_rules_check(request: Request, shared: Shared) -> Response:
    """Edited files in, every mistake in the rules and words with them out, each with its file, line and column."""
    return await worked(request, shared, Task.RULE_CHECK)


@router.post("/rules/explain")
async def post_rules_explain(request: Request, shared: Shared) -> Response:
    """What a rule, behaviour or word is and says, what it rests on and what it leads to."""
    return await worked(request, shared, Task.RULE_EXPLANATION)


@router.post("/rules/compare")
async def post_rules_compare(request: Request, shared: Shared) -> Response:
    """What edited files would change: functions and offered behaviours of the lines sent and of all example lines,
    before and after. Lines are read, not heard.
    """
    return await worked(request, shared, Task.RULE_COMPARISON)


def _is_own_machine(request: Request) -> bool:
    """Whether the caller is on this machine; the host name is checked too, against DNS rebinding."""
    return request.client is not None and all(map(is_loopback, (request.client.host, request.url.hostname or "")))
