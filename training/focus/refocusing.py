"""Gives recordings of real speech a focus that they did not have: what a person said, with one word marked.

    python -m training.focus.refocusing OUT [--speech FOLDER] [--times N]

Spoken words have accents, pitch that falls and rises at boundaries, and errors of measurement that synthetic voices
lack. Recordings: those of public domain in `lines/` but for the speech that the figures are taken on, every second
sentence of TIMIT as `training/alignment/timit.py` divides it, and RAVDESS' neutral and calm lines. OUT gets FLAC files
and an index as `training/focus/speaking.py` makes it.
"""

import argparse
import json
import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import soundfile

from training.alignment.timit import read_sentences
from training.focus.speaking import ROOT, Degree, Habits, deliver, take_apart
from understudy.acoustic.alignment.aligner import Aligner
from understudy.acoustic.signal.decoding import AudioLimits, decode
from understudy.model import SAMPLE_RATE_HZ, FloatArray

SPEECH = ROOT.parent / "shared" / "data" / "speech"
MEASURED_ON = frozenset(("jfk",))
TEXTS = {"01": "Kids are talking by the door", "02": "Dogs are sitting by the door"}


@dataclass(frozen=True, slots=True)
class Recording:
    """What somebody said."""

    name: str
    speaker: str
    text: str
    samples: FloatArray


def main() -> None:
    """Writes the recordings."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("out", type=Path)
    parser.add_argument("--speech", type=Path, default=SPEECH)
    parser.add_argument("--times", type=int, default=4, help="how often each is given another focus")
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    with (
        Aligner(ROOT / "models", ROOT / "lexicon" / "en") as aligner,
        (options.out / "index-real-0.jsonl").open("w") as index,
    ):
        for recording in recordings(options.speech):
            for entry in refocus(recording, options.times, options.out, aligner):
                print(json.dumps(entry), file=index, flush=True)


def recordings(speech: Path) -> Iterator[Recording]:
    """The real speech that the model is taught on."""
    for path in sorted((speech / "lines").glob("*.flac")):
        if path.stem not in MEASURED_ON:
            yield Recording(path.stem, path.stem[:4], path.with_suffix(".txt").read_text(), _samples(path))
    for place, sentence in enumerate(read_sentences(speech / "timit")[0][::2]):
        yield Recording(f"timit-{place}", f"timit-{place}", sentence.text, sentence.audio.samples)
    for path in sorted((speech / "ravdess").glob("03-01-0[12]-01-*.flac")):
        parts = path.stem.split("-")
        yield Recording(path.stem, f"ravdess-{parts[6]}", TEXTS[parts[4]], _samples(path))


def _samples(path: Path) -> FloatArray:
    return decode(path.read_bytes(), AudioLimits())[0].samples


def refocus(recording: Recording, times: int, out: Path, aligner: Aligner) -> Iterator[dict[str, object]]:
    """The recording as it is, and with the focus on one word after another, chosen at random; entries of the index."""
    said = take_apart(recording.samples, recording.text, aligner)
    if said is None:
        return
    plain = f"{recording.name}.flac"
    soundfile.write(out / plain, recording.samples, SAMPLE_RATE_HZ, subtype="PCM_16")
    known = {"voice": recording.speaker, "text": recording.text}
    yield known | {"id": recording.name, "path": plain, "focus": []}
    random = np.random.default_rng(zlib.crc32(recording.name.encode()))
    places = [place for place, word in enumerate(said.words) if word]
    for focus in random.permutation(places)[:times].tolist():
        delivery = {"focus": [focus], "tone": "neutral", "loudness": 0}
        degree = Degree.drawn(random)
        samples, words = deliver(said, delivery, (degree, Habits()), random)
        path = f"{recording.name}.{focus}.flac"
        soundfile.write(out / path, samples, SAMPLE_RATE_HZ, subtype="PCM_16")
        yield (
            known | delivery | {"id": f"{recording.name}.{focus}", "path": path, "degree": degree.pitch, "words": words}
        )


if __name__ == "__main__":
    main()
