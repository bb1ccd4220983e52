"""`understudy study`: repeats the papers' comparisons with one's own lines, and computes the statistics of the
answers."""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from ...errors import InputError
from ...library.checks import check_character
from ...model import Notice
from ...options import Options
from ...profiles.profile import Profile
from ...settings import read_settings
from ...study.comparison import CONDITIONS, KEY_NAME, PAIRED, Comparison
from ...study.making.lines import PAGE_FOLDER, StudyRequest, StudySource
from ..files import require_writable, write, write_standard
from ..inputs.lines import optional_profile
from ..log import Log

if TYPE_CHECKING:
    from ...library.motion_models import MotionModel

REPORTS = (".json", ".md")
USUAL_PROFILE = "sweeping"
USUAL_SPEAKERS = ("sparing", "sweeping")


def run(arguments: argparse.Namespace, log: Log) -> int:
    actions = {"make": _make, "score": _score}
    actions[arguments.action](arguments, log)
    return 0


def _make(arguments: argparse.Namespace, log: Log) -> None:
    comparison = Comparison(arguments.compare)
    options = Options(character=arguments.character, seed=arguments.seed, profile=_profile(arguments, comparison))
    speakers, model = _speakers(arguments, comparison), _model(arguments, comparison)
    check_character(options.character)
    source = StudySource(Path(arguments.lines), arguments.audio and Path(arguments.audio), Path(arguments.out))
    request = StudyRequest(source, comparison, options, model, speakers)
    from ...models import Understudy  # imported late: arguments are checked before the models load
    from ...study.making.whole_study import make_study

    with Understudy.load(read_settings()) as understudy:
        rounds = make_study(request, understudy, partial(_line_made, log))
    page = source.out / PAGE_FOLDER
    log.note(f"{page}: {rounds} rounds; give this folder to raters, who open index.html; keep {KEY_NAME} beside it")
    from ...study.scoring.samples import plan_told

    log.note(plan_told(comparison, len(CONDITIONS[comparison])))


def _line_made(log: Log, told: str, notices: Sequence[Notice]) -> None:
    log.note(told)
    log.warnings(notices, of=told.partition(":")[0])


def _profile(arguments: argparse.Namespace, comparison: Comparison) -> Profile | str | None:
    """Raises InputError `usage` for a profile in a comparison that does not use one."""
    named = arguments.profile or []
    if comparison is Comparison.UNITS and len(named) < 2:
        return optional_profile(named[0] if named else USUAL_PROFILE)
    if named and comparison is not Comparison.SPEAKERS:
        message = "leave it out, or --compare units with one, or --compare speakers with two"
        raise InputError("usage", f"--profile: stress, chance and motion models use no profile; {message}")
    return None


def _speakers(arguments: argparse.Namespace, comparison: Comparison) -> Mapping[str, Profile | str]:
    """The profiles of the speakers by their names; raises InputError `usage` if they are not two."""
    if comparison is not Comparison.SPEAKERS:
        return {}
    named = arguments.profile or USUAL_SPEAKERS
    speakers = {PurePath(name).stem: optional_profile(name) for name in named}
    found = {name: profile for name, profile in speakers.items() if profile is not None}
    if len(found) != len(USUAL_SPEAKERS):
        raise InputError("usage", "--compare speakers: give two profiles, --profile A --profile B")
    return found


def _model(arguments: argparse.Namespace, comparison: Comparison) -> MotionModel | None:
    """Raises InputError `usage` for a model in a comparison that does not use one, and as `read_motion_model` does."""
    if comparison not in PAIRED:
        if arguments.motion_model is not None:
            raise InputError("usage", "--motion-model: only --compare ways and --compare affect have one; leave it out")
        return None
    from ...library.motion_models import DEFAULT_MODEL, read_motion_model

    return read_motion_model(arguments.motion_model or DEFAULT_MODEL)


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
