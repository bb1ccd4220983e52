"""`understudy perform`: one line in, BML out, and what the character does and why."""

import argparse

from app.answers import PerformanceAnswer
from app.cli.files import STANDARD, require_writable, write
from app.cli.lines import read_line
from app.cli.log import Log
from app.cli.summary import summary
from app.errors import InputError
from app.model import Level
from app.performance import Options, Understudy, perform, write_bml
from app.settings import read_settings


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    _check_targets(arguments)
    line = read_line(arguments, settings)
    options = Options(
        character=arguments.character,
        agitation=arguments.agitation and Level(arguments.agitation),
        seed=arguments.seed,
    )
    with Understudy.load(settings) as understudy:
        performance = perform(understudy, line, options, log.stage)
    if arguments.trace:
        write(arguments.trace, PerformanceAnswer.of_performance(performance).to_json(indent=2) + b"\n")
    write(arguments.output or STANDARD, write_bml(performance))
    log.warnings(performance.notices)
    if arguments.output:
        log.note(summary(performance))
    return 0


def _check_targets(arguments: argparse.Namespace) -> None:
    """Raises InputError before the work when its result could not be written."""
    output = arguments.output or STANDARD
    if arguments.trace == output:
        raise InputError("usage", f"the BML and the trace cannot both go to {output}; give --trace another file")
    require_writable(output, field="output")
    if arguments.trace:
        require_writable(arguments.trace, field="trace")
