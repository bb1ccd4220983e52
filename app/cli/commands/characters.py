"""`understudy characters`: lists, shows and draws the characters."""

import argparse

from ...authoring.catalogue import load_characters
from ...schemas.library import CharacterResponse
from ..files import require_writable, write, write_standard
from ..log import Log
from ..outputs.plot import require_plot


def run(arguments: argparse.Namespace, log: Log) -> int:
    actions = {"list": _list, "show": _show, "render": _render}
    actions[arguments.action](arguments, log)
    return 0


def _list(_arguments: argparse.Namespace, _log: Log) -> None:
    characters = load_characters().by_name.values()
    write_standard("".join(f"{each.name:16s} {each.description}\n" for each in characters).encode())


def _show(arguments: argparse.Namespace, _log: Log) -> None:
    character = load_characters().named(arguments.name)
    write_standard(CharacterResponse.of(character).to_json(indent=2) + b"\n")


def _render(arguments: argparse.Namespace, log: Log) -> None:
    from ...authoring.gesture_views import draw_characters

    require_plot(arguments.output)
    require_writable(arguments.output, field="output")
    picture, count = draw_characters(arguments.names)
    write(arguments.output, picture)
    log.note(f"{count} characters in {arguments.output}")
