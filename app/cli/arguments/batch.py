"""The arguments of `understudy batch`."""

import argparse

from ..files import InputFile
from .options import Adding, add_agitation_model, add_form, add_manner, add_rate

SCRIPTS_HELP = ".csv, .tsv, .xlsx, .fountain, .fdx, .srt, .vtt, .jsonl, or Ren'Py's dialogue.tab"
FORMATS_HELP = (
    "bml (default), bml.json, json (every reason), TextGrid, ctm, wav, glb, bvh, vrma, clip.json, csv, png, …"
)


def add_batch(add: Adding) -> None:
    parser = add("batch", "perform a whole script: the lines and their recordings in, a performance of each out")
    parser.add_argument("script", metavar="SCRIPT", type=InputFile, help=SCRIPTS_HELP)
    parser.add_argument(
        "--audio", metavar="DIR", required=True, help="the folder of recordings, or the one recording of all lines"
    )
    parser.add_argument("--out", metavar="DIR", required=True, help="the output folder; a repeated run continues there")
    parser.add_argument(
        "--format", metavar="NAME", action="append", default=[], help=f"output format, repeatable: {FORMATS_HELP}"
    )
    parser.add_argument("--layout", metavar="PATTERN", help='names of outputs (default "{id}.{ext}")')
    _add_joining(parser)
    _add_running(parser)
    _add_casting(parser)
    add_agitation_model(parser)
    add_manner(parser)
    add_form(parser)
    add_rate(parser)


def _add_joining(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--column",
        metavar="FIELD=HEADING",
        action="append",
        default=[],
        help="the heading of a column with an unusual name: id, text, character, recording, …; repeatable",
    )
    parser.add_argument(
        "--sheet",
        metavar="NAME",
        action="append",
        default=[],
        help="a worksheet of a workbook (default: all with the same headings); repeatable",
    )
    parser.add_argument("--pattern", metavar="NAME", help='names of recordings, such as "{character}/{id}_t{take}.wav"')
    parser.add_argument(
        "--take",
        choices=("last", "first", "all"),
        default="last",
        help="which take to use if there are several (default last)",
    )


def _add_casting(parser: argparse.ArgumentParser) -> None:
    parser.add_argument(
        "--cast",
        metavar="FILE",
        type=InputFile,
        help="who performs which role: cast.yaml (docs/batch.md has an example)",
    )
    parser.add_argument(
        "--partners",
        choices=("scene", "none"),
        default="scene",
        help="default listeners: those who speak before and after a line in its scene (default), or nobody",
    )
    parser.add_argument(
        "--voices",
        choices=("learn", "none"),
        default="learn",
        help="judge agitation relative to each speaker's voice in the batch (default), or to the average voice",
    )


def _add_running(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--workers", metavar="N", type=int, help="number of processes (default: one a processor)")
    engine = parser.add_mutually_exclusive_group()
    engine.add_argument("--scheduler", metavar="tcp://HOST:PORT", help="use the workers of a dask cluster instead")
    engine.add_argument(
        "--service",
        metavar="URL",
        help="use an understudy service instead; --workers is then how many lines are sent at a time",
    )
    parser.add_argument(
        "--shared-files",
        action="store_true",
        help="the cluster's workers see the same folders, so files need not be sent",
    )
    parser.add_argument(
        "--dry-run", action="store_true", help="report what would be done and what is missing, without doing it"
    )
    parser.add_argument(
        "--thumbnails",
        metavar="N",
        type=int,
        default=0,
        help="show key poses of the N most urgent lines in report.html",
    )
    parser.add_argument("--again", action="store_true", help="perform every line again, including those already done")
