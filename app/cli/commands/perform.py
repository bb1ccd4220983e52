"""`understudy perform`: one line in, BML out, and what the character does and why."""

import argparse
from dataclasses import replace
from pathlib import PurePath

from ...errors import InputError
from ...model import Level, Mode
from ...performance import (
    BmlForm,
    DialectName,
    Options,
    TimeForm,
    Understudy,
    perform,
    write_bml,
    write_bml_json,
    write_listener,
)
from ...realization import PreparedSchedule, schedule_of
from ...schemas.requests import listener_names
from ...schemas.responses import PerformanceResponse
from ...settings import read_settings
from ..files import STANDARD, require_writable, write
from ..hearing import speaker_reference
from ..lines import read_line
from ..log import Log
from ..motions import require_motions, write_motions
from ..summary import summary


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    _check_targets(arguments)
    line = read_line(arguments, settings)
    options = Options(
        character=arguments.character,
        agitation=arguments.agitation and Level(arguments.agitation),
        seed=arguments.seed,
        mode=Mode(arguments.mode),
        listeners=listener_names(arguments.listener),
        form=_form(arguments),
        lead_in_s=arguments.lead_in,
        stillness=arguments.stillness,
    )
    with Understudy.load(settings) as understudy:
        options = replace(options, reference=speaker_reference(understudy.acoustic, arguments.reference, log))
        performance = perform(understudy, line, options, log.stage)
        if arguments.realize:
            staged = PreparedSchedule(schedule_of(performance), performance.notices)
            write_motions(arguments.realize, understudy.realizer, staged, arguments, log)
    if arguments.trace:
        write(arguments.trace, PerformanceResponse.of_performance(performance).to_json(indent=2) + b"\n")
    written = write_bml_json if (arguments.output or "").lower().endswith(".json") else write_bml
    write(arguments.output or STANDARD, written(performance, options.form))
    for listening in performance.listeners:
        write(_beside(arguments.output, listening.name), write_listener(performance, listening, options.form))
    log.warnings(performance.notices)
    if arguments.output:
        log.note(summary(performance))
    return 0


def _form(arguments: argparse.Namespace) -> BmlForm:
    audio_name = None if arguments.audio == STANDARD else PurePath(arguments.audio).stem
    return BmlForm(DialectName(arguments.dialect), TimeForm(arguments.timing), audio_name)


def _beside(output: str, name: str) -> str:
    """OUT.NAME.bml for OUT.bml."""
    return str(PurePath(output).with_suffix(f".{name}.bml"))


def _check_targets(arguments: argparse.Namespace) -> None:
    """Raises InputError before the work when its result could not be written."""
    output = arguments.output or STANDARD
    if arguments.trace == output:
        raise InputError("usage", f"the BML and the trace cannot both go to {output}; give --trace another file")
    if arguments.listener and output == STANDARD:
        raise InputError("usage", "a listener's BML goes beside the speaker's; say where with -o OUT.bml")
    require_writable(output, field="output")
    require_motions(arguments.realize, field="realize")
    if arguments.trace:
        require_writable(arguments.trace, field="trace")
