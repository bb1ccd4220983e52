"""`understudy analyze`: what a line says and does, as JSON, and if asked for as a picture."""

import argparse

from app.answers import AnalysisAnswer
from app.cli.files import require_writable, write, write_standard
from app.cli.hearing import speaker_reference
from app.cli.lines import read_line
from app.cli.log import Log
from app.cli.plot import plot, require_plot
from app.model import Level
from app.performance import Understudy, analyze
from app.settings import read_settings


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    line = read_line(arguments, settings)
    if arguments.plot:
        require_plot(arguments.plot)
        require_writable(arguments.plot, field="plot")
    level = arguments.agitation and Level(arguments.agitation)
    with Understudy.load(settings) as understudy:
        reference = speaker_reference(understudy.ears, arguments.reference, log)
        analysis = analyze(understudy, line, agitation=level, reference=reference, progress=log.stage)
    if arguments.plot and analysis.heard is not None:
        write(arguments.plot, plot(analysis, analysis.heard))
    write_standard(AnalysisAnswer.of(analysis).to_json(indent=2) + b"\n")
    log.warnings(analysis.notices)
    return 0
