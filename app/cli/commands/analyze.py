"""`understudy analyze`: what a line says and does, as JSON."""

import argparse

from app.answers import AnalysisAnswer
from app.cli.files import write_standard
from app.cli.lines import read_line
from app.cli.log import Log
from app.model import Level
from app.performance import Understudy, analyze
from app.settings import read_settings


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    line = read_line(arguments, settings)
    level = arguments.agitation and Level(arguments.agitation)
    with Understudy.load(settings) as understudy:
        analysis = analyze(understudy, line, agitation=level, progress=log.stage)
    write_standard(AnalysisAnswer.of(analysis).to_json(indent=2) + b"\n")
    log.warnings(analysis.notices)
    return 0
