"""The arguments of `understudy study`."""

from ..distinct_files import InputFile, OutputFile
from .command import Adding, actions_of


def add_study(add: Adding) -> None:
    add_action = actions_of(add("study", "the papers' comparisons: clips and a blind page, statistics"))
    score = add_action("score", "the statistics of raters' answers, as the papers' tables")
    score.add_argument("answers", metavar="ANSWERS.csv", nargs="+", type=InputFile, help="the files that raters saved")
    score.add_argument(
        "--key",
        metavar="KEY.csv",
        type=InputFile,
        help="what each clip shows, from study make (default: key.csv beside the answers or one folder up)",
    )
    score.add_argument("-o", "--output", metavar="REPORT", type=OutputFile, help="also write the report: .json or .md")
