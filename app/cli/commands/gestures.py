"""`understudy gestures`: check, list, show and draw the gesture library."""

import argparse
from collections.abc import Iterable, Sequence
from pathlib import Path

from ...authoring.catalogue import load_characters, load_families, load_gestures
from ...authoring.proofreading import check_files
from ...errors import InputError
from ...model import Hand, Level, Notice
from ...realizer.arms.plausibility import doubts
from ...realizer.body.skeleton import Skeleton
from ...realizer.gestures.clips import clip as clip_of
from ...realizer.gestures.gesture import Clip, Definition
from ...realizer.gestures.library import SUFFIX, gesture_files, read_definitions
from ...realizer.pictures.gesture_sheet import draw_gestures
from ...schemas.library import GesturesResponse
from ..files import require_writable, write, write_standard
from ..log import Log
from ..outputs.gesture_listings import counts, explanation, headline, place
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
        _tell_doubts(read_definitions(gesture_files(paths)), log)
        log.note(f"no mistake in {files} files")
    else:
        library = load_gestures()
        _tell_doubts(library.definitions, log)
        log.note(f"no mistake in {len(library.definitions)} gestures of {len(library.categories)} categories")


def _tell_doubts(definitions: Iterable[Definition], log: Log) -> None:
    skeleton = Skeleton.standing()
    for definition in definitions:
        for doubt in doubts(skeleton, definition):
            where = f"{place(definition)}: {definition.name}, frame {doubt.time:g}, {doubt.level} agitation"
            log.warnings([Notice("pose_out_of_reach", doubt.message)], of=where)


def _list(arguments: argparse.Namespace, _log: Log) -> None:
    library = load_gestures()
    if arguments.json:
        characters = load_characters()
        told = GesturesResponse.of(library.definitions, load_families(characters), characters)
        write_standard(told.to_json(indent=2) + b"\n")
    else:
        _print([*map(headline, library.definitions), "", *counts(library)])


def _show(arguments: argparse.Namespace, _log: Log) -> None:
    _print(line for one in _named(arguments.name) for line in (*explanation(one), ""))


def _render(arguments: argparse.Namespace, log: Log) -> None:
    require_plot(arguments.output)
    require_writable(arguments.output, field="output")
    hand = Hand(arguments.hand) if arguments.hand else None
    named = _named(arguments.name)
    clips = [clip for one in named for clip in _fitting(one, Level(arguments.level), hand)]
    if not clips:
        raise InputError("unfit_gesture", f"{arguments.name} is not for {arguments.level} agitation", field="level")
    picture, poses = draw_gestures(Skeleton.standing(), clips)
    write(arguments.output, picture)
    log.note(f"{poses} key poses and the speeds of {len(clips)} gestures in {arguments.output}")


def _fitting(definition: Definition, level: Level, hand: Hand | None) -> Sequence[Clip]:
    if level not in definition.levels:
        return ()
    return (clip_of(definition, level, hand or definition.hand or Hand.RIGHT, definition.categories[0]),)


def _named(name: str) -> Sequence[Definition]:
    """The gestures of a category or in a file, or the gesture of that name; raises InputError `unknown_name`."""
    if name.endswith(SUFFIX):
        return read_definitions([Path(name)])
    library = load_gestures()
    return library.by_category.get(name) or (library.definition(name),)


def _print(lines: Iterable[str]) -> None:
    write_standard("".join(f"{line}\n" for line in lines).encode())
