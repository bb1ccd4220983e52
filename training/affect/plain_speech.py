"""Says directed lines plainly, with synthetic voices.

    python -m training.affect.plain_speech OUT [--lines N] [--held-out]

OUT gets `ID.VOICE.flac` and `index.jsonl`, as those of `training/focus/speaking.py`, with a neutral tone, no focus
and no times. The lines are drawn by chance from the carefully directed ones that are trained on, or with `--held-out`
from those that are not; voices take turns. A voice that means nothing is what texts are often given, and its habits are
to be told from a feeling.
"""

import argparse
import json
import random
from pathlib import Path

import numpy as np
import soundfile

from training.acting.directed import DirectedLine, is_held_out, read_lines
from training.focus.speaking import VOICES, said_plainly
from understudy.model import SAMPLE_RATE_HZ, FloatArray

LEVEL, SILENCE_S = 0.05, 0.25
"""The root mean square of the samples, and the silence at both ends."""


def plain(text: str, voice: str) -> FloatArray:
    """The text at a usual level, between silences."""
    samples = said_plainly(text, voice)
    silence = np.zeros(round(SILENCE_S * SAMPLE_RATE_HZ))
    return np.concatenate([silence, samples * LEVEL / np.sqrt(np.mean(samples**2)), silence])


def chosen(directing: Path, count: int | None, *, held_out: bool) -> list[DirectedLine]:
    """The lines that are said."""
    lines = [line for line in read_lines(directing) if line.careful and not line.is_delivery]
    lines = [line for line in lines if is_held_out(line) is held_out]
    random.Random(0).shuffle(lines)
    return lines[:count]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument("--lines", type=int)
    parser.add_argument("--held-out", action="store_true")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    with (options.out / "index.jsonl").open("w", encoding="utf-8") as index:
        for place, line in enumerate(chosen(options.directing, options.lines, held_out=options.held_out)):
            voice = VOICES[place % len(VOICES)]
            path = f"{line.name}.{voice}.flac"
            soundfile.write(options.out / path, plain(" ".join(line.words), voice), SAMPLE_RATE_HZ, subtype="PCM_16")
            said = {"id": line.name, "path": path, "voice": voice, "tone": "neutral", "loudness": 0}
            print(json.dumps(said), file=index, flush=True)


if __name__ == "__main__":
    main()
