"""`understudy study`: the papers' comparisons, made from one's own lines, and the statistics of the answers."""

import argparse
from pathlib import Path, PurePath

from ...errors import InputError
from ..files import require_writable, write, write_standard
from ..log import Log

REPORTS = (".json", ".md")


def run(arguments: argparse.Namespace, log: Log) -> int:
    actions = {"score": _score}
    actions[arguments.action](arguments, log)
    return 0


def _score(arguments: argparse.Namespace, _log: Log) -> None:
    if arguments.output is not None:
        _require_report(arguments.output)
    from ...study.scoring.reading import read_answers  # scipy's statistics take half a second to import
    from ...study.scoring.report import report_json, report_markdown
    from ...study.scoring.scoring import score

    answers = read_answers([Path(name) for name in arguments.answers], arguments.key and Path(arguments.key))
    statistics = score(answers)
    tables = report_markdown(statistics)
    write_standard(tables.encode())
    if arguments.output is not None:
        as_json = arguments.output.lower().endswith(".json")
        write(arguments.output, report_json(statistics) if as_json else tables.encode())


def _require_report(name: str) -> None:
    if PurePath(name).suffix.lower() not in REPORTS:
        raise InputError("report_format", f"{name}: a report is written as {' or '.join(REPORTS)}", field="output")
    require_writable(name, field="output")
