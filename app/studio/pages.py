"""`GET /`, and what the studio page loads: from `/studio/…` its own files and the bundled example, for which nobody
needs a key; from `/opened/…` the line that `understudy studio` opens, for which the page sends the user's key.

The page carries its style, so that it is painted before anything else has come.

The page names its files under `/studio/VERSION/…`, which is another path as soon as one of them changes: a browser
keeps what it got there, and asks for none of some two hundred files on its next visit. Otherwise files are sent with an
ETag, by which a browser that has them asks whether they are the same. They are compressed to whoever takes that. The
page may load and ask nothing but what this service has.
"""

import base64
import gzip
import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path, PurePosixPath
from types import MappingProxyType

from fastapi import APIRouter, Request
from starlette.exceptions import HTTPException
from starlette.responses import FileResponse, Response

from ..files import resource_folder
from .scenes import OpenedScene, file_inside

FOLDER = Path(__file__).parent / "page"
MEDIA_TYPES: Mapping[str, str] = MappingProxyType(
    {
        ".html": "text/html",
        ".js": "text/javascript",
        ".css": "text/css",
        ".json": "application/json",
        ".svg": "image/svg+xml",
        ".txt": "text/plain; charset=utf-8",
        ".flac": "audio/flac",
        ".ogg": "audio/ogg",
        ".wav": "audio/wav",
    }
)
"""By the ending of a file's name; files with others are not sent."""
EXAMPLE = ("example.flac", "example.txt")
SMALLEST_COMPRESSED_BYTES = 1024

_REVALIDATED = MappingProxyType({"Cache-Control": "no-cache"})
_KEPT = MappingProxyType({"Cache-Control": "public, max-age=31536000, immutable"})
_OWN_FILES = b"./studio/"
"""How the page begins the paths of its files."""
_VERSION = re.compile(r"[0-9a-f]{16}/")
_IMPORT_MAP = re.compile(rb'<script type="importmap">(.*?)</script>', re.DOTALL)
_STYLE = re.compile(rb"<style>(.*?)</style>", re.DOTALL)
_SHEETS = re.compile(rb'(?:\s*<link rel="stylesheet" href="\./studio/[^"]+" />)+')
_SHEET = re.compile(rb'href="\./studio/([^"]+)"')
_SOURCES = MappingProxyType(
    {
        "default-src": "'none'",
        "img-src": "'self' data: blob:",
        "media-src": "'self' blob:",
        "connect-src": "'self' blob:",
        "worker-src": "'self' blob:",
        "base-uri": "'none'",
        "form-action": "'none'",
        "frame-ancestors": "'none'",
    }
)


@dataclass(frozen=True, slots=True)
class OpenedLine:
    """The line with which the page was opened: its recording, the name of that file, and its words."""

    audio: bytes
    name: str
    text: str


@dataclass(frozen=True, slots=True)
class _Asset:
    """A file as it is sent; `packed` is the same compressed, None where that is not worth it."""

    content: bytes
    packed: bytes | None
    etag: str


def page_router(opened: OpenedLine | OpenedScene | None = None) -> APIRouter:
    """The paths of the page, which finds a line at `/opened/line` and `/opened/audio`, the files of a scene at
    `/opened/scene/…`."""
    router = APIRouter(include_in_schema=False)
    named = set[str]()  # the versions that this process has named; others are those of another, or of yesterday

    @router.get("/")
    def get_page(request: Request) -> Response:
        """The page."""
        version = _version()
        named.add(version)
        page = _page(version)
        policy = {"Content-Security-Policy": content_policy(page.content)}
        return _sent(request, page, ".html", {**_REVALIDATED, **policy})

    @router.get("/studio/{path:path}")
    def get_file(path: str, request: Request) -> Response:
        """What the page loads. Raises HTTPException 404."""
        version = _VERSION.match(path)
        file = _file_at(path[version.end() :] if version else path)
        is_kept = version is not None and version[0] in named
        return _sent(request, _asset_at(file), file.suffix, _KEPT if is_kept else _REVALIDATED)

    _add_opened(router, opened)
    return router


