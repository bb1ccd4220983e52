"""Speaks deliveries: the same words with another focus, tone and loudness, by synthetic voices and WORLD.

    python -m training.focus.speaking DELIVERIES.jsonl OUT [--takes N] [--first-take N] [--part I/N]

flite and espeak-ng say the words; WORLD then changes pitch, loudness, length and vocal effort, as the phonetics of
English narrow focus and the usual account of vocal affect have it: the focused word rises, widens, and is longer and
louder; what follows is compressed. Each take has another voice, its own degree of each of these cues, and from the
second on the habits of a speaker that are not focus: declination, smaller accents on other words, rises at boundaries,
lengthened ends; so that a model relies on whichever cue is there and on none alone. DELIVERIES has an object a line:
`id`, `base`, `words`, `focus`, `tone`, `loudness`. OUT gets `ID.VOICE.flac` and an index of them with the times of the
words, which follow from those that the aligner finds in the words as first said.

Needs the programs flite and espeak-ng, and the package pyworld; none of them is needed to run the service.
"""

import argparse
import json
import subprocess
import tempfile
import zlib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np
import pyworld
import soundfile
import soxr
from numpy.typing import NDArray

from training.alignment.transcripts import FLITE
from understudy.acoustic.alignment.aligner import Aligner
from understudy.errors import UnderstudyError
from understudy.model import SAMPLE_RATE_HZ, Audio, FloatArray
from understudy.text.transcript import read_transcript

ROOT = Path(__file__).resolve().parents[2]
STEP_MS = 5.0
VOICES = ("slt", "en-us+f3", "rms", "en-gb-x-rp+m3", "awb", "kal16", "en-us+m7", "en-gb-scotland+f2", "en-us+f5")
FRAME_S = STEP_MS / 1000


@dataclass(frozen=True, slots=True)
class Tone:
    """What a tone does to a whole line: factors of pitch, range and tempo; dB of level and of tilt at 4 kHz; breath and
    tremor in [0, 1]."""

    pitch: float = 1.0
    spread: float = 1.0
    tempo: float = 1.0
    level_db: float = 0.0
    tilt_db: float = 0.0
    breath: float = 0.0
    tremor: float = 0.0


TONES = {
    "neutral": Tone(),
    "angry": Tone(1.22, 1.5, 1.08, 7, 7),
    "sad": Tone(0.93, 0.55, 0.8, -5, -4, 0.25),
    "happy": Tone(1.22, 1.5, 1.05, 3, 3),
    "afraid": Tone(1.32, 0.8, 1.12, -1, 1, 0.35, 0.03),
    "disgusted": Tone(0.92, 0.9, 0.88, 0, 2),
    "amused": Tone(1.08, 1.45, 0.95, 0, 0, 0.1),
    "tender": Tone(0.98, 0.7, 0.84, -6, -5, 0.3),
    "weary": Tone(0.88, 0.5, 0.78, -5, -3, 0.2),
    "excited": Tone(1.32, 1.7, 1.14, 5, 5),
    "hesitant": Tone(1.0, 0.8, 0.8, -3, -2, 0.1),
    "commanding": Tone(1.05, 1.25, 0.95, 6, 6),
}


@dataclass(frozen=True, slots=True)
class Degree:
    """How strongly each cue marks the focus; 1 is clear, 0 leaves it as first said. A negative pitch is a low accent.
    `peak` is where in the word pitch is highest, below 1 late, above early."""

    pitch: float
    level: float
    length: float
    before: float
    after: float
    pause_s: float = 0.0
    peak: float = 0.8

    @classmethod
    def drawn(cls, random: np.random.Generator) -> "Degree":
        """A degree; the cues partly agree, and one may be missing."""
        common = random.uniform(0.45, 1.1)
        cues = common * random.uniform(0.6, 1.3, 5)
        if random.random() < 0.25:
            cues[random.integers(5)] *= 0.2
        if random.random() < 0.06:
            cues[0] *= -0.6
        pause_s = random.uniform(0.06, 0.25) if random.random() < 0.12 else 0.0
        pitch, level, length, before, after = map(float, cues)
        return cls(pitch, level, length, before, after, pause_s, random.uniform(0.5, 1.6))


