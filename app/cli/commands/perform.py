"""`understudy perform` and `say`: one line in, BML out, with a readable summary of the behaviours and their reasons;
and `understudy script`: the gesture script of a line by a speaker's profile.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import PurePath
from typing import TYPE_CHECKING

from ...errors import InputError
from ...library.checks import check_character, check_line
from ...library.writing import speech_file_name, write_bml_files, write_bml_json, write_json
from ...loading import uncollected
from ...model import PLAIN, AffectTrack, Analysis, Behavior, Function, Line, Performance
from ...model.formats import BmlForm, is_editorial
from ...options import Options
from ...schemas.options import listener_names
from ...settings import Settings, read_settings
from ..files import STANDARD, OutputName, require_distinct, require_writable, write
from ..inputs.hearing import require_reference, speaker_reference
from ..inputs.lines import bml_form, edits_of, performance_options, read_line
from ..log import Log
from ..outputs.motions import MotionOptions, recording, require_motions, write_motions

WORDS_WIDTH = 28


def summary(performance: Performance) -> str:
    """The line's behaviours in order of time, each with its words, its function, and the rule or the strongest term
    that chose it."""
    return "\n".join(_lines(performance))


def _lines(performance: Performance) -> Iterator[str]:
    utterance = performance.utterance
    kept = sorted((behavior for behavior in performance.behaviors if behavior.kept), key=lambda one: one.sync.start)
    functions = {function.id: function for function in performance.functions}
    level = utterance.agitation.level if utterance.agitation else "unknown"
    duration_s = utterance.duration_s or 0.0
    begins = f", the recording begins at {utterance.lead_in_s:.2f} s" if utterance.lead_in_s else ""
    yield f"{performance.character} performs {duration_s:.2f} s{begins}, agitation {level}, seed {performance.seed}"
    for behavior in kept:
        if not _is_idle(behavior):
            yield _movement_shown(performance, behavior, functions.get(behavior.function or ""))
    own = Counter(behavior.lexeme.lower() for behavior in kept if _is_idle(behavior))
    if own:
        yield "idle: " + ", ".join(f"{count} × {lexeme}" for lexeme, count in own.items())
    dropped = len(performance.behaviors) - len(kept)
    if dropped:
        yield f"not shown: {dropped} (--trace says why)"


def _movement_shown(performance: Performance, behavior: Behavior, function: Function | None) -> str:
    words = " ".join(word.text for word in performance.utterance.words[behavior.first : behavior.last + 1])
    shown = words if len(words) <= WORDS_WIDTH else words[: WORDS_WIDTH - 1] + "…"
    movement = behavior.lexeme.lower() + (f" ({behavior.hand})" if behavior.hand else "")
    return (
        f"{behavior.sync.start:6.2f}–{behavior.sync.end:5.2f} s  {behavior.kind:7s} {movement:24s} "
        f"{shown:{WORDS_WIDTH}s}  {_why(behavior, function)}"
    )


def _why(behavior: Behavior, function: Function | None) -> str:
    authored = "" if behavior.edit is None else f"the author's edit {behavior.edit}"
    if function is None:
        return authored or _decided(behavior)
    chosen = f"{_name(function)} by {function.rule} → {behavior.rule or behavior.reason}"
    return f"{chosen}; {authored}" if authored else chosen


def _is_idle(behavior: Behavior) -> bool:
    """Whether a behaviour is idle: without a function, a moment of the plan or an edit."""
    return behavior.function is None and behavior.moment is None and behavior.edit is None


def _decided(behavior: Behavior) -> str:
    """The strongest term for the behaviour, and its rule."""
    part = max(behavior.decided_by, key=lambda each: each.weight, default=None)
    chosen = behavior.rule or behavior.reason or ""
    return f"{part.name} ({part.weight:+.1f}) → {chosen}" if part else chosen


def _name(function: Function) -> str:
    return function.class_name if function.subtype == PLAIN else f"{function.class_name} ({function.subtype})"


if TYPE_CHECKING:
    from ...library.motion_models import MotionSource
    from ...library.performing import PerformedLine


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    _check_targets(arguments, settings)
    motion = MotionOptions.of(arguments, settings)
    line = read_line(arguments, settings)
    options = performance_options(arguments).with_edits(edits_of(arguments, settings))
    check_character(options.character)
    require_reference(arguments.reference, settings)
    check_line(line, settings)
    moves = _movement(arguments)
    performed = _performed(line, options, arguments.reference, settings, log)
    performance = performed.performance
    realized = [*arguments.realize, *([arguments.output] if is_editorial(arguments.output) else [])]
    if realized:
        from ...library.motion import PreparedSchedule

        audio = recording(arguments.audio, line.audio)
        moving = moves and moves(performed.analysis, options.affect)
        write_motions(realized, PreparedSchedule.of(performance), motion, audio, log, moving=moving)
    _write(performance, options.form, arguments, log)
    log.warnings(performance.notices)
    if arguments.output != STANDARD:
        log.note(summary(performance))
    return 0


def _movement(arguments: argparse.Namespace) -> Callable[[Analysis, AffectTrack | None], MotionSource] | None:
    """The movement by a motion model, if one is requested. Raises InputError `motion_model`, `usage`."""
    if arguments.motion_model is None:
        if arguments.scenario:
            raise InputError("usage", "--scenario needs --motion-model")
        return None
    if not arguments.realize:
        raise InputError("usage", "--motion-model needs --realize, which says where the motion goes")
    if arguments.physics:
        raise InputError("usage", "--motion-model plays recorded motion; leave out --physics")
    from ...library.motion_models import DEFAULT_SCENARIO, moving_by, read_motion_model, scenario_named

    model, scenario = read_motion_model(arguments.motion_model), scenario_named(arguments.scenario or DEFAULT_SCENARIO)
    return lambda analysis, affect: moving_by(model, analysis, affect, scenario)


def _performed(
    line: Line, options: Options, reference: Sequence[str] | None, settings: Settings, log: Log
) -> PerformedLine:
    from ...library.performing import perform_line
    from ...models import Understudy  # imported late: arguments are checked before the models load

    with uncollected(), Understudy.load(settings) as understudy:
        options = replace(options, reference=speaker_reference(understudy.acoustic, reference, log))
        return perform_line(understudy, line, options, log.stage)


def _write(performance: Performance, form: BmlForm, arguments: argparse.Namespace, log: Log) -> None:
    """Writes the trace, the BML, and the files beside it."""
    if arguments.trace:
        write(arguments.trace, write_json(performance, indent=2) + b"\n")
    if is_editorial(arguments.output):
        return
    files = write_bml_files(performance, form)
    is_json = arguments.output.lower().endswith(".json")
    write(arguments.output, write_bml_json(performance, form=form) if is_json else files.speaker)
    if files.speech and arguments.output != STANDARD:
        write(_beside_act(arguments.output, files.speech.name), files.speech.content)
    elif files.speech:
        log.warnings([files.speech.left_out])
    for name, content in files.listeners.items():
        write(_beside(arguments.output, name), content)


def _speech_file_names(arguments: argparse.Namespace) -> list[OutputName]:
    name = speech_file_name(bml_form(arguments))
    return [] if name is None or arguments.output == STANDARD else [_beside_act(arguments.output, name)]


def _beside_act(output: str, name: str) -> OutputName:
    """SmartBody's file for the folder of the recording, written to the folder of the act."""
    return OutputName(PurePath(output).with_name(name))


