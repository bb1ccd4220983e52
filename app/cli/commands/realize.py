"""`understudy realize`: BML in, motion out, in the format that each output's name ends in."""

import argparse
from pathlib import Path

from app.cli.files import STANDARD, read_bytes
from app.cli.log import Log
from app.cli.motions import require_motions, write_motions
from app.errors import InputError
from app.model import Level
from app.performance import Ears
from app.realization import Realizer, Sheet, stage
from app.resources import resource_folder
from app.settings import read_settings


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    require_motions(arguments.output, field="output")
    if arguments.bml == STANDARD and arguments.audio == STANDARD:
        raise InputError("usage", "only one of BML and audio can come from standard input (-)")
    audio = None
    if arguments.audio:
        audio = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    bml = read_bytes(arguments.bml, limit=settings.max_body_bytes, field="bml")
    sheet = Sheet(bml, Path("standard input" if arguments.bml == STANDARD else arguments.bml), audio)
    level = arguments.agitation and Level(arguments.agitation)
    realizer = Realizer.load(resource_folder("lexicon"))
    with Ears.load(settings) as ears:
        staged = stage(ears, sheet, agitation=level, character=arguments.character, progress=log.stage)
    log.warnings(staged.notices)
    write_motions(arguments.output, realizer, staged, arguments, log)
    return 0
