"""`understudy align`: words and phones in time, as JSON, Praat TextGrid or CTM."""

import argparse
from pathlib import PurePath

from app.answers import AlignAnswer
from app.cli.files import write_standard
from app.cli.lines import read_line
from app.cli.log import Log
from app.performance import Aligned, Ears, align, to_ctm, to_textgrid
from app.settings import read_settings


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    line = read_line(arguments, settings)
    with Ears.load(settings) as ears:
        aligned = align(ears, line)
    write_standard(_formatted(aligned, arguments))
    log.warnings(aligned.notices)
    return 0


def _formatted(aligned: Aligned, arguments: argparse.Namespace) -> bytes:
    if arguments.format == "textgrid":
        return to_textgrid(aligned.words, aligned.duration_s).encode()
    if arguments.format == "ctm":
        return to_ctm(aligned.words, PurePath(arguments.audio).stem).encode()
    return AlignAnswer.of(aligned).to_json(indent=2) + b"\n"
