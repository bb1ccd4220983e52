"""The parser of the whole command line, with every command in its order."""

import argparse
import sys
from collections.abc import Sequence
from typing import Any, NoReturn

from ...errors import InputError
from ...version import __version__
from .batch import add_batch
from .command import commands_of, voices
from .libraries import add_characters, add_gestures, add_motion_models, add_profiles, add_rules
from .lines import add_analyses, add_live, add_perform, add_realize, add_say, add_script
from .serving import add_serve, add_studio
from .study import add_study

_TRAIN = "agitation train"


class _Parser(argparse.ArgumentParser):
    """An argparse parser that raises InputError, so that usage errors look like all others, and refuses
    abbreviations."""

    def parse_args(self, args: Sequence[str] | None = None, namespace: Any = None) -> Any:  # type: ignore[override]  # noqa: ANN401
        """Joins the two words of `agitation train`: what follows `agitation` is else a recording."""
        words = list(sys.argv[1:] if args is None else args)
        place = next((index for index in range(len(words) - 1) if words[index : index + 2] == _TRAIN.split()), None)
        if place is not None:
            words[place : place + 2] = [_TRAIN]
        return super().parse_args(words, namespace)

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
    add_motion_models(add)
    add_study(add)
    add_serve(add)
    add_studio(add)
    return parser
