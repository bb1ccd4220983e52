"""Adds a command, or an action of a command, to those of a parser.

Options that may be given only once: argparse would silently drop the first of two.
"""

import argparse
from collections.abc import Callable
from functools import partial

Adding = Callable[[str, str], argparse.ArgumentParser]
"""Adds a command, given its name and what it does."""


def commands_of(parser: argparse.ArgumentParser) -> Adding:
    """Adds commands to the top-level parser."""
    return partial(_add, parser.add_subparsers(dest="command", metavar="COMMAND", required=True).add_parser)


def actions_of(command: argparse.ArgumentParser) -> Adding:
    """Adds actions to a command."""
    return partial(_add, command.add_subparsers(dest="action", metavar="ACTION", required=True).add_parser)


def _add(add_parser: Callable[..., argparse.ArgumentParser], name: str, does: str) -> argparse.ArgumentParser:
    parser = add_parser(name, help=does, description=does, parents=[voices()], allow_abbrev=False)
    parser.register("action", None, Once)
    parser.add_argument(
        "--lexicon",
        metavar="DIR",
        action="append",
        default=argparse.SUPPRESS,
        help="your own words, rules, gestures, characters and profiles, laid over the bundled ones; repeatable",
    )
    return parser


def voices() -> argparse.ArgumentParser:
    """`--quiet` and `--json-log`, before or after the command's name; `understudy.cli.log` looks for them."""
    parser = argparse.ArgumentParser(add_help=False)
    voice = parser.add_mutually_exclusive_group()
    voice.add_argument("--quiet", action="store_true", help="say nothing on standard error but errors")
    voice.add_argument("--json-log", action="store_true", help="one JSON object a line on standard error")
    return parser


class Once(argparse.Action):
    """Stores the value of an argument, and refuses an option that was given before on the same command line."""

    _is_given = False

    def __call__(
        self,
        parser: argparse.ArgumentParser,
        namespace: argparse.Namespace,
        values: object,
        option_string: str | None = None,
    ) -> None:
        if option_string and self._is_given:
            parser.error(f"{option_string} is given twice; give it once")
        self._is_given = True
        setattr(namespace, self.dest, values)