def _add_opened(router: APIRouter, opened: OpenedLine | OpenedScene | None) -> None:
    """The paths of what the page was opened with."""

    @router.get("/opened/line")
    def get_opened_line() -> dict[str, str]:
        """What the line is that the page was opened with. Raises HTTPException 404."""
        return {"name": _line(opened).name, "text": _line(opened).text}

    @router.get("/opened/audio")
    def get_opened_audio() -> Response:
        """Its recording. Raises HTTPException 404."""
        suffix = PurePosixPath(_line(opened).name).suffix.lower()
        return Response(_line(opened).audio, media_type=MEDIA_TYPES.get(suffix, "application/octet-stream"))

    @router.get("/opened/scene/{name:path}")
    def get_scene_file(name: str) -> Response:
        """A file of the scene. Raises HTTPException 404."""
        file = opened.file(name) if isinstance(opened, OpenedScene) else None
        if file is None:
            raise HTTPException(404)
        return FileResponse(file)


@lru_cache(maxsize=1)
def _page(version: str) -> _Asset:
    """The page with its style, and with the paths of a version."""
    page = _SHEETS.sub(_inlined, (FOLDER / "index.html").read_bytes())
    return _packed(page.replace(_OWN_FILES, _OWN_FILES + version.encode()))


def _inlined(sheets: re.Match[bytes]) -> bytes:
    """Style sheets as one that is in the page."""
    style = b"".join((FOLDER / name.decode()).read_bytes() for name in _SHEET.findall(sheets[0]))
    return b"<style>" + style + b"</style>"


def _version() -> str:
    """A folder named by what is in the page's files."""
    files = sorted(file for file in FOLDER.rglob("*") if file.suffix in MEDIA_TYPES)
    told = "".join(f"{file} {_asset_at(file).etag}" for file in files)
    return f"{hashlib.sha256(told.encode()).hexdigest()[:16]}/"


def _line(opened: OpenedLine | OpenedScene | None) -> OpenedLine:
    if not isinstance(opened, OpenedLine):
        raise HTTPException(404)
    return opened


def content_policy(page: bytes) -> str:
    """What browsers let `page` do: run the service's own scripts and its import map, and ask nobody else."""
    told = {"script-src": _hashes(_IMPORT_MAP, page), "style-src": _hashes(_STYLE, page)}
    own = {name: " ".join(["'self'", *hashes]) for name, hashes in told.items()}
    return "; ".join(f"{name} {sources}" for name, sources in {**_SOURCES, **own}.items())


def _hashes(inline: re.Pattern[bytes], page: bytes) -> list[str]:
    """What a policy calls the parts of a page that are let in by their content."""
    digests = [base64.b64encode(hashlib.sha256(found).digest()).decode() for found in inline.findall(page)]
    return [f"'sha256-{digest}'" for digest in digests]


def _file_at(path: str) -> Path:
    """The page's file of this path, or one of the example's. Raises HTTPException 404."""
    if path.startswith("example/") and path.removeprefix("example/") in EXAMPLE:
        return resource_folder("examples") / path.removeprefix("example/")
    found = file_inside(FOLDER.resolve(), path)
    if found is None or found.suffix not in MEDIA_TYPES:
        raise HTTPException(404)
    return found


def _sent(request: Request, asset: _Asset, suffix: str, headers: Mapping[str, str]) -> Response:
    """What is asked for, or that it is what the browser has."""
    told = {"ETag": asset.etag, "Vary": "Accept-Encoding", **headers}
    if request.headers.get("if-none-match") == asset.etag:
        return Response(status_code=304, headers=told)
    media_type = MEDIA_TYPES[suffix]
    if asset.packed is not None and "gzip" in request.headers.get("accept-encoding", ""):
        return Response(asset.packed, media_type=media_type, headers=told | {"Content-Encoding": "gzip"})
    return Response(asset.content, media_type=media_type, headers=told)


def _asset_at(file: Path) -> _Asset:
    return _asset(file, file.stat().st_mtime_ns)


@lru_cache(maxsize=512)
def _asset(file: Path, _changed_ns: int) -> _Asset:
    """The file's content, kept until it changes."""
    return _packed(file.read_bytes())


def _packed(content: bytes) -> _Asset:
    packed = gzip.compress(content, mtime=0) if len(content) >= SMALLEST_COMPRESSED_BYTES else None
    worth_it = packed is not None and len(packed) < 0.9 * len(content)
    return _Asset(content, packed if worth_it else None, f'"{hashlib.sha256(content).hexdigest()[:32]}"')
