"""Writes the page as a folder of static files that any browser opens, from a disk or a web server, without this
service.

`index.html` has the page's modules, style and plan in itself. Motion and bodies are loaded when they are needed: from a
disk browsers load only what is a script, so each is a script that hands over its content by an event.
"""

import base64
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from ...batch.work.files import clear_unfinished, write_whole
from ...errors import InputError
from ..comparison import DIMENSIONS, HIGHEST, LOWEST, MOST_UNDERSTOOD, UNDECIDED, UNDERSTOOD, Comparison
from .inlining import Modules, packages_of
from .ordering import rater_orders

PAGE = Path(__file__).resolve().parents[1] / "page"
CLIPS = "clips"
CODE_LENGTH = 10
_CODED = re.compile(rf"[0-9a-f]{{{CODE_LENGTH}}}\.(js|flac)")
STUDIO = PAGE.parents[1] / "studio" / "page"


@dataclass(frozen=True, slots=True)
class LinePage:
    """A line on the page: the names of its recording, its body and its clips, in no telling order."""

    sound: str
    body: str
    clips: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Site:
    """All of the page: its name, what is compared, its lines, and the files that are not in `index.html`, by path."""

    name: str
    comparison: Comparison
    lines: tuple[LinePage, ...]
    files: Mapping[str, bytes] = field(repr=False)


def script_of(name: str, content: str) -> bytes:
    """A script that publishes `content` under a name."""
    detail = json.dumps({"name": name, "content": content})
    return f"dispatchEvent(new CustomEvent('study-file', {{ detail: {detail} }}));\n".encode()


def script_of_bytes(name: str, content: bytes) -> bytes:
    """The same of bytes, in base64."""
    return script_of(name, base64.b64encode(content).decode())


def write_site(folder: Path, site: Site) -> None:
    """Writes the page whole; raises InputError `file_unwritable`."""
    try:
        for name, content in {**site.files, "index.html": _index(site).encode()}.items():
            write_whole(folder, name, content)
        _remove_others(folder, site)
        clear_unfinished(folder)
    except OSError as error:
        raise InputError("file_unwritable", f"{folder}: cannot be written: {error.strerror}", field="out") from None


def _remove_others(folder: Path, site: Site) -> None:
    """Removes the clips of an earlier study in the same folder."""
    for path in (folder / CLIPS).iterdir():
        if _CODED.fullmatch(path.name) and f"{CLIPS}/{path.name}" not in site.files:
            path.unlink()


def _index(site: Site) -> str:
    """The page's HTML with everything in its place."""
    modules = Modules(PAGE.parents[1], packages_of(STUDIO / "index.html", "./studio/"))
    first = PAGE / "main.js"
    page = (PAGE / "index.html").read_text(encoding="utf-8")
    for mark, text in {
        "STYLE": (PAGE / "study.css").read_text(encoding="utf-8"),
        "IMPORTS": modules.import_map(first),
        "PLAN": json.dumps(_plan(site), separators=(",", ":")).replace("<", "\\u003c"),
        "FIRST": modules.name(first),
    }.items():
        page = page.replace(f"%{mark}%", text)
    return page


def _plan(site: Site) -> dict[str, object]:
    """The plan of the page: what each rater sees, and the questions."""
    return {
        "name": site.name,
        "comparison": site.comparison.value,
        "lines": [{"sound": each.sound, "body": each.body, "clips": each.clips} for each in site.lines],
        "orders": list(_orders(site.lines)),
        "grades": [LOWEST, HIGHEST],
        "dimensions": DIMENSIONS,
        "undecided": UNDECIDED,
        "understood": [UNDERSTOOD, MOST_UNDERSTOOD],
    }


def _orders(lines: Sequence[LinePage]) -> Iterator[list[tuple[int, tuple[int, ...]]]]:
    for order in rater_orders(len(lines), len(lines[0].clips)):
        yield list(order)
