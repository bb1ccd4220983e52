"""`understudy rules`: checks, lists, explains and traces what authors edit.

Each action imports what it needs: checking rules requires no parser and no aligner.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterable, Sequence
from itertools import chain
from pathlib import Path
from typing import TYPE_CHECKING

from ...authoring.file_checking import check_files
from ...authoring.proofreading import check_files_in_use
from ...errors import AuthoringError
from ..files import read_bytes, write_standard
from ..log import Log

if TYPE_CHECKING:
    from ...authoring.inspection import Trace
    from ...settings import Settings


def run(arguments: argparse.Namespace, log: Log) -> int:
    actions = {"check": _check, "list": _list, "explain": _explain, "trace": _trace, "unused": _unused}
    actions[arguments.action](arguments, log)
    return 0


def _check(arguments: argparse.Namespace, log: Log) -> None:
    """Raises every mistake; if there is none, a line on standard error says what was checked."""
    paths = [Path(path) for path in arguments.paths]
    if arguments.watch:
        _watch(paths, log)
    else:
        _check_once(paths, log)


def _check_once(paths: Sequence[Path], log: Log) -> None:
    if paths:
        log.note(f"no mistake in {check_files(paths)} files")
    else:
        check_files_in_use()
        log.note("no mistake in rules, words, characters, gestures and tables")


def _watch(paths: Sequence[Path], log: Log) -> None:
    """Checks now and at each save, until interrupted; mistakes are logged, not raised."""
    from ...authoring.watching import files_in_use, saves

    saved = saves(paths or files_in_use())  # before the first check, so that no save is missed
    for _ in chain([None], saved):
        try:
            _check_once(paths, log)
        except AuthoringError as error:
            log.error(error)


def _list(arguments: argparse.Namespace, _log: Log) -> None:
    from ...authoring.catalogue import Catalogue
    from ...schemas.library import RulesResponse
    from ..outputs.listings import counts, headline

    items = Catalogue.load().items
    if arguments.json:
        write_standard(RulesResponse.of(items).to_json(indent=2) + b"\n")
    else:
        _print([*map(headline, items), "", *counts(items)])


def _explain(arguments: argparse.Namespace, _log: Log) -> None:
    from ...authoring.catalogue import Catalogue
    from ..outputs.listings import explanation

    catalogue = Catalogue.load()
    _print(line for item in catalogue.named(arguments.name) for line in explanation(catalogue, item))


def _trace(arguments: argparse.Namespace, _log: Log) -> None:
    from ...authoring.inspection import trace, trace_one
    from ...models import Understudy
    from ...settings import read_settings
    from ..outputs.listings import trace_lines

    settings = read_settings()
    if arguments.audio is not None and arguments.rule is None:
        _print(trace_lines(_trace_heard(arguments, settings)))
        return
    understudy = Understudy.for_words(settings)
    if arguments.rule is None:
        found = trace(understudy, arguments.text, arguments.character)
    else:
        found = trace_one(understudy, arguments.text, rule=arguments.rule)
    _print(trace_lines(found))


def _trace_heard(arguments: argparse.Namespace, settings: Settings) -> Trace:
    from ...authoring.inspection import trace_heard
    from ...library.performing import analyze_line
    from ...model import Line
    from ...models import Understudy

    sound = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    with Understudy.load(settings) as understudy:
        analysis = analyze_line(understudy, Line(sound, arguments.text))
        return trace_heard(understudy, analysis, arguments.character)


def _unused(arguments: argparse.Namespace, _log: Log) -> None:
    from ...authoring.inspection import find_unused
    from ...models import BehaviorModels, LanguageModels
    from ...settings import read_settings
    from ..inputs.function_lines import read_corpus
    from ..outputs.listings import unused_lines

    settings = read_settings()
    texts = read_corpus(arguments.corpus)
    _print(unused_lines(find_unused(LanguageModels.load(settings), BehaviorModels.load(settings), texts)))


def _print(lines: Iterable[str]) -> None:
    write_standard("".join(f"{line}\n" for line in lines).encode())
