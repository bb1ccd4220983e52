"""`understudy gestures`: check, list and show the gesture library."""

import argparse
from collections.abc import Iterable, Sequence
from pathlib import Path

from app.answers import GesturesAnswer
from app.catalogue import load_gestures
from app.cli.files import write_standard
from app.cli.gesture_listings import counts, explanation, headline
from app.cli.log import Log
from app.proofreading import check_files
from app.realizer.gesture import Definition
from app.realizer.library import Library


def run(arguments: argparse.Namespace, log: Log) -> int:
    actions = {"check": _check, "list": _list, "show": _show}
    actions[arguments.action](arguments, log)
    return 0


def _check(arguments: argparse.Namespace, log: Log) -> None:
    """Every mistake is raised; without one, one line on standard error says what was checked."""
    if arguments.paths:
        log.note(f"no mistake in {check_files([Path(path) for path in arguments.paths])} files")
    else:
        library = load_gestures()
        log.note(f"no mistake in {len(library.definitions)} gestures of {len(library.categories)} categories")


def _list(arguments: argparse.Namespace, _log: Log) -> None:
    library = load_gestures()
    if arguments.json:
        write_standard(GesturesAnswer.of(library.definitions).to_json(indent=2) + b"\n")
    else:
        _print([*map(headline, library.definitions), "", *counts(library)])


def _show(arguments: argparse.Namespace, _log: Log) -> None:
    _print(line for one in _named(load_gestures(), arguments.name) for line in (*explanation(one), ""))


def _named(library: Library, name: str) -> Sequence[Definition]:
    """The gestures of a category, or the gesture of that name; raises InputError `unknown_name`."""
    return library.by_category.get(name) or (library.definition(name),)


def _print(lines: Iterable[str]) -> None:
    write_standard("".join(f"{line}\n" for line in lines).encode())
