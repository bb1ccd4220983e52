"""`understudy align`: the times of words and phones, as JSON, Praat TextGrid or CTM."""

import argparse
from pathlib import PurePath

from ...acoustic.alignment.timings import to_ctm, to_textgrid
from ...acoustic.stage import AcousticModels, align
from ...model import AlignedLine
from ...schemas.responses import AlignResponse
from ...settings import read_settings
from ..files import write_standard
from ..inputs.early import require_usable
from ..inputs.lines import read_line
from ..log import Log


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    line = read_line(arguments, settings)
    require_usable(line, settings)
    with AcousticModels.load(settings) as acoustic:
        aligned = align(acoustic, line)
    write_standard(_formatted(aligned, arguments))
    log.warnings(aligned.notices)
    return 0


def _formatted(aligned: AlignedLine, arguments: argparse.Namespace) -> bytes:
    if arguments.format == "textgrid":
        return to_textgrid(aligned.words, aligned.duration_s).encode()
    if arguments.format == "ctm":
        return to_ctm(aligned.words, PurePath(arguments.audio).stem).encode()
    return AlignResponse.of(aligned).to_json(indent=2) + b"\n"