def _beside(output: str, name: str) -> OutputName:
    """OUT.NAME.bml for OUT.bml, OUT.NAME.xml for OUT.xml, and OUT.NAME.bml for any other OUT."""
    ending = ".xml" if PurePath(output).suffix.lower() == ".xml" else ".bml"
    return OutputName(PurePath(output).with_suffix(f".{name}{ending}"))


def _check_targets(arguments: argparse.Namespace, settings: Settings) -> None:
    """Raises InputError before the work is done if its result could not be written."""
    if arguments.listener and arguments.output == STANDARD:
        raise InputError("usage", "a listener's BML is written beside the speaker's; give -o OUT.bml")
    listeners = [_beside(arguments.output, name) for name in listener_names(arguments.listener)]
    beside = [*listeners, *_speech_file_names(arguments)]
    require_distinct(arguments, beside)
    for output in (arguments.output, *beside):
        require_writable(output, field="output")
    require_motions(arguments.realize, settings, field="realize")
    if arguments.trace:
        require_writable(arguments.trace, field="trace")


def script(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    require_writable(arguments.output, field="output")
    line = read_line(arguments, settings)
    options = performance_options(arguments)
    check_character(options.character)
    check_line(line, settings)
    from ...library.performing import perform_line
    from ...models import Understudy  # imported late: arguments are checked before the models load
    from ...schemas.gestures.script import script_json

    with uncollected(), Understudy.load(settings) as understudy:
        performed = perform_line(understudy, line, options, log.stage)
    performance = performed.performance
    write(arguments.output, script_json(performed.written_script(), performance.utterance, performance.character))
    log.warnings(performance.notices)
    return 0
