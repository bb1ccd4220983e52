"""The parser of the whole command line, with every command in its order."""

import argparse
from typing import NoReturn

from ...errors import InputError
from ...version import __version__
from .batch import add_batch
from .command import commands_of, voices
from .libraries import add_characters, add_gestures, add_profiles, add_rules
from .lines import add_analyses, add_live, add_perform, add_realize, add_say, add_script
from .serving import add_serve, add_studio
from .study import add_study


class _Parser(argparse.ArgumentParser):
    """An argparse parser that raises InputError, so that usage errors look like all others, and refuses
    abbreviations."""

    def error(self, message: str) -> NoReturn:
        raise InputError("usage", f"{message}; see {self.prog} --help")


def make_parser() -> argparse.ArgumentParser:
    """The parser of the whole command line; it raises InputError `usage`."""
    parser = _Parser(
        prog="understudy",
        description="Performs a spoken line in an actor's stead: audio and words in, BML out.",
        parents=[voices()],
        allow_abbrev=False,
    )
    parser.add_argument("--version", action="version", version=__version__)
    add = commands_of(parser)
    add_perform(add)
    add_say(add)
    add_script(add)
    add_realize(add)
    add_live(add)
    add_batch(add)
    add_analyses(add)
    add_rules(add)
    add_gestures(add)
    add_characters(add)
    add_profiles(add)
    add_study(add)
    add_serve(add)
    add_studio(add)
    return parser
