"""`understudy realize`: BML in, motion out, in the formats given by the outputs' names."""

from __future__ import annotations

import argparse
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING

from ...errors import InputError
from ...model import Level
from ...model.targets import read_targets
from ...option_table import MOTION
from ...settings import Settings, read_settings
from ..files import STANDARD, read_bytes
from ..log import Log
from ..outputs.motions import MotionOptions, recording, require_motions, write_motions

if TYPE_CHECKING:
    from ...library.hearing import AcousticModels
    from ...library.motion import PreparedSchedule


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    require_motions(arguments.output, settings, field="output")
    if arguments.bml == STANDARD and arguments.audio == STANDARD:
        raise InputError("usage", "only one of BML and audio can come from standard input (-)")
    options = MotionOptions.of(arguments, settings)
    MOTION["stillness"].check(arguments.stillness)
    audio = None
    if arguments.audio:
        audio = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    bml = read_bytes(arguments.bml, limit=settings.max_body_bytes, field="bml")
    staged = _prepared(bml, audio, arguments, settings, log)
    log.warnings(staged.notices)
    write_motions(arguments.output, staged, options, recording(arguments.audio, audio), log)
    return 0


def _prepared(
    bml: bytes, audio: bytes | None, arguments: argparse.Namespace, settings: Settings, log: Log
) -> PreparedSchedule:
    """The schedule; the acoustic models are loaded only if there is a recording."""
    from ...library.motion import BmlInput, PreparedSchedule, prepare_schedule

    if bml.lstrip().startswith(b"{"):
        from ...schemas.gestures.script import read_script  # takes long to import, and BML does not need it

        return PreparedSchedule.of(read_script(bml))
    sheet = BmlInput(bml, Path("standard input" if arguments.bml == STANDARD else arguments.bml), audio)
    level = arguments.agitation and Level(arguments.agitation)
    with ExitStack() as stack:
        acoustic = None if audio is None else stack.enter_context(_acoustic(settings))
        return prepare_schedule(
            acoustic,
            sheet,
            agitation=level,
            character=arguments.character,
            stillness=arguments.stillness,
            targets=read_targets(arguments.target),
            seed=arguments.seed,
            progress=log.stage,
        )


def _acoustic(settings: Settings) -> AcousticModels:
    from ...library.hearing import AcousticModels  # takes long to import, and only a recording needs it

    return AcousticModels.load(settings)
