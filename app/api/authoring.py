"""Routes for authors: composing and playing gestures that are in no library yet, trying edited rules, and reading and
saving authored files.

Requests have no side effects: edited rules apply to the request that carries them. Only a service started with a folder
for an author's files writes any, only there, and only for callers on its own machine.
"""

import json

from fastapi import APIRouter, Request, Response
from starlette.exceptions import HTTPException

from ..authoring.saved_files import (
    LEXICON_FILES,
    RULE_FILES,
    EditableFiles,
    SavedText,
    read_text,
    require_folder,
    saved_names,
    write_text,
)
from ..errors import ForbiddenError, InputError, UndecodableError
from ..schemas.rules import RuleFileResponse, RuleFilesResponse
from .admission.headers import is_loopback
from .bodies import declared_bytes
from .negotiation import GESTURE_TYPES, JSON, chosen
from .service import Service, Shared, answered, worked
from .workers.messages import Job, Task

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
    as values out. A mistake in the text is not an error of the request.
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
    return _listed(RULE_FILES, shared)


@router.get("/lexicon/files")
async def get_lexicon_files(shared: Shared) -> Response:
    """The files of gestures, characters, profiles and weights that can be edited."""
    return _listed(LEXICON_FILES, shared)


@router.get("/rules/files/{name:path}")
async def get_rule_file(name: str, shared: Shared) -> Response:
    """The text of a file of rules or words: as its author saved it, else as it is in use. `ETag` is its version."""
    return _answer(read_text(RULE_FILES, _known(RULE_FILES, name), shared.author_folder))


@router.get("/lexicon/files/{name:path}")
async def get_lexicon_file(name: str, shared: Shared) -> Response:
    """The text of a file of gestures, a character, a profile or weights, as of `/rules/files`."""
    return _answer(read_text(LEXICON_FILES, _known(LEXICON_FILES, name), shared.author_folder))


@router.put("/rules/files/{name:path}")
async def put_rule_file(name: str, request: Request, shared: Shared) -> Response:
    """Saves a file of rules or words, as plain text, in the folder of `understudy studio --lexicon DIR` or `--rules
    DIR`; other services refuse. With `If-Match` only if the file still has that `ETag`."""
    name = _known(RULE_FILES, name)
    _require_saving(RULE_FILES, request, shared)
    text = await _sent_text(RULE_FILES, request, shared)
    return _answer(write_text(RULE_FILES, name, text, shared.author_folder, version=_version(request)))


@router.put("/lexicon/files/{name:path}")
async def put_lexicon_file(name: str, request: Request, shared: Shared) -> Response:
    """Saves a file of gestures, a character, a profile or weights, as `/rules/files` does, unless it has mistakes or
    does not go with the files in use."""
    name = _known(LEXICON_FILES, name)
    _require_saving(LEXICON_FILES, request, shared)
    text = await _sent_text(LEXICON_FILES, request, shared)
    checked = json.dumps({"files": {name: text}}).encode()
    _refuse_mistakes(await answered(request, shared, Job(Task.RULE_CHECK, JSON, None), checked))
    return _answer(write_text(LEXICON_FILES, name, text, shared.author_folder, version=_version(request)))


@router.post("/rules/check")
async def post_rules_check(request: Request, shared: Shared) -> Response:
    """Edited or new files in, of rules, words, gestures, characters, profiles and weights; every mistake with them out,
    each with its file, line and column."""
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


def _listed(kind: EditableFiles, shared: Service) -> Response:
    folder = shared.author_folder
    told = RuleFilesResponse(
        files=list(kind.files()), saved=list(saved_names(kind, folder)), writable=folder is not None
    )
    return Response(told.to_json(), media_type=JSON)


def _known(kind: EditableFiles, name: str) -> str:
    """The file's name in a checkout; raises HTTPException for a name of no such file."""
    known = kind.known(name)
    if known is None:
        raise HTTPException(404, f"no {kind.kind} has that name; GET /{kind.field}/files lists them")
    return known


def _answer(text: SavedText) -> Response:
    headers = {"ETag": f'"{text.version}"'}
    return Response(RuleFileResponse.of(text).to_json(), media_type=JSON, headers=headers)


def _version(request: Request) -> str | None:
    """The version in `If-Match`; None if any will do."""
    told = request.headers.get("if-match", "*").strip()
    return None if told == "*" else told.removeprefix("W/").strip('"')


def _require_saving(kind: EditableFiles, request: Request, shared: Service) -> None:
    """Raises ForbiddenError if nothing is saved here, or not for this caller."""
    require_folder(kind, shared.author_folder)
    if not _is_own_machine(request):
        raise ForbiddenError("rules_read_only", "files can only be saved from this machine", field=kind.field)


async def _sent_text(kind: EditableFiles, request: Request, shared: Service) -> str:
    """The body; raises UndecodableError if it is not UTF-8, and as `Uploads.body` does."""
    most_bytes, declared = shared.settings.part_limits["rules"], declared_bytes(request.headers)
    async with shared.uploads.body(request.receive, most_bytes=most_bytes, declared_bytes=declared) as body:
        try:
            return bytes(body).decode("utf-8")
        except UnicodeDecodeError as error:
            message = f"{kind.field} is not UTF-8 at byte {error.start}; send it as UTF-8"
            raise UndecodableError("text_not_utf8", message, field=kind.field) from None


def _refuse_mistakes(checked: bytes) -> None:
    """Raises InputError with the first of the mistakes that /rules/check found."""
    first, *others = json.loads(checked)["mistakes"] or [None]
    if first is not None:
        more = f"; and {len(others)} more mistakes" if others else ""
        message = f"{first['file']}:{first['line']}:{first['column']}: {first['message']}{more}; nothing was saved"
        raise InputError("file_wrong", message, field=LEXICON_FILES.field)


def _is_own_machine(request: Request) -> bool:
    """Whether the caller is on this machine; the host name is checked too, against DNS rebinding."""
    return request.client is not None and all(map(is_loopback, (request.client.host, request.url.hostname or "")))
