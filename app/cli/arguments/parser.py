"""The parser of the whole command line, with every command in its order.

Also contains the arguments of `serve`, `studio` and `study`.
"""

import argparse
import re
import sys
from collections.abc import Sequence
from typing import Any, NoReturn

from ...errors import InputError
from ...option_table import PERFORMANCE
from ...study.comparison import Comparison
from ...version import __version__
from ..files import InputFile, OutputName
from .batch import SCRIPTS_HELP, add_batch
from .libraries import add_characters, add_gestures, add_motion_models, add_profiles, add_rules
from .lines import add_analyses, add_live, add_perform, add_realize, add_say, add_script
from .options import Adding, actions_of, add_agitation_model, add_options, commands_of, voices

_TRAIN = "agitation train"
_OPTION = re.compile(r"--[\w-]+")
_NEGATIVE_NUMBERS = re.compile(r"-\.?\d[^,]*(,[^,]*)+")


class _Parser(argparse.ArgumentParser):
    """An argparse parser that raises InputError, so that usage errors look like all others, and refuses
    abbreviations."""

    def parse_args(self, args: Sequence[str] | None = None, namespace: Any = None) -> Any:  # type: ignore[override]  # noqa: ANN401
        """Joins the two words of `agitation train`, since other words after `agitation` are recordings, and an option
        and numbers of which the first is negative, which argparse would take for another option."""
        words = _with_numbers_joined(sys.argv[1:] if args is None else args)
        place = next((index for index in range(len(words) - 1) if words[index : index + 2] == _TRAIN.split()), None)
        if place is not None:
            words[place : place + 2] = [_TRAIN]
        return super().parse_args(words, namespace)

    def error(self, message: str) -> NoReturn:
        raise InputError("usage", f"{message}; see {self.prog} --help")


def _with_numbers_joined(words: Sequence[str]) -> list[str]:
    """The words, with `--affect -0.6,-0.5,0.3` as one."""
    found: list[str] = []
    for word in words:
        if found and _OPTION.fullmatch(found[-1]) and _NEGATIVE_NUMBERS.fullmatch(word):
            found[-1] += f"={word}"
        else:
            found.append(word)
    return found


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


LARGEST_PORT = 65535


def add_serve(add: Adding) -> None:
    parser = add("serve", "run the HTTP service")
    parser.add_argument("--host", help="address to listen on (default: UNDERSTUDY_HOST, else 127.0.0.1)")
    parser.add_argument("--port", type=_port, help="port to listen on (default: UNDERSTUDY_PORT, else 8000)")
    add_agitation_model(parser)
    _add_origins(parser)
    parser.add_argument("--reload", action="store_true", help="reload rules, words and characters when they are saved")


def add_studio(add: Adding) -> None:
    parser = add("studio", "open the studio page: perform a line, look at it, change it, export it")
    parser.add_argument("audio", metavar="AUDIO", type=InputFile, nargs="?", help="a line to open (WAV, FLAC, OGG)")
    text = parser.add_mutually_exclusive_group()
    text.add_argument("--text", help="the words that are spoken")
    text.add_argument("--text-file", metavar="FILE", type=InputFile, help="a file with the words")
    parser.add_argument("--scene", metavar="DIR", help="open a whole scene: the folder that batch wrote to")
    parser.add_argument("--port", type=_port, default=0, help="port to listen on (default: one that is free)")
    parser.add_argument(
        "--rules",
        metavar="DIR",
        help="a folder in which the page may save files that authors edit (default: that of --lexicon)",
    )
    add_agitation_model(parser)
    _add_origins(parser)
    parser.add_argument("--no-browser", action="store_true", help="print the page's address without opening a browser")
    parser.add_argument("--reload", action="store_true", help="reload rules, words and characters when they are saved")


def _add_origins(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--allow-origin",
        metavar="ORIGIN",
        action="append",
        help="pages of this origin, such as http://localhost:5173, may call the service; may be repeated",
    )


def _port(text: str) -> int:
    if not text.isdecimal() or int(text) > LARGEST_PORT:
        raise argparse.ArgumentTypeError(f"{text!r} is not a port, which is a number from 0 to {LARGEST_PORT}")
    return int(text)


def add_study(add: Adding) -> None:
    add_action = actions_of(add("study", "run the papers' comparisons: clips on a blind rating page, then statistics"))
    _add_make(add_action("make", "make clips of lines in each condition, and a page on which raters judge them"))
    score = add_action("score", "compute the statistics of raters' answers, in the form of the papers' tables")
    score.add_argument("answers", metavar="ANSWERS.csv", nargs="+", type=InputFile, help="the raters' answer files")
    score.add_argument(
        "--key",
        metavar="KEY.csv",
        type=InputFile,
        help="what each clip shows, written by study make (default: key.csv beside the answers or one folder up)",
    )
    score.add_argument("-o", "--output", metavar="REPORT", type=OutputName, help="also write the report: .json or .md")


def _add_make(make: argparse.ArgumentParser) -> None:
    help_text = f"{SCRIPTS_HELP}; or a folder of recordings, each with its words in a .txt of the same name"
    make.add_argument("lines", metavar="LINES", help=help_text)
    make.add_argument(
        "--audio", metavar="DIR", help="the folder of the script's recordings (default: the script's folder)"
    )
    make.add_argument("--out", metavar="DIR", required=True, help="output folder of the page and the key")
    make.add_argument(
        "--compare",
        choices=[each.value for each in Comparison],
        default=Comparison.MODES.value,
        help="modes: gestures from meaning, stress and chance (default); units: gestures in units and single ones; "
        "ways: a motion model for the whole recording, live, at random; affect: driven by voice, affect or both; "
        "speakers: two profiles, to be recognised",
    )
    make.add_argument(
        "--profile",
        metavar="P",
        action="append",
        help="gesture profile of --compare units (default sweeping); given twice, of speakers (sparing, sweeping)",
    )
    make.add_argument(
        "--motion-model", metavar="M", help="motion model of --compare ways and affect (default: the shipped one)"
    )
    add_options(make, PERFORMANCE, "character")
    make.add_argument("--seed", type=int, default=0, help="random seed of gestures and orders (default 0)")
