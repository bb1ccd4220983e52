"""Arguments for the options of a performance and of a motion, as `understudy.option_table` describes them."""

import argparse
from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any

from ...option_table import MOTION, PERFORMANCE, Option
from ..distinct_files import InputFile

MANNER = ("character", "agitation", "affect", "seed", "choice", "profile", "mode", "lead_in_s", "stillness", "targets")
FORM = ("timing", "dialect", "visemes", "bmlt_audio")
RATE = ("fps", "skeleton", "physics")
FILES = ("tail_s", "t_pose", "root_at_origin", "bap_version", "keys")


def add_options(parser: argparse.ArgumentParser, table: Mapping[str, Option], *names: str) -> None:
    """Adds the options of these names in a table."""
    for name in names:
        add_option(parser, table[name])


def add_option(parser: argparse.ArgumentParser, option: Option, **otherwise: Any) -> None:  # noqa: ANN401 - argparse's
    """Adds an option; `otherwise` are arguments of argparse that this command needs instead."""
    parser.add_argument(option.argument, **(_described(option) | otherwise))


def _described(option: Option) -> dict[str, Any]:
    """The arguments with which argparse adds the option."""
    told: dict[str, Any] = {"help": option.told_in_command()}
    if option.kind is bool:
        return told | {"action": argparse.BooleanOptionalAction if option.default is None else "store_true"}
    if isinstance(option.default, (tuple, Mapping)):
        return told | {"action": "append", "default": [], "metavar": option.metavar}
    told |= {"type": option.kind, "default": option.default}
    return told | ({"choices": _plain(option.choices)} if option.choices else {"metavar": option.metavar})


def _plain(choices: Iterable[str | int]) -> tuple[str | int, ...]:
    """The choices without their enumeration, whose members argparse would name as Python writes them."""
    return tuple(choice.value if isinstance(choice, Enum) else choice for choice in choices)


def add_manner(parser: argparse.ArgumentParser) -> None:
    """How lines are performed."""
    add_options(parser, PERFORMANCE, *MANNER)


def add_form(parser: argparse.ArgumentParser) -> None:
    """How BML is written."""
    add_options(parser, PERFORMANCE, *FORM)


def add_rate(parser: argparse.ArgumentParser) -> None:
    """How motion is made."""
    add_options(parser, MOTION, *RATE)


def add_motion(parser: argparse.ArgumentParser) -> None:
    """How motion is made and its files are written."""
    add_rate(parser)
    parser.add_argument("--avatar", metavar="FILE", type=InputFile, help="your own GLB or VRM, to be animated in .glb")
    add_options(parser, MOTION, *FILES)


def add_reference(parser: argparse.ArgumentParser) -> None:
    """How the speaker usually sounds: files, so that one or more are taken."""
    add_option(parser, PERFORMANCE["reference"], type=InputFile, nargs="+", action="extend")
