"""`understudy realize`: BML in, motion out, in the format that each output's name ends in."""

import argparse
from pathlib import Path

from ...errors import InputError
from ...model import Level
from ...performance import AcousticModels
from ...realization import BmlInput, Realizer, prepare_schedule
from ...resources import resource_folder
from ...settings import read_settings
from ..files import STANDARD, read_bytes
from ..log import Log
from ..motions import require_motions, write_motions


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    require_motions(arguments.output, field="output")
    if arguments.bml == STANDARD and arguments.audio == STANDARD:
        raise InputError("usage", "only one of BML and audio can come from standard input (-)")
    audio = None
    if arguments.audio:
        audio = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    bml = read_bytes(arguments.bml, limit=settings.max_body_bytes, field="bml")
    sheet = BmlInput(bml, Path("standard input" if arguments.bml == STANDARD else arguments.bml), audio)
    level = arguments.agitation and Level(arguments.agitation)
    realizer = Realizer.load(resource_folder("lexicon"))
    with AcousticModels.load(settings) as acoustic:
        staged = prepare_schedule(
            acoustic,
            sheet,
            agitation=level,
            character=arguments.character,
            stillness=arguments.stillness,
            progress=log.stage,
        )
    log.warnings(staged.notices)
    write_motions(arguments.output, realizer, staged, arguments, log)
    return 0
