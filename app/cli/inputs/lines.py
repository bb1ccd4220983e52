"""Converts the arguments that several commands share to the input of a performance."""

import argparse

from ...errors import InputError
from ...model import Direction, GivenFunction, Line, Timings
from ...model.edits import NO_EDITS, Edits
from ...schemas.direction import read_direction
from ...schemas.edits import read_edits
from ...schemas.given_functions import read_functions
from ...schemas.requests import read_timings, spoken_line
from ...settings import Settings
from ..files import STANDARD, read_bytes, read_text


def read_line(arguments: argparse.Namespace, settings: Settings) -> Line:
    """The line of AUDIO, if the command hears one, `--text` or `--text-file`, `--words`, `--functions` and
    `--direction`.

    Raises InputError for what cannot be read.
    """
    parts = ("audio", "text_file", "words", "functions", "direction", "edits")
    if [getattr(arguments, part) for part in parts].count(STANDARD) > 1:
        raise InputError(
            "usage", "only one of audio, text, words, functions, direction and edits can come from standard input (-)"
        )
    text = _text(arguments, settings)
    timings = None if arguments.words is None else _timings(arguments.words, settings)
    functions = () if arguments.functions is None else _functions(arguments.functions, settings)
    direction = None if arguments.direction is None else _direction(arguments.direction, settings)
    if arguments.audio is None:
        return spoken_line(text, timings, functions, direction)
    audio = read_bytes(arguments.audio, limit=settings.max_audio_bytes, field="audio")
    return Line(audio, text, timings, functions, direction)


def edits_of(arguments: argparse.Namespace, settings: Settings) -> Edits:
    """The edits of `--edits`; raises InputError for what cannot be read."""
    if arguments.edits is None:
        return NO_EDITS
    return read_edits(read_bytes(arguments.edits, limit=settings.part_limits["edits"], field="edits"))


def _text(arguments: argparse.Namespace, settings: Settings) -> str:
    if arguments.text is not None:
        return str(arguments.text)
    return read_text(arguments.text_file, max_characters=settings.max_text_characters, field="text")


def _timings(name: str, settings: Settings) -> Timings:
    return read_timings(name, read_bytes(name, limit=settings.max_body_bytes, field="words"))


def _functions(name: str, settings: Settings) -> tuple[GivenFunction, ...]:
    return read_functions(read_bytes(name, limit=settings.max_body_bytes, field="functions"))


def _direction(name: str, settings: Settings) -> Direction:
    return read_direction(read_bytes(name, limit=settings.max_body_bytes, field="direction"))
