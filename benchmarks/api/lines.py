"""Valid requests, for the parts of the drill that test normal work."""

import io
from functools import cache

import numpy as np
import soundfile

from .attacks import AUDIO, Attack, bml, form
from .broken.audio import recordings
from .broken.inputs import TEXT, WORDS, request, words_file

FIVE_S = AUDIO.parents[1] / "tests" / "audio" / "numbers.flac"
EXAMPLE = AUDIO.with_suffix(".txt")


@cache
def line_of(duration_s: float) -> Attack:
    """A line whose recording lasts so long: one of 4.6 s with silence after it, said again where that is too short."""
    samples, rate_hz = soundfile.read(FIVE_S, dtype="float32")
    times = max(1, int(duration_s * rate_hz / len(samples)))
    silence = np.zeros(max(0, round(duration_s * rate_hz) - times * len(samples)), np.float32)
    file = io.BytesIO()
    soundfile.write(file, np.concatenate([*[samples] * times, silence]), rate_hz, "PCM_16", format="FLAC")
    text = FIVE_S.with_suffix(".txt").read_text(encoding="utf-8").strip()
    return request(
        "/perform", form(audio=("a.flac", file.getvalue()), text=" ".join([text] * times)), "application/xml"
    )


def usual() -> tuple[Attack, ...]:
    """What callers ask in turns: words alone, a line whose words are in time, BML to be played, and a mistake."""
    timed = form(audio=("a.flac", recordings()["FLAC PCM_16"]), text=TEXT, words=("w.json", words_file(WORDS)))
    played = form(bml=("b.bml", bml('<head id="h" lexeme="NOD" start="0" end="0.4"/>')[1]), options='{"fps": 30}')
    return (
        request("/functions", ("application/json", b'{"text": "%s"}' % TEXT.encode())),
        request("/perform", timed),
        request("/functions", ("application/json", b'{"text": "You never know, do you?"}')),
        request("/realize", played),
        request("/perform", form(audio=("a.flac", b"none"), text=TEXT)),
    )
