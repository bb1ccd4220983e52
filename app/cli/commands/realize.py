"""`understudy realize`: BML in, motion out, in the formats given by the outputs' names."""

from __future__ import annotations

import argparse
from contextlib import ExitStack
from pathlib import Path, PurePath
from typing import TYPE_CHECKING

from ...errors import InputError
from ...model import DEFAULT_CHARACTER, Level
from ...model.targets import read_targets
from ...models import load_realizer
from ...option_table import MOTION
from ...settings import Settings, read_settings
from ..files import STANDARD, read_bytes
from ..log import Log
from ..outputs.motions import MotionOptions, export_motions, recording, require_motions, write_motions

if TYPE_CHECKING:
    from ...library.hearing import AcousticModels
    from ...library.motion import PreparedSchedule

PARAMETERS = (".bap", ".fap")
"""Endings of MPEG-4's files, which are read as motion."""


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
    if PurePath(arguments.bml).suffix.lower() in PARAMETERS:
        _write_read(arguments, bml, options, log)
        return 0
    if arguments.fap:
        raise InputError("usage", "--fap belongs to FILE.bap; give that as well")
    staged = _prepared(bml, audio, arguments, settings, log)
    log.warnings(staged.notices)
    write_motions(arguments.output, staged, options, recording(arguments.audio, audio), log)
    return 0


def _write_read(arguments: argparse.Namespace, content: bytes, options: MotionOptions, log: Log) -> None:
    """Writes motion that is read from MPEG-4 parameters, at their own rate.

    Raises InputError `usage`, `file_unreadable`, `mpeg4_wrong`.
    """
    from ...library.motion import read_mpeg4

    is_body = PurePath(arguments.bml).suffix.lower() == ".bap"
    if arguments.audio or (arguments.fap and not is_body):
        raise InputError("usage", "MPEG-4 parameters are read alone, or as FILE.bap with --fap FILE.fap")
    face = None
    if arguments.fap:
        face = (arguments.fap, read_bytes(arguments.fap, limit=read_settings().max_body_bytes, field="fap"))
    read = (arguments.bml, content)
    realizer = load_realizer()
    found = read_mpeg4(
        read if is_body else None, face if is_body else read, realizer, arguments.character or DEFAULT_CHARACTER
    )
    log.stage("export")
    export_motions(arguments.output, found, realizer, options, None)


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
