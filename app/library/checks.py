"""Checks a line before anything large is loaded.

Loading spaCy, the aligner and their models takes most of the time of a short line; nothing here needs them.
"""

from ..acoustic.alignment.timings import read_timings
from ..acoustic.signal.decoding import decode
from ..acoustic.stage import audio_limits
from ..authored_folders import rules_folder
from ..behavior.candidates.notes import check_direction
from ..model import GivenFunction, Line
from ..models import load_characters
from ..rules.derivation import given_facts
from ..rules.priorities import Priorities
from ..settings import Settings
from ..text.transcript import read_transcript


def check_line(line: Line, settings: Settings) -> None:
    """Raises InputError as the performance would, for the line's audio, text, word timings, functions and notes."""
    transcript = read_transcript(line.text)
    duration_s = settings.max_audio_s
    if line.audio is not None:
        duration_s = decode(line.audio, audio_limits(settings))[0].duration_s
    if line.timings is not None:
        read_timings(line.timings.content, line.timings.format, transcript, duration_s=duration_s)
    _check_functions(line.functions, len(transcript))
    if line.direction is not None:
        check_direction(line.direction, words=len(transcript))


def check_character(name: str) -> None:
    """Raises InputError `unknown_character`."""
    load_characters().named(name)


def _check_functions(given: tuple[GivenFunction, ...], words: int) -> None:
    if given:
        given_facts(given, Priorities.load(rules_folder() / "functions" / "priorities.yaml"), words=words)
