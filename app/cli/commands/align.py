"""`understudy align`: the times of words and phones, as JSON, Praat TextGrid or CTM."""

import argparse
from pathlib import PurePath

from ...library.checks import check_line
from ...library.hearing import AcousticModels, align
from ...library.writing import write_ctm, write_json, write_textgrid
from ...model import AlignedLine
from ...settings import read_settings
from ..files import write_standard
from ..inputs.lines import read_line
from ..log import Log


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    line = read_line(arguments, settings)
    check_line(line, settings)
    assert line.audio is not None, "the command takes a recording"
    with AcousticModels.load(settings) as acoustic:
        aligned = align(acoustic, line.audio, line.text, words=line.timings)
    write_standard(_formatted(aligned, arguments))
    log.warnings(aligned.notices)
    return 0


def _formatted(aligned: AlignedLine, arguments: argparse.Namespace) -> bytes:
    if arguments.format == "textgrid":
        return write_textgrid(aligned)
    if arguments.format == "ctm":
        return write_ctm(aligned, PurePath(arguments.audio).stem)
    return write_json(aligned, indent=2) + b"\n"
