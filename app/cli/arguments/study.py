"""The arguments of `understudy study`."""

import argparse

from ...option_table import PERFORMANCE
from ...study.comparison import Comparison
from ..distinct_files import InputFile, OutputFile
from .batch import SCRIPTS_HELP
from .command import Adding, actions_of
from .options import add_options


def add_study(add: Adding) -> None:
    add_action = actions_of(add("study", "the papers' comparisons: clips and a blind page, statistics"))
    _add_make(add_action("make", "clips of lines in each condition, and a page on which raters judge them"))
    score = add_action("score", "the statistics of raters' answers, as the papers' tables")
    score.add_argument("answers", metavar="ANSWERS.csv", nargs="+", type=InputFile, help="the files that raters saved")
    score.add_argument(
        "--key",
        metavar="KEY.csv",
        type=InputFile,
        help="what each clip shows, from study make (default: key.csv beside the answers or one folder up)",
    )
    score.add_argument("-o", "--output", metavar="REPORT", type=OutputFile, help="also write the report: .json or .md")


def _add_make(make: argparse.ArgumentParser) -> None:
    told = f"{SCRIPTS_HELP}; or a folder of recordings, each with its words in a .txt of the same name"
    make.add_argument("lines", metavar="LINES", help=told)
    make.add_argument("--audio", metavar="DIR", help="the folder of the script's recordings (default: where it lies)")
    make.add_argument("--out", metavar="DIR", required=True, help="where page and key go")
    make.add_argument(
        "--compare",
        choices=[each.value for each in Comparison],
        default=Comparison.MODES.value,
        help="gestures from meaning, stress and chance (default), or gestures in units and single ones",
    )
    make.add_argument("--profile", metavar="P", help="of units: whose gestures, as in perform (default sweeping)")
    add_options(make, PERFORMANCE, "character")
    make.add_argument("--seed", type=int, default=0, help="another number draws other gestures and orders (default 0)")
