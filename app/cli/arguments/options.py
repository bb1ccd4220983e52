"""Shared functions of the argument modules. They add commands and actions to a parser, and the arguments that several
commands take: the line and its annotations, the output, and the options of a performance and of a motion as described
in `understudy.option_table`.

An option may be given only once: argparse would silently drop the first of two.
"""

import argparse
from collections.abc import Callable, Iterable, Mapping
from enum import Enum
from functools import partial
from typing import Any

from ...option_table import MOTION, PERFORMANCE, Option
from ..files import InputFile, OutputName

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
    voice.add_argument("--quiet", action="store_true", help="print only errors on standard error")
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
    fields: dict[str, Any] = {"help": option.told_in_command()}
    if option.kind is bool:
        return fields | {"action": argparse.BooleanOptionalAction if option.default is None else "store_true"}
    if isinstance(option.default, (tuple, Mapping)):
        return fields | {"action": "append", "default": [], "metavar": option.metavar}
    fields |= {"type": option.kind, "default": option.default}
    return fields | ({"choices": _plain(option.choices)} if option.choices else {"metavar": option.metavar})


def _plain(choices: Iterable[str | int]) -> tuple[str | int, ...]:
    """The choices as plain values, since argparse would show members of an enumeration by their Python names."""
    return tuple(choice.value if isinstance(choice, Enum) else choice for choice in choices)


def add_manner(parser: argparse.ArgumentParser) -> None:
    """Adds the options of a performance."""
    add_options(parser, PERFORMANCE, *MANNER)


def add_form(parser: argparse.ArgumentParser) -> None:
    """Adds the options of the BML output."""
    add_options(parser, PERFORMANCE, *FORM)


def add_rate(parser: argparse.ArgumentParser) -> None:
    """Adds the options of a motion."""
    add_options(parser, MOTION, *RATE)


def add_motion(parser: argparse.ArgumentParser) -> None:
    """Adds the options of a motion and of its files."""
    add_rate(parser)
    parser.add_argument(
        "--avatar", metavar="FILE", type=InputFile, help="your own GLB or VRM, which .glb files then contain"
    )
    add_options(parser, MOTION, *FILES)


def add_reference(parser: argparse.ArgumentParser) -> None:
    """Adds the option for the speaker's usual voice, which takes one or more files."""
    add_option(parser, PERFORMANCE["reference"], type=InputFile, nargs="+", action="extend")


MOTION_HELP = (
    ".bvh, .glb, .vrma, .json, .csv (ARKit), .visemes.txt, .usda, .usdc, .usdz, .fbx (by Blender), .otio, "
    ".TextGrid, .eaf, .events.csv, .bap, .fap, "
    ".png (contact sheet) or .speed.png (wrist speeds)"
)
AUDIO_HELP = "WAV, FLAC or OGG file; - for standard input"


def add_line(parser: argparse.ArgumentParser) -> None:
    """Adds the recording, its words and their times."""
    parser.add_argument("audio", metavar="AUDIO", type=InputFile, help=AUDIO_HELP)
    add_text(parser, "the words that are spoken")
    add_words(parser, "word times from another aligner, in place of our alignment: .json, .TextGrid or .ctm")
    parser.set_defaults(functions=None, direction=None, edits=None)


def add_text(parser: argparse.ArgumentParser, help_text: str) -> None:
    """Adds the words, on the command line or in a file."""
    text = parser.add_mutually_exclusive_group(required=True)
    text.add_argument("--text", help=help_text)
    text.add_argument("--text-file", metavar="FILE", type=InputFile, help="a file with the words; - for standard input")


def add_words(parser: argparse.ArgumentParser, help_text: str) -> None:
    parser.add_argument("--words", metavar="FILE", type=InputFile, help=help_text)


def add_agitation_model(parser: argparse.ArgumentParser) -> None:
    help_text = "judge agitation with your own model, made by understudy agitation train"
    parser.add_argument("--agitation-model", metavar="MODEL", type=InputFile, help=help_text)


def add_motion_model(parser: argparse.ArgumentParser) -> None:
    help_text = "arms, trunk and head of --realize by a motion model: from understudy motion-model train, or default"
    parser.add_argument("--motion-model", metavar="MODEL", type=InputFile, help=help_text)
    help_text = (
        "what drives the motion model: voice and affect (S1, S2), voice (S3, S4), affect (S5, S6), or RTS (default S1)"
    )
    parser.add_argument("--scenario", metavar="S1…S6", help=help_text)


def add_functions(parser: argparse.ArgumentParser) -> None:
    help_text = "known communicative functions: a JSON list"
    parser.add_argument("--functions", metavar="FILE", type=InputFile, help=help_text)


def add_output(parser: argparse.ArgumentParser, metavar: str, help_text: str, *, default: str | None = None) -> None:
    """Adds the option for the output file, which is required if there is no default."""
    needed = default is None
    parser.add_argument(
        "-o", "--output", metavar=metavar, type=OutputName, required=needed, default=default, help=help_text
    )