@dataclass(frozen=True, slots=True)
class Habits:
    """What a speaker's pitch, level and pace do beside the focus: log pitch a second of declination, the size of other
    words' accents, of rises and of lengthening before pauses; all 0 for none."""

    declination: float = 0.0
    accents: float = 0.0
    rises: float = 0.0
    ends: float = 0.0

    @classmethod
    def drawn(cls, random: np.random.Generator) -> "Habits":
        """Habits as speakers have them, more or less."""
        rises = random.normal(0, 0.18) if random.random() < 0.6 else 0.0
        return cls(random.uniform(0, 0.09), random.uniform(0, 0.7), rises, random.uniform(0, 0.6))


@dataclass(frozen=True, slots=True)
class Said:
    """Words as first said, taken apart by WORLD (a row each `STEP_MS`), and their times, None where not spoken."""

    f0_hz: FloatArray
    spectrum: FloatArray
    noise: FloatArray
    words: tuple[tuple[float, float] | None, ...]

    @property
    def times_s(self) -> FloatArray:
        return np.arange(len(self.f0_hz)) * FRAME_S


@dataclass(slots=True)
class _Plan:
    """What becomes of each frame, as it is drawn up cue by cue."""

    shape: FloatArray
    gain_db: FloatArray
    length: FloatArray


def main() -> None:
    """Speaks what the options ask for."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("deliveries", type=Path)
    parser.add_argument("out", type=Path)
    parser.add_argument("--takes", type=int, default=1, help="voices a line")
    parser.add_argument("--first-take", type=int, default=0)
    parser.add_argument("--part", default="0/1", help="of the lines, the part that this process speaks")
    options = parser.parse_args()
    part, parts = map(int, options.part.split("/"))
    options.out.mkdir(parents=True, exist_ok=True)
    lines = [json.loads(line) for line in options.deliveries.read_text().splitlines()]
    bases = [list(group) for _, group in groupby(lines, key=lambda line: line["base"])]
    takes = range(options.first_take, options.first_take + options.takes)
    with (
        Aligner(ROOT / "models", ROOT / "lexicon" / "en") as aligner,
        (options.out / f"index-{takes.start}-{part}.jsonl").open("a") as index,
    ):
        for take in takes:
            for place in range(part, len(bases), parts):
                voice = VOICES[(place + 2 * take) % len(VOICES)]
                for entry in speak(bases[place], voice, options.out, aligner, with_habits=take > 0):
                    print(json.dumps(entry), file=index, flush=True)


def speak(
    deliveries: Iterable[dict[str, Any]], voice: str, out: Path, aligner: Aligner, *, with_habits: bool
) -> Iterator[dict[str, Any]]:
    """Speaks deliveries of one line with one voice; their entries of the index."""
    wanted = [each for each in deliveries if not (out / f"{each['id']}.{voice}.flac").exists()]
    said = say(" ".join(word.split(":", 1)[1] for word in wanted[0]["words"]), voice, aligner) if wanted else None
    if said is None:
        return
    for each in wanted:
        random = np.random.default_rng(zlib.crc32(f"{each['id']} {voice}".encode()))
        degree = Degree.drawn(random)
        samples, words = deliver(said, each, (degree, Habits.drawn(random) if with_habits else Habits()), random)
        path = f"{each['id']}.{voice}.flac"
        soundfile.write(out / path, samples, SAMPLE_RATE_HZ, subtype="PCM_16")
        entry = {key: each[key] for key in ("id", "base", "focus", "tone", "loudness")}
        yield entry | {"voice": voice, "path": path, "degree": degree.pitch, "words": words}


def say(text: str, voice: str, aligner: Aligner) -> Said | None:
    """The text as the voice says it by itself; None if the aligner cannot find it there."""
    return take_apart(said_plainly(text, voice), text, aligner)


def said_plainly(text: str, voice: str) -> FloatArray:
    """The samples of the text as the voice says it by itself, at `SAMPLE_RATE_HZ`."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "said.wav"
        flite = ["flite", "-voice", voice, "-t", text, "-o", str(path)]
        espeak = ["espeak-ng", "-v", voice, "-s", "160", "-w", str(path), text]
        subprocess.run(flite if voice in FLITE else espeak, check=True, stdout=subprocess.DEVNULL)
        samples, rate_hz = soundfile.read(path)
    resampled: FloatArray = soxr.resample(samples, rate_hz, SAMPLE_RATE_HZ)
    return resampled


