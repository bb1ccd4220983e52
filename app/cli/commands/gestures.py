"""`understudy gestures`: checks, lists, shows and draws the gesture library."""

import argparse
from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from ...authoring.catalogue import load_characters, load_families, load_gestures
from ...authoring.file_checking import check_files
from ...authoring.gesture_views import (
    Definition,
    Library,
    clips_by_level,
    draw_gestures,
    gestures_in,
    gestures_named,
    place_of,
    pose_doubts,
)
from ...model import Hand, Level, Notice
from ...schemas.library import GesturesResponse
from ..files import require_writable, write, write_standard
from ..log import Log
from ..outputs.plot import require_plot

_FACTORS = ("amplitude", "tempo", "fluidity", "power", "repetition")
_MARKERS = ("ready", "stroke_start", "stroke", "stroke_end", "relax", "end")


def run(arguments: argparse.Namespace, log: Log) -> int:
    actions = {"check": _check, "list": _list, "show": _show, "render": _render}
    actions[arguments.action](arguments, log)
    return 0


def _check(arguments: argparse.Namespace, log: Log) -> None:
    """Raises every mistake; if there is none, warns of poses that the body cannot take, and says what was checked."""
    paths = [Path(path) for path in arguments.paths]
    if paths:
        files = check_files(paths)
        _tell_doubts(gestures_in(paths), log)
        log.note(f"no mistake in {files} files")
    else:
        library = load_gestures()
        _tell_doubts(library.definitions, log)
        log.note(f"no mistake in {len(library.definitions)} gestures of {len(library.categories)} categories")


def _tell_doubts(definitions: Iterable[Definition], log: Log) -> None:
    for where, message in pose_doubts(definitions):
        log.warnings([Notice("pose_out_of_reach", message)], of=where)


def _list(arguments: argparse.Namespace, _log: Log) -> None:
    library = load_gestures()
    if arguments.json:
        characters = load_characters()
        response = GesturesResponse.of(library.definitions, load_families(characters), characters)
        write_standard(response.to_json(indent=2) + b"\n")
    else:
        _print([*map(_headline, library.definitions), "", *_counts(library)])


def _show(arguments: argparse.Namespace, _log: Log) -> None:
    _print(line for one in gestures_named(arguments.name) for line in (*_explanation(one), ""))


def _render(arguments: argparse.Namespace, log: Log) -> None:
    require_plot(arguments.output)
    require_writable(arguments.output, field="output")
    hand = Hand(arguments.hand) if arguments.hand else None
    picture, poses, count = draw_gestures(gestures_named(arguments.name), Level(arguments.level), hand)
    write(arguments.output, picture)
    log.note(f"{poses} key poses and the speeds of {count} gestures in {arguments.output}")


def _print(lines: Iterable[str]) -> None:
    write_standard("".join(f"{line}\n" for line in lines).encode())


def _headline(definition: Definition) -> str:
    arms = definition.hand or "one"
    levels = "" if len(definition.levels) == len(Level) else f" ({', '.join(definition.levels)})"
    shows = ", ".join(definition.categories) + (" at a target" if definition.aimed else "") + levels
    return f"{definition.name:32s} {definition.gesture_class:11s} {arms:6s} {shows:40s} {place_of(definition)}"


def _counts(library: Library) -> Iterator[str]:
    """How many gestures each category has, for one hand and for both."""
    yield f"{'category':32s}{'one hand':>10s}{'both':>10s}"
    for category, definitions in library.by_category.items():
        both = sum(one.hand is Hand.BOTH for one in definitions)
        yield f"{category:32s}{len(definitions) - both or '':>10}{both or '':>10}"
    yield f"{len(library.categories)} categories, {len(library.definitions)} gestures"


def _explanation(definition: Definition) -> Iterator[str]:
    """A gesture as in its file, with its expressivity and times at each level."""
    yield f"{definition.name}: {place_of(definition)}"
    yield from (f"    {line}" for line in _source(definition))
    yield f"  {'':8s}" + "".join(f"{name:>13s}" for name in (*_FACTORS, "stroke m/s"))
    clips = clips_by_level(definition)
    for one in clips:
        factors = [getattr(one.expressivity, name) for name in _FACTORS]
        yield f"  {one.level:8s}" + _numbers([*factors, one.stroke_speed_m_s])
    yield f"  {'':8s}" + "".join(f"{name + ' s':>15s}" for name in _MARKERS)
    for one in clips:
        yield f"  {one.level:8s}" + "".join(f"{getattr(one.markers, name):15.3f}" for name in _MARKERS)


def _numbers(values: Iterable[float]) -> str:
    return "".join(f"{value:13.2f}" for value in values)


def _source(definition: Definition) -> Sequence[str]:
    """The gesture's lines in its file, with the comment directly above them."""
    lines = _lines(definition.path)
    first = definition.line - 1
    last = next((k for k in range(first + 1, len(lines)) if lines[k].startswith("GESTURECLASS")), len(lines))
    while first > 0 and lines[first - 1].lstrip().startswith("#"):
        first -= 1
    while last > first and (not lines[last - 1].strip() or lines[last - 1].lstrip().startswith("#")):
        last -= 1
    return lines[first:last]


def _lines(path: Path | None) -> Sequence[str]:
    return path.read_text(encoding="utf-8-sig").splitlines() if path else ()
