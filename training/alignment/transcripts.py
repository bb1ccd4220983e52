"""Recordings with right and wrong texts: clean (TIMIT), acted (RAVDESS, calm to shouting), synthetic (the directing
lines), and every second of the clean and synthetic ones in noise.

Wrong texts are two others, any one and one of about the same length, the first half of the right one, and the right one
with eight words of another. RAVDESS has two sentences of which four words of six are the same: the other of the two is
no wrong text here.
"""

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import soundfile
import soxr

from understudy.model import SAMPLE_RATE_HZ, Audio

from ..acting.directed import read_lines
from .timit import read_sentences

FLITE = frozenset(("slt", "rms", "awb", "kal16"))
"""Voices made of recordings, unlike those of espeak-ng."""

RAVDESS_TEXTS = {"01": "Kids are talking by the door", "02": "Dogs are sitting by the door"}
RAVDESS_STEP = 6
NOISE_DB = -15.0
"""Against the speech."""

PLAIN_LINES = 150

ALIKE = 12
"""Of so many others that are nearest in length one is taken."""

OWN, ANOTHER, OF_SAME_LENGTH, HALF, TOO_MUCH = "own", "another", "another of that length", "half", "eight words more"
OTHERS = (ANOTHER, OF_SAME_LENGTH)


@dataclass(frozen=True, slots=True)
class Recording:
    """A recording with its text; `kind` tells where it is from, `half` which of two halves of the material it is in."""

    kind: str
    half: int
    audio: Audio
    text: str


def read_recordings(shared: Path, ravdess_step: int = RAVDESS_STEP) -> list[Recording]:
    """All recordings, each source's in the order of its files; of RAVDESS every `ravdess_step`th."""
    clean = list(_timit(shared / "data" / "speech" / "timit"))
    acted = list(_ravdess(shared / "data" / "speech" / "ravdess", ravdess_step))
    synthetic = list(_synthetic(shared / "directing"))
    chance = np.random.default_rng(0)
    noisy = [_in_noise(each, chance) for source in (clean, synthetic) for each in source[::2]]
    return [*clean, *acted, *synthetic, *noisy]


def read_plain(folder: Path, directing: Path) -> list[Recording]:
    """What `training/affect/plain_speech.py` has said with the voices of espeak-ng, up to `PLAIN_LINES` of it: whose
    sounds are like nobody's."""
    texts = {line.name: " ".join(line.words) for line in read_lines(directing)}
    rows = map(json.loads, (folder / "index.jsonl").read_text(encoding="utf-8").splitlines())
    said = [row for row in rows if row["voice"] not in FLITE][:PLAIN_LINES]
    return [
        Recording("formants", number % 2, _audio(folder / row["path"]), texts[row["id"]])
        for number, row in enumerate(said)
    ]


def texts_for(recordings: Sequence[Recording], number: int) -> Iterator[tuple[str, str]]:
    """What kind of text each is, and the text."""
    own = recordings[number].text
    others = sorted({each.text for each in recordings if not _is_nearly(each.text, own)})
    any_other = others[37 * number % len(others)]
    alike = sorted(others, key=lambda text: abs(len(text) - len(own)))[:ALIKE]
    words = own.split()
    yield OWN, own
    yield ANOTHER, any_other
    yield OF_SAME_LENGTH, alike[number % len(alike)]
    yield HALF, " ".join(words[: max(1, len(words) // 2)])
    yield TOO_MUCH, " ".join([*words, *any_other.split()[:8]])


def _is_nearly(text: str, own: str) -> bool:
    return text == own or {text, own} == set(RAVDESS_TEXTS.values())


def _timit(folder: Path) -> Iterator[Recording]:
    for number, sentence in enumerate(read_sentences(folder)[0]):
        yield Recording("clean", number % 2, sentence.audio, sentence.text)


def _ravdess(folder: Path, step: int) -> Iterator[Recording]:
    for path in sorted(folder.glob("*.flac"))[::step]:
        *_, sentence, _take, actor = path.stem.split("-")
        yield Recording("acted", (int(actor) // 2) % 2, _audio(path), RAVDESS_TEXTS[sentence])


def _synthetic(folder: Path) -> Iterator[Recording]:
    for number, row in enumerate((folder / "dev-lines.jsonl").read_text(encoding="utf-8").splitlines()):
        line = json.loads(row)
        text = " ".join(word.split(":", 1)[1] for word in line["words"])
        yield Recording("synthetic", number % 2, _audio(folder / "audio" / f"{line['id']}.flac"), text)


def _audio(path: Path) -> Audio:
    samples, rate_hz = soundfile.read(path, always_2d=True)
    return Audio(soxr.resample(samples[:, 0], rate_hz, SAMPLE_RATE_HZ))


def _in_noise(recording: Recording, chance: np.random.Generator) -> Recording:
    """With white and brown noise, half and half."""
    samples = recording.audio.samples
    white = chance.standard_normal(len(samples))
    noise = white + 0.02 * np.cumsum(white)
    noise -= noise.mean()
    gain = 10 ** (NOISE_DB / 20) * np.sqrt(np.mean(samples**2) / np.mean(noise**2))
    return replace(recording, kind=f"{recording.kind}, noise", audio=Audio(samples + gain * noise))
