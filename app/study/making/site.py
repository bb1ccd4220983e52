"""Writes the page as a folder of static files that any browser opens, from a disk or a web server, without this
service.

`index.html` contains the page's modules, style and plan. Motion and bodies are loaded on demand. Browsers load only
scripts from a disk, so each of these files is a script that delivers its content by an event.

The page's ES modules are inlined, because browsers do not load modules from files (`file://`). Each required module
becomes a `data:` URL in the page's import map, under the module's path. The names of packages are those of the studio's
import map.

A clip consists of the motion, the recording as FLAC, and the body of its character. A clip must not reveal its
condition, so names, reasons and decisions are stripped from the motion, and tags from the recording.

The orders of lines and clips come from balanced Latin squares. In a Williams square each item occurs once in each row,
equally often in each position, and equally often directly after each other item. Raters take the rows in turn, so
orders are balanced after each complete square.
"""

import base64
import io
import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from math import lcm
from pathlib import Path

import soundfile

from ...batch.work.files import clear_unfinished, write_whole
from ...errors import InputError, ServiceError, UndecodableError
from ...library.motion import PreparedSchedule, RealizedSchedule, realize_prepared, write_realized
from ...model import Schedule
from ...model.formats import MotionFormat
from ...models import Understudy
from ..comparison import DIMENSIONS, HIGHEST, LOWEST, MOST_UNDERSTOOD, MUCH, UNDECIDED, UNDERSTOOD, Comparison

FRAME_RATE_HZ = 30
"""The frame rate of clips; the page interpolates between frames."""

TAIL_S = 1.0
"""The motion continues for this long after the recording, so that the hands come to rest."""

_TELLING = ("events", "decisions", "notices")


def realized(models: Understudy, prepared: PreparedSchedule) -> RealizedSchedule:
    """The motion of a schedule, with its tail."""
    return realize_prepared(models.realizer, prepared, frame_rate_hz=FRAME_RATE_HZ, tail_s=TAIL_S)


def blind_clip(models: Understudy, found: RealizedSchedule) -> str:
    """The motion as JSON (docs/motion-formats.md), without anything that reveals its condition."""
    clip = json.loads(write_realized(found, models.realizer, MotionFormat.JSON))
    return json.dumps(clip | {name: [] for name in _TELLING}, separators=(",", ":"))


def body_of(models: Understudy, character: str) -> bytes:
    """The mannequin of a character, at rest, as GLB."""
    still = PreparedSchedule(Schedule((), duration_s=1 / FRAME_RATE_HZ, character=character, stillness=1.0), ())
    standing = realize_prepared(models.realizer, still, frame_rate_hz=FRAME_RATE_HZ)
    return write_realized(standing, models.realizer, MotionFormat.GLB)


def blind_sound(audio: bytes) -> bytes:
    """The recording as FLAC; raises UndecodableError `audio_undecodable`."""
    try:
        samples, rate_hz = soundfile.read(io.BytesIO(audio), dtype="float32", always_2d=True)
    except soundfile.LibsndfileError as error:
        raise UndecodableError("audio_undecodable", f"cannot be read as sound: {error}", field="audio") from None
    content = io.BytesIO()
    soundfile.write(content, samples, rate_hz, format="FLAC", subtype="PCM_16")
    return content.getvalue()


PAGE = Path(__file__).resolve().parents[1] / "page"
CLIPS = "clips"
CODE_LENGTH = 10
_CODED = re.compile(rf"[0-9a-f]{{{CODE_LENGTH}}}\.(js|flac)")
STUDIO = PAGE.parents[1] / "studio" / "page"


@dataclass(frozen=True, slots=True)
class LinePage:
    """A line on the page: the names of its recording, its body and its clips; the order of the clips does not reveal
    their conditions."""

    sound: str
    body: str
    clips: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Site:
    """The content of the page: its name, its comparison, its lines, the files beside `index.html` by path, and, for a
    comparison of speakers, the introductory clip of each speaker (`training`)."""

    name: str
    comparison: Comparison
    lines: tuple[LinePage, ...]
    files: Mapping[str, bytes] = field(repr=False)
    training: tuple[tuple[str, LinePage], ...] = ()


def script_of(name: str, content: str) -> bytes:
    """A script that publishes `content` under a name."""
    detail = json.dumps({"name": name, "content": content})
    return f"dispatchEvent(new CustomEvent('study-file', {{ detail: {detail} }}));\n".encode()


def script_of_bytes(name: str, content: bytes) -> bytes:
    """A script that publishes bytes, in base64, under a name."""
    return script_of(name, base64.b64encode(content).decode())


