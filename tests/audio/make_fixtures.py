"""Makes the audio of the tests and of the bundled example, with the exact times of its words and phones.

Everything is spoken by flite 2.2 (Debian's `flite`, voice slt), which prints the phone times of what it speaks
(`-psdur`). Words in `emphasised` are made louder afterwards, which moves no boundary. Each line leaves NAME.flac and
NAME.txt in its folder, and its truth as tests/audio/NAME.json, in the shape `understudy align` answers with:
seconds, ARPABET labels, `index` the number of the transcript's word.

Run from the root of the checkout: `python -m tests.audio.make_fixtures`.
"""

import json
import subprocess
import tempfile
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path

import numpy as np
import soundfile

from understudy.model import FloatArray

TRUTH = Path(__file__).parent
EXAMPLES = TRUTH.parents[1] / "examples"
EMPHASIS_GAIN = 2.5
FADE_S = 0.015
PEAK = 0.8


@dataclass(frozen=True, slots=True)
class Line:
    """One line: its words as written, and what flite speaks for each of them, `|` between words, `pau` left out."""

    name: str
    folder: Path
    text: str
    phones: str
    emphasised: tuple[int, ...] = ()


LINES = (
    Line(
        "figure8",
        TRUTH,
        "I guess not, I think I must've misread all of those signals.",
        "ay | g eh s | n aa t | ay | th ih ng k | ay | m ah s t ax v | m ih s r iy d | ao l | ah v | dh ow z "
        "| s ih g n ax l z",
        emphasised=(1, 10),
    ),
    Line(
        "example",
        EXAMPLES,
        "No, I have never seen anything like those lights before! "
        "Are you really sure this is the best way, or should we all go back?",
        "n ow | ay | hh ae v | n eh v er | s iy n | eh n iy th ih ng | l ay k | dh ow z | l ay t s | b ih f ao r "
        "| aa r | y uw | r ih l iy | sh uh r | dh ih s | ih z | dh ax | b eh s t | w ey | ao r | sh uh d | w iy "
        "| ao l | g ow | b ae k",
        emphasised=(3, 17),
    ),
    Line(
        "numbers",
        TRUTH,
        "Dr. Brown met 25 people on 3rd Street — in 1984.",
        "d aa k t er | b r aw n | m eh t | t w eh n t iy f ay v | p iy p ax l | aa n | th er d | s t r iy t | "
        "| ih n | n ay n t iy n ey t iy f ao r",
    ),
)


def main() -> None:
    """Speaks and writes every line."""
    for line in LINES:
        samples, rate_hz, segments = spoken(line.text)
        words = truth(line, segments)
        samples = emphasise(samples, rate_hz, [words[index] for index in line.emphasised])
        soundfile.write(line.folder / f"{line.name}.flac", samples * (PEAK / np.abs(samples).max()), rate_hz, "PCM_16")
        (line.folder / f"{line.name}.txt").write_text(line.text + "\n", encoding="utf-8")
        (TRUTH / f"{line.name}.json").write_text(json.dumps({"words": words}, indent=1) + "\n", encoding="utf-8")


def spoken(text: str) -> tuple[FloatArray, int, list[tuple[str, float, float]]]:
    """What flite makes of `text`: samples, their rate, and the phones with their start and end."""
    with tempfile.TemporaryDirectory() as folder:
        wav = Path(folder) / "line.wav"
        run = subprocess.run(
            ["flite", "-voice", "slt", "-psdur", "-t", text, "-o", str(wav)], check=True, capture_output=True, text=True
        )
        samples, rate_hz = soundfile.read(wav)
    labels_and_ends = [part.split(":") for part in run.stdout.split()]
    ends_s = [0.0, *(float(end) for _, end in labels_and_ends)]
    segments = [(label, *span) for (label, _), span in zip(labels_and_ends, pairwise(ends_s), strict=True)]
    return samples, rate_hz, [segment for segment in segments if segment[0] != "pau"]


def truth(line: Line, segments: list[tuple[str, float, float]]) -> list[dict[str, object]]:
    """The words of the line with the phones flite spoke for them; one that is not spoken has no times."""
    remaining = iter(segments)
    words = []
    for index, (text, labels) in enumerate(zip(line.text.split(), line.phones.split("|"), strict=True)):
        phones = []
        for expected in labels.split():
            label, start_s, end_s = next(remaining)
            if label != expected:
                raise SystemExit(f"{line.name}, word {index} {text!r}: flite says {label!r}, the table {expected!r}")
            phones.append({"label": label.upper().replace("AX", "AH"), "start_s": start_s, "end_s": end_s})
        times = {"start_s": phones[0]["start_s"], "end_s": phones[-1]["end_s"]} if phones else {}
        words.append({"index": index, "text": text, **times, "phones": phones})
    return words


def emphasise(samples: FloatArray, rate_hz: int, words: list[dict[str, object]]) -> FloatArray:
    """The samples with `words` made louder, faded in and out inside them."""
    times_s = np.arange(len(samples)) / rate_hz
    gain = np.ones(len(samples))
    for word in words:
        start_s, end_s = float(str(word["start_s"])), float(str(word["end_s"]))
        shape = np.clip(np.minimum(times_s - start_s, end_s - times_s) / FADE_S, 0.0, 1.0)
        gain += (EMPHASIS_GAIN - 1.0) * shape
    return samples * gain


if __name__ == "__main__":
    main()
