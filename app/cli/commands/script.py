"""`understudy script`: writes the gesture script of a line by a speaker's profile."""

import argparse

from ...library.checks import check_character, check_line
from ...schemas.gestures.script import script_json
from ...settings import read_settings
from ..files import require_writable, write
from ..inputs.lines import read_line
from ..inputs.options import performance_options
from ..log import Log


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    require_writable(arguments.output, field="output")
    line = read_line(arguments, settings)
    options = performance_options(arguments)
    check_character(options.character)
    check_line(line, settings)
    from ...library.performing import perform_line
    from ...models import Understudy  # imported late: arguments are checked before the models load

    with Understudy.load(settings) as understudy:
        performed = perform_line(understudy, line, options, log.stage)
    performance = performed.performance
    write(arguments.output, script_json(performed.written_script(), performance.utterance, performance.character))
    log.warnings(performance.notices)
    return 0