def write_site(folder: Path, site: Site) -> None:
    """Writes the complete page; raises InputError `file_unwritable`."""
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
    """The page's HTML with modules, style and plan inserted."""
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
    """The plan of the page: the order of clips for each rater, and the questions."""
    return {
        "name": site.name,
        "comparison": site.comparison.value,
        "lines": [_shown(each) for each in site.lines],
        "training": [{"speaker": name, **_shown(each)} for name, each in site.training],
        "orders": list(_line_orders(site.lines)),
        "grades": [LOWEST, HIGHEST],
        "much": MUCH,
        "dimensions": DIMENSIONS,
        "undecided": UNDECIDED,
        "understood": [UNDERSTOOD, MOST_UNDERSTOOD],
    }


def _shown(line: LinePage) -> dict[str, object]:
    return {"sound": line.sound, "body": line.body, "clips": line.clips}


def _line_orders(lines: Sequence[LinePage]) -> Iterator[list[tuple[int, tuple[int, ...]]]]:
    for order in rater_orders(len(lines), len(lines[0].clips)):
        yield list(order)


_IMPORTED = re.compile(r"""((?:\bfrom|\bimport)\s*)(["'])([^"'\n]+)\2""")
_IMPORT_MAP = re.compile(r'<script type="importmap">(.*?)</script>', re.DOTALL)
_BLOCK_COMMENT = re.compile(r"/\*.*?\*/", re.DOTALL)


class Modules:
    """The modules in a folder, and the locations of the packages they import."""

    def __init__(self, root: Path, packages: Mapping[str, Path]) -> None:
        self._root, self._packages = root, packages

    def import_map(self, first: Path) -> str:
        """The import map (JSON) of the module and all its direct and indirect imports.

        Raises ServiceError `installation_incomplete`.
        """
        found: dict[str, str] = {}
        waiting = [first]
        while waiting:
            path = waiting.pop()
            name = self.name(path)
            if name not in found:
                found[name] = _address(self._named(path))
                waiting += self._imported(path)
        return json.dumps({"imports": found}, separators=(",", ":"))

    def name(self, path: Path) -> str:
        """The name of a module in the import map."""
        return path.relative_to(self._root).as_posix()

    def _named(self, path: Path) -> str:
        """The module's text, with its imports replaced by their names in the map."""

        def renamed(match: re.Match[str]) -> str:
            target = self._target(path, match[3])
            return match[0] if target is None else f"{match[1]}{match[2]}{self.name(target)}{match[2]}"

        return _IMPORTED.sub(renamed, _text(path))

    def _imported(self, path: Path) -> Iterator[Path]:
        targets = (self._target(path, match[3]) for match in _IMPORTED.finditer(_text(path)))
        yield from (target for target in targets if target is not None)

    def _target(self, path: Path, named: str) -> Path | None:
        """The file that an import names; None if the text only looks like an import."""
        if named.startswith("."):
            return (path.parent / named).resolve()
        longest = max((name for name in self._packages if _is_in(named, name)), key=len, default=None)
        return None if longest is None else self._packages[longest] / named.removeprefix(longest)


def packages_of(page: Path, at: str) -> dict[str, Path]:
    """The packages of a page's import map; `at` is the URL path of the page's folder."""
    match = _IMPORT_MAP.search(page.read_text(encoding="utf-8"))
    named = json.loads(match[1])["imports"] if match else {}
    return {name: (page.parent / address.removeprefix(at)).resolve() for name, address in named.items()}


def _is_in(named: str, package: str) -> bool:
    return named == package or (package.endswith("/") and named.startswith(package))


def _text(path: Path) -> str:
    """A module's text without its comments, which may mention other modules."""
    try:
        text = path.read_text(encoding="utf-8")
    except OSError:
        message = f"the studio's {path.name} is missing at {path}; reinstall understudy"
        raise ServiceError("installation_incomplete", message) from None
    return text if "/vendor/" in path.as_posix() else _BLOCK_COMMENT.sub("", text)


def _address(module: str) -> str:
    return f"data:text/javascript;base64,{base64.b64encode(module.encode()).decode()}"


Order = tuple[int, ...]


def williams_square(count: int) -> tuple[Order, ...]:
    """The orders of `count` items: `count` rows, or twice as many if the count is odd."""
    first = [place // 2 if place % 2 == 0 else count - 1 - place // 2 for place in range(count)]
    rows = [tuple((thing + shift) % count for thing in first) for shift in range(count)]
    return tuple(rows) if count % 2 == 0 else tuple(rows + [row[::-1] for row in rows])


def rater_orders(lines: int, clips: int) -> tuple[tuple[tuple[int, Order], ...], ...]:
    """For each rater, until the orders repeat: the order of the lines, each with the order of its clips.

    Over the raters each line has every order of its clips equally often; the orders of one rater differ between lines.
    """
    squares = williams_square(lines), williams_square(clips)
    raters = range(lcm(len(squares[0]), len(squares[1])))
    return tuple(_orders(squares, rater) for rater in raters)


def _orders(squares: tuple[Sequence[Order], Sequence[Order]], rater: int) -> tuple[tuple[int, Order], ...]:
    of_lines, of_clips = squares
    return tuple((line, of_clips[(rater + line) % len(of_clips)]) for line in of_lines[rater % len(of_lines)])