def take_apart(samples: FloatArray, text: str, aligner: Aligner) -> Said | None:
    """A recording of a text, at `SAMPLE_RATE_HZ`, taken apart; None if the aligner cannot find the text there."""
    silence = np.zeros(SAMPLE_RATE_HZ // 4)
    samples = np.concatenate([silence, samples * 0.05 / np.sqrt(np.mean(samples**2)), silence])
    try:
        words, _ = aligner.align(Audio(samples), read_transcript(text))
    except UnderstudyError:
        return None
    times = tuple((word.interval.start_s, word.interval.end_s) if word.interval else None for word in words)
    f0_hz, at_s = pyworld.dio(samples, SAMPLE_RATE_HZ, f0_floor=60, f0_ceil=400, frame_period=STEP_MS)
    f0_hz = pyworld.stonemask(samples, f0_hz, at_s, SAMPLE_RATE_HZ)
    spectrum = pyworld.cheaptrick(samples, f0_hz, at_s, SAMPLE_RATE_HZ)
    return Said(f0_hz, spectrum, pyworld.d4c(samples, f0_hz, at_s, SAMPLE_RATE_HZ), times)


def deliver(
    said: Said, delivery: dict[str, Any], manner: tuple[Degree, Habits], random: np.random.Generator
) -> tuple[FloatArray, list[list[float] | None]]:
    """The samples of the delivery, and the times of its words."""
    tone, loudness = TONES[delivery["tone"]], delivery["loudness"]
    voiced = said.f0_hz > 0
    middle_hz = np.exp(np.mean(np.log(said.f0_hz[voiced]))) if voiced.any() else 100.0
    plan = _planned(said, middle_hz, tone, loudness)
    _follow_habits(plan, said, delivery["focus"], manner[1], random)
    _mark_focus(plan, said, delivery["focus"], manner[0], tone.spread)
    at = np.arange(len(voiced)) * FRAME_S
    tremor = tone.tremor * np.sin(2 * np.pi * 6 * at + random.uniform(0, 6))
    f0_hz = np.where(voiced, middle_hz * tone.pitch * np.exp(plan.shape + tremor), 0)
    spectrum, noise = _voice(said, plan, tone, loudness)
    nearest, ends_s = _stretched(plan.length)
    parts = [np.ascontiguousarray(part[nearest]) for part in (f0_hz, spectrum, noise)]
    samples = pyworld.synthesize(*parts, SAMPLE_RATE_HZ, STEP_MS)
    samples += random.normal(0, 10 ** random.uniform(-5, -3.3), len(samples))
    words = [None if word is None else [round(float(np.interp(t, at, ends_s)), 3) for t in word] for word in said.words]
    return np.clip(samples, -0.99, 0.99), words


def _planned(said: Said, middle_hz: float, tone: Tone, loudness: float) -> _Plan:
    """The line in its tone, without a focus."""
    voiced = said.f0_hz > 0
    shape = np.where(voiced, np.log(np.maximum(said.f0_hz, 1) / middle_hz), 0) * tone.spread
    frames = len(voiced)
    return _Plan(shape, np.full(frames, tone.level_db + 5.0 * loudness), np.full(frames, 1 / tone.tempo))


def _follow_habits(plan: _Plan, said: Said, focus: Iterable[int], habits: Habits, random: np.random.Generator) -> None:
    """Declination over the line, accents on other words, rises (or falls) and lengthening before pauses."""
    at = said.times_s
    plan.shape -= habits.declination * (at - at.mean())
    starts_s = [word[0] for word in said.words if word] + [np.inf]
    for place, word in enumerate(said.words):
        if word is None:
            continue
        inside = (at >= word[0]) & (at < word[1])
        if place not in focus and random.random() < 0.4:
            bump = np.sin(np.pi * np.clip((at - word[0]) / (word[1] - word[0]), 0, 1)) * inside
            size = habits.accents * random.uniform(0.1, 0.8)
            plan.shape += 0.3 * size * bump
            plan.gain_db += 3.5 * habits.accents * random.uniform(0.0, 0.8) * bump
            plan.length[inside] *= 1.3 ** (habits.accents * random.uniform(0.0, 0.8))
        if min(start_s for start_s in starts_s if start_s > word[0]) - word[1] > 0.05:
            last = (at >= word[1] - 0.25) & (at < word[1])
            plan.shape += habits.rises * last * (at - word[1] + 0.25) / 0.25
            plan.length[last] *= 1 + habits.ends


def _mark_focus(plan: _Plan, said: Said, focus: Iterable[int], degree: Degree, spread: float) -> None:
    """Puts the focus on its words and takes it from what is around them."""
    at, last_s = said.times_s, 0.0
    found = [word for place in focus if (word := said.words[place]) is not None]
    for start_s, end_s in found:
        before, inside = (at < start_s) & (at >= last_s), (at >= start_s) & (at < end_s)
        bump = np.sin(np.pi * np.clip((at - start_s) / (end_s - start_s), 0, 1) ** degree.peak) * inside
        plan.shape += 0.38 * degree.pitch * max(1.0, spread) * bump - 0.04 * degree.before * before
        plan.gain_db += 4.5 * degree.level * bump**0.5 - 1.5 * degree.before * before
        plan.length[inside] *= 1.4**degree.length
        _pause(plan, at, start_s, degree.pause_s)
        last_s = end_s
    after = (at >= last_s) & bool(found)
    kept = 1 - 0.55 * min(degree.after, 1.2)
    plan.shape = np.where(after, plan.shape * kept - 0.12 * degree.after, plan.shape)
    plan.gain_db = plan.gain_db - 4 * degree.after * after


def _pause(plan: _Plan, at: FloatArray, time_s: float, pause_s: float) -> None:
    """Stretches the two frames at `time_s` into a pause."""
    if pause_s:
        here = np.abs(at - time_s) < FRAME_S
        plan.length[here] += pause_s / FRAME_S / max(int(here.sum()), 1)
        plan.gain_db[here] -= 30


def _voice(said: Said, plan: _Plan, tone: Tone, loudness: float) -> tuple[FloatArray, FloatArray]:
    """The spectrum and its share of noise, in the tone."""
    bins_hz = np.linspace(0, SAMPLE_RATE_HZ / 2, said.spectrum.shape[1])
    tilt_db = tone.tilt_db + 4 * loudness
    slope = tilt_db * np.clip(np.log2(np.maximum(bins_hz, 50) / 500) / 3, -1, 1)
    spectrum = said.spectrum * 10 ** ((plan.gain_db[:, None] + slope[None]) / 10)
    breath = tone.breath * (bins_hz / (SAMPLE_RATE_HZ / 2)) ** 0.5
    return spectrum, np.clip(said.noise + breath[None], 0, 1)


def _stretched(length: FloatArray) -> tuple[NDArray[np.int_], FloatArray]:
    """The frame heard at each `STEP_MS`, and the time at which each frame is now, in seconds."""
    smooth = np.convolve(length, np.ones(5) / 5, "same")
    middles = np.cumsum(smooth) - smooth / 2
    places = np.interp(np.arange(0, smooth.sum(), 1.0), middles, np.arange(len(length)))
    return np.round(places).astype(int), middles * FRAME_S


if __name__ == "__main__":
    main()
