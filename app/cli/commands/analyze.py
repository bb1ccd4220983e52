"""`understudy analyze`: the analysis of a line as JSON, and on request as a picture."""

import argparse

from ...library.checks import check_line
from ...settings import read_settings
from ..files import require_writable, write, write_standard
from ..inputs.hearing import require_reference, speaker_reference
from ..inputs.lines import read_line
from ..inputs.options import level_of, optional_affect
from ..log import Log
from ..outputs.plot import plot, require_plot


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    line = read_line(arguments, settings)
    if arguments.plot:
        require_plot(arguments.plot)
        require_writable(arguments.plot, field="plot")
    level = level_of(arguments)
    affect = optional_affect(arguments.affect)
    require_reference(arguments.reference, settings)
    check_line(line, settings)
    from ...library.performing import analyze_line
    from ...library.writing import write_json
    from ...models import Understudy
    from ...options import Options  # imported late: arguments are checked before the models load

    with Understudy.load(settings) as understudy:
        reference = speaker_reference(understudy.acoustic, arguments.reference, log)
        options = Options(agitation=level, affect=affect, reference=reference)
        analysis = analyze_line(understudy, line, options, log.stage)
    if arguments.plot and analysis.heard is not None:
        write(arguments.plot, plot(analysis, analysis.heard))
    write_standard(write_json(analysis, indent=2) + b"\n")
    log.warnings(analysis.notices)
    return 0
