"""`understudy gestures`: check, list, show and draw the gesture library."""

import argparse
from collections.abc import Iterable
from pathlib import Path

from ...authoring.catalogue import load_characters, load_families, load_gestures
from ...authoring.file_checking import check_files
from ...authoring.gesture_views import Definition, draw_gestures, gestures_in, gestures_named, pose_doubts
from ...model import Hand, Level, Notice
from ...schemas.library import GesturesResponse
from ..files import require_writable, write, write_standard
from ..log import Log
from ..outputs.gesture_listings import counts, explanation, headline
from ..outputs.plot import require_plot


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
        told = GesturesResponse.of(library.definitions, load_families(characters), characters)
        write_standard(told.to_json(indent=2) + b"\n")
    else:
        _print([*map(headline, library.definitions), "", *counts(library)])


def _show(arguments: argparse.Namespace, _log: Log) -> None:
    _print(line for one in gestures_named(arguments.name) for line in (*explanation(one), ""))


def _render(arguments: argparse.Namespace, log: Log) -> None:
    require_plot(arguments.output)
    require_writable(arguments.output, field="output")
    hand = Hand(arguments.hand) if arguments.hand else None
    picture, poses, count = draw_gestures(gestures_named(arguments.name), Level(arguments.level), hand)
    write(arguments.output, picture)
    log.note(f"{poses} key poses and the speeds of {count} gestures in {arguments.output}")


def _print(lines: Iterable[str]) -> None:
    write_standard("".join(f"{line}\n" for line in lines).encode())
