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
import json
import os
import posixpath
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path, PurePosixPath
from types import MappingProxyType
from typing import Self

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
_MAIN = b'<script type="module"'
_IMPORTED = re.compile(r'^(?:import|export)\b(?:[^;"=(]*\bfrom)?\s*"([^"]+)";', re.MULTILINE)
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
    """A file as it is sent."""

    content: bytes
    etag: str

    @classmethod
    def of(cls, content: bytes) -> Self:
        return cls(content, f'"{hashlib.sha256(content).hexdigest()[:32]}"')


def page_router(opened: OpenedLine | OpenedScene | None = None) -> APIRouter:
    """The paths of the page, which finds a line at `/opened/line` and `/opened/audio`, the files of a scene at
    `/opened/scene/…`."""
    router = APIRouter(include_in_schema=False)
    named = set[str]()  # the versions that this process has named; others are those of another, or of yesterday

    @router.get("/")
    async def get_page(request: Request) -> Response:
        """The page. Asynchronous, since a visit begins with it and a thread would have to be woken first."""
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
    """The page with its style, with the modules that it begins with named in advance, so that they are asked for at
    once and not one after the other; and with the paths of a version."""
    page = _SHEETS.sub(_inlined, (FOLDER / "index.html").read_bytes())
    links = "".join(f'<link rel="modulepreload" href="./studio/{name}" />' for name in _first_modules(page))
    page = page.replace(_MAIN, links.encode() + _MAIN)
    return _Asset.of(page.replace(_OWN_FILES, _OWN_FILES + version.encode()))


def _first_modules(page: bytes) -> list[str]:
    """The modules that `main.js` imports, and theirs; not those that it loads later (`import(…)`)."""
    found = _IMPORT_MAP.search(page)
    named: dict[str, str] = json.loads(found[1])["imports"] if found else {}
    modules = ["main.js"]
    for module in modules:  # which grows
        for told in _IMPORTED.findall((FOLDER / module).read_text("utf-8")):
            path = named[told].removeprefix("./studio/") if told in named else posixpath.join(module, "..", told)
            path = posixpath.normpath(path)
            modules += [] if path in modules else [path]
    return modules[1:]


def _inlined(sheets: re.Match[bytes]) -> bytes:
    """Style sheets as one that is in the page."""
    style = b"".join((FOLDER / name.decode()).read_bytes() for name in _SHEET.findall(sheets[0]))
    return b"<style>" + style + b"</style>"


def _version() -> str:
    """A folder named by what is in the page's files."""
    return _version_of(tuple(sorted(_files(FOLDER))))


def _files(folder: str | Path) -> Iterator[tuple[str, int]]:
    """The page's files, and when each was changed, nanoseconds: a look at two hundred files takes a millisecond."""
    with os.scandir(folder) as entries:
        for entry in entries:
            if entry.is_dir():
                yield from _files(entry.path)
            elif PurePosixPath(entry.name).suffix in MEDIA_TYPES:
                yield entry.path, entry.stat().st_mtime_ns


@lru_cache(maxsize=1)
def _version_of(files: tuple[tuple[str, int], ...]) -> str:
    listed = "".join(f"{name} {_asset(Path(name), changed_ns).etag}" for name, changed_ns in files)
    return f"{hashlib.sha256(listed.encode()).hexdigest()[:16]}/"


def _line(opened: OpenedLine | OpenedScene | None) -> OpenedLine:
    if not isinstance(opened, OpenedLine):
        raise HTTPException(404)
    return opened


def content_policy(page: bytes) -> str:
    """What browsers let `page` do: run the service's own scripts and its import map, and ask nobody else."""
    directives = {"script-src": _hashes(_IMPORT_MAP, page), "style-src": _hashes(_STYLE, page)}
    own = {name: " ".join(["'self'", *hashes]) for name, hashes in directives.items()}
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
    sent = {"ETag": asset.etag, "Vary": "Accept-Encoding", **headers}
    if request.headers.get("if-none-match") == asset.etag:
        return Response(status_code=304, headers=sent)
    media_type = MEDIA_TYPES[suffix]
    packed = _packed(asset.content) if "gzip" in request.headers.get("accept-encoding", "") else None
    if packed is not None:
        return Response(packed, media_type=media_type, headers=sent | {"Content-Encoding": "gzip"})
    return Response(asset.content, media_type=media_type, headers=sent)


def _asset_at(file: Path) -> _Asset:
    return _asset(file, file.stat().st_mtime_ns)


@lru_cache(maxsize=512)
def _asset(file: Path, _changed_ns: int) -> _Asset:
    """The file's content, kept until it changes."""
    return _Asset.of(file.read_bytes())


@lru_cache(maxsize=512)
def _packed(content: bytes) -> bytes | None:
    """The same compressed, when it is asked for first; None where that is not worth it."""
    packed = gzip.compress(content, mtime=0) if len(content) >= SMALLEST_COMPRESSED_BYTES else None
    return packed if packed is not None and len(packed) < 0.9 * len(content) else None
