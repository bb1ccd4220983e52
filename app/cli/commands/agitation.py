"""`understudy agitation`: the speaker's agitation in each file, one JSON line a file, in order."""

import argparse
import os

from app.answers import AgitationAnswer
from app.cli.files import read_bytes, write_standard
from app.cli.log import Log
from app.errors import InputError
from app.performance import Ears, Heard, hear
from app.settings import read_settings


def run(arguments: argparse.Namespace, log: Log) -> int:
    settings = read_settings()
    ears = Ears.load(settings)
    for path in arguments.audio:
        audio = read_bytes(path, limit=settings.max_audio_bytes, field="audio")
        name = os.fsencode(path).decode(errors="replace")
        heard = _heard(ears, audio, name)
        write_standard(AgitationAnswer.of(name, heard.agitation).to_json() + b"\n")
        log.warnings(heard.notices, of=name)
    return 0


def _heard(ears: Ears, audio: bytes, name: str) -> Heard:
    """Raises InputError as `hear` does, with the file's name, since there may be several."""
    try:
        return hear(ears, audio)
    except InputError as error:
        raise InputError(error.code, f"{name}: {error.message}", field=error.field) from None
