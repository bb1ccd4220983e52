"""`understudy study`: repeats the papers' comparisons with one's own lines, and computes the statistics of the
answers."""

import argparse
from collections.abc import Sequence
from functools import partial
from pathlib import Path, PurePath

from ...errors import InputError
from ...library.checks import check_character
from ...model import Notice
from ...options import Options
from ...profiles.profile import Profile
from ...settings import read_settings
from ...study.comparison import KEY_NAME, Comparison
from ...study.request import PAGE_FOLDER, StudyRequest, StudySource
from ..files import require_writable, write, write_standard
from ..inputs.options import optional_profile
from ..log import Log

REPORTS = (".json", ".md")
USUAL_PROFILE = "sweeping"


def run(arguments: argparse.Namespace, log: Log) -> int:
    actions = {"make": _make, "score": _score}
    actions[arguments.action](arguments, log)
    return 0


def _make(arguments: argparse.Namespace, log: Log) -> None:
    comparison = Comparison(arguments.compare)
    options = Options(character=arguments.character, seed=arguments.seed, profile=_profile(arguments, comparison))
    check_character(options.character)
    source = StudySource(Path(arguments.lines), arguments.audio and Path(arguments.audio), Path(arguments.out))
    request = StudyRequest(source, comparison, options)
    from ...models import Understudy  # imported late: arguments are checked before the models load
    from ...study.making.making import make_study

    with Understudy.load(read_settings()) as understudy:
        lines = make_study(request, understudy, partial(_line_made, log))
    page = source.out / PAGE_FOLDER
    log.note(f"{page}: {lines} lines; give this folder to raters, who open index.html; keep {KEY_NAME} beside it")


def _line_made(log: Log, told: str, notices: Sequence[Notice]) -> None:
    log.note(told)
    log.warnings(notices, of=told.partition(":")[0])


def _profile(arguments: argparse.Namespace, comparison: Comparison) -> Profile | str | None:
    """Raises InputError `usage` for a profile in a comparison that does not use one."""
    if comparison is Comparison.UNITS:
        return optional_profile(arguments.profile or USUAL_PROFILE)
    if arguments.profile is not None:
        raise InputError("usage", "--profile: stress and chance have no profile; leave it out, or --compare units")
    return None


def _score(arguments: argparse.Namespace, _log: Log) -> None:
    if arguments.output is not None:
        _require_report(arguments.output)
    from ...study.scoring.reading import read_answers  # scipy's statistics take half a second to import
    from ...study.scoring.report import report_json, report_markdown, score

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
