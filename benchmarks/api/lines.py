"""Valid requests, for the parts of the drill that test normal work.

A worker remembers its last lines (`KnownLines`), so that no line is asked for twice in a row: the last sample differs
in `VARIANTS` recordings, which are asked for in turns.
"""

import io
from functools import cache
from itertools import count

import numpy as np
import soundfile

from understudy.model import FloatArray

from .attacks import AUDIO, Attack, Body, bml, form
from .broken.audio import recordings
from .broken.inputs import TEXT, WORDS, request, words_file

FIVE_S = AUDIO.parents[1] / "tests" / "audio" / "numbers.flac"
EXAMPLE = AUDIO.with_suffix(".txt")

VARIANTS = 32
"""Many more than the lines that all workers remember."""


@cache
def line_of(duration_s: float) -> Attack:
    """A line whose recording lasts so long: one of 4.6 s with silence after it, said again where that is too short."""
    samples, rate_hz = soundfile.read(FIVE_S, dtype="float32")
    times = max(1, int(duration_s * rate_hz / len(samples)))
    silence = np.zeros(max(0, round(duration_s * rate_hz) - times * len(samples)), np.float32)
    text = " ".join([FIVE_S.with_suffix(".txt").read_text(encoding="utf-8").strip()] * times)
    files = _variants(np.concatenate([*[samples] * times, silence]), rate_hz)
    return _in_turns([form(audio=("a.flac", file), text=text) for file in files], "application/xml")


@cache
def timed_line() -> Attack:
    """A short line whose words are in time."""
    samples, rate_hz = soundfile.read(io.BytesIO(recordings()["FLAC PCM_16"]), dtype="float32")
    words = ("w.json", words_file(WORDS))
    return _in_turns([form(audio=("a.flac", each), text=TEXT, words=words) for each in _variants(samples, rate_hz)])


def _variants(samples: FloatArray, rate_hz: int) -> list[bytes]:
    """The recording as FLAC, each time with another last sample."""
    made = []
    for number in range(VARIANTS):
        file, changed = io.BytesIO(), samples.copy()
        changed[-1] = (number + 1) / 32768
        soundfile.write(file, changed, rate_hz, "PCM_16", format="FLAC")
        made.append(file.getvalue())
    return made


def _in_turns(bodies: list[Body], accept: str = "application/json") -> Attack:
    numbers = count()
    return Attack("/perform", "/perform", lambda: bodies[next(numbers) % len(bodies)], accept)


def usual() -> tuple[Attack, ...]:
    """What callers ask in turns: words alone, a line whose words are in time, BML to be played, and a mistake."""
    played = form(bml=("b.bml", bml('<head id="h" lexeme="NOD" start="0" end="0.4"/>')[1]), options='{"fps": 30}')
    return (
        request("/functions", ("application/json", b'{"text": "%s"}' % TEXT.encode())),
        timed_line(),
        request("/functions", ("application/json", b'{"text": "You never know, do you?"}')),
        request("/realize", played),
        request("/perform", form(audio=("a.flac", b"none"), text=TEXT)),
    )
