"""Arguments that several commands take: the line, what is known of it, the output, and the options of a performance and
of a motion as `understudy.option_table` describes them.
"""

import argparse
from collections.abc import Iterable, Mapping
from enum import Enum
from typing import Any

from ...option_table import MOTION, PERFORMANCE, Option
from ..distinct_files import InputFile, OutputName

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


MOTION_HELP = (
    ".bvh, .glb, .vrma, .json, .csv (ARKit), .visemes.txt, .usda, .usdc, .usdz, .fbx (by Blender), .otio, "
    ".TextGrid, .eaf, .events.csv, .bap, .fap, "
    ".png (contact sheet) or .speed.png (wrist speeds)"
)
AUDIO_HELP = "WAV, FLAC or OGG file; - for standard input"


def add_line(parser: argparse.ArgumentParser) -> None:
    """The recording, its words and their times."""
    parser.add_argument("audio", metavar="AUDIO", type=InputFile, help=AUDIO_HELP)
    add_text(parser, "the words that are spoken")
    add_words(parser, "the words' times, made elsewhere: .json, .TextGrid or .ctm; nothing is aligned")
    parser.set_defaults(functions=None, direction=None, edits=None)


def add_text(parser: argparse.ArgumentParser, told: str) -> None:
    """The words, on the command line or in a file."""
    text = parser.add_mutually_exclusive_group(required=True)
    text.add_argument("--text", help=told)
    text.add_argument(
        "--text-file", metavar="FILE", type=InputFile, help="a file that holds them; - for standard input"
    )


def add_words(parser: argparse.ArgumentParser, told: str) -> None:
    parser.add_argument("--words", metavar="FILE", type=InputFile, help=told)


def add_agitation_model(parser: argparse.ArgumentParser) -> None:
    told = "judge agitation by a model of your own, from understudy agitation train"
    parser.add_argument("--agitation-model", metavar="MODEL", type=InputFile, help=told)


def add_motion_model(parser: argparse.ArgumentParser) -> None:
    told = "arms, trunk and head of --realize by a motion model: of understudy motion-model train, or default"
    parser.add_argument("--motion-model", metavar="MODEL", type=InputFile, help=told)
    told = "what drives it: voice and affect (S1, S2), voice (S3, S4), affect (S5, S6), or RTS (default S1)"
    parser.add_argument("--scenario", metavar="S1…S6", help=told)


def add_functions(parser: argparse.ArgumentParser) -> None:
    told = "communicative functions that you know already: a JSON list"
    parser.add_argument("--functions", metavar="FILE", type=InputFile, help=told)


def add_output(parser: argparse.ArgumentParser, metavar: str, told: str, *, default: str | None = None) -> None:
    """Adds the option for the output file, which is required if there is no default."""
    needed = default is None
    parser.add_argument("-o", "--output", metavar=metavar, type=OutputName, required=needed, default=default, help=told)
