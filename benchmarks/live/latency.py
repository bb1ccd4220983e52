"""Latency and cost of live gestures.

    python -m benchmarks.live.latency [--speech FOLDER] [--lines N]

N recordings each of TIMIT and LibriVox, drawn by chance, .5 s of silence before each, in chunks of .04 s. Every time is
from the moment in the sound to the end of the chunk after which the service's message is written, with the processor
time that the step took.

- first: from the first voice of a recording to the first message, and to the first that is no shape of the mouth.
- announced: from the moment that a phase of hands, head or brows is announced for to its behaviour.
- stroke: from an accent to the first message of the gesture whose stroke shows it, and to the stroke itself. Accents
  are where strokes begin that the whole recording decides (`VoiceModel.decode`); the gesture is the one told nearest,
  if one was within a second.
- processor time over the length of the sound: events alone, with frames at 30 and at 60, messages written.
"""

import argparse
import random
import time
from collections import defaultdict
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from understudy.acoustic.pitch.streaming import StreamingPitch
from understudy.acoustic.signal.decoding import decode
from understudy.acoustic.signal.spectrum import energy_db
from understudy.acoustic.stage import audio_limits
from understudy.live.ear import Ear
from understudy.live.messages import BehaviorMessage, LiveOptions
from understudy.live.models import LiveModels
from understudy.live.movements import LiveEvents
from understudy.live.session import LiveSession
from understudy.model import SAMPLE_RATE_HZ, Audio, Channel, FloatArray
from understudy.models import Understudy
from understudy.prosody_gestures.semi_markov import FRAME_S
from understudy.schemas.live import to_json
from understudy.settings import Settings

CORPORA = ("timit/*", "lines")
CHUNK = 640
BEFORE_S = 0.5
NEAR_S = 1.0


@dataclass(slots=True)
class Delays:
    """Seconds, by what they are measured of."""

    found: dict[str, list[float]] = field(default_factory=lambda: defaultdict(list))
    accents: int = 0


@dataclass(frozen=True, slots=True)
class Written:
    """A message, and when it was written on the clock of the sound."""

    at_s: float
    told: object


def written(models: LiveModels, samples: FloatArray, frame_rate_hz: int | None) -> Iterator[Written]:
    """All messages of a recording."""
    session = LiveSession(models, LiveOptions(frame_rate_hz=frame_rate_hz))
    for first in range(0, len(samples), CHUNK):
        began_s = time.process_time()
        told = session.hear(samples[first : first + CHUNK])
        for each in told:
            to_json(each)
        spent_s = time.process_time() - began_s
        yield from (Written(session.heard_s + spent_s, each) for each in told)


def measure(models: LiveModels, samples: FloatArray, delays: Delays) -> None:
    f0_hz = StreamingPitch()
    pitch = np.concatenate([f0_hz.hear(samples), f0_hz.finish()])
    voiced = np.flatnonzero(np.convolve(pitch > 0, np.ones(4), "valid") == 4)
    messages = list(written(models, samples, None))
    if len(voiced):
        onset_s = voiced[0] * 0.01
        after = [each for each in messages if each.at_s > onset_s and not _is_blink(each.told)]
        delays.found["first message"].append(min((each.at_s for each in after), default=np.inf) - onset_s)
        body = [each.at_s for each in after if isinstance(each.told, BehaviorMessage)]
        delays.found["first behaviour"].append(min(body, default=np.inf) - onset_s)
    _strokes(models, samples, pitch, messages, delays)


def _is_blink(told: object) -> bool:
    return isinstance(told, BehaviorMessage) and told.behavior.kind is Channel.EYES


def _strokes(
    models: LiveModels, samples: FloatArray, pitch: FloatArray, messages: Sequence[Written], delays: Delays
) -> None:
    first: dict[str, Written] = {}
    last: dict[str, Written] = {}
    for each in messages:
        if isinstance(each.told, BehaviorMessage) and each.told.behavior.kind is Channel.GESTURE:
            first.setdefault(each.told.behavior.id, each)
            last[each.told.behavior.id] = each
    levels = energy_db(Audio(samples))[: len(pitch)]
    path = models.voice.decode(levels, pitch[: len(levels)])["hands"]
    stroke = models.voice.parts[0].model.states.index("stroke")
    accents = [segment.start * FRAME_S for segment in path if segment.state == stroke]
    delays.accents += len(accents)
    for accent_s in accents:
        near = [name for name, each in last.items() if abs(_stroke_s(each) - accent_s) < NEAR_S]
        if near:
            name = min(near, key=lambda name: abs(_stroke_s(last[name]) - accent_s))
            delays.found["accent to its gesture's first message"].append(first[name].at_s - accent_s)
            delays.found["accent to the stroke"].append(_stroke_s(last[name]) - accent_s)


def _stroke_s(each: Written) -> float:
    assert isinstance(each.told, BehaviorMessage)
    return float(each.told.behavior.sync.stroke_start or 0.0)


def announced(models: LiveModels, samples: FloatArray, delays: Delays) -> None:
    """Delays of announcements alone."""

    ear, events = Ear(SAMPLE_RATE_HZ), LiveEvents(models.voice)
    for begin in range(0, len(samples), CHUNK):
        began_s = time.process_time()
        heard_s = min(begin + CHUNK, len(samples)) / SAMPLE_RATE_HZ
        told = events.hear(*ear.contours(samples[begin : begin + CHUNK]), heard_s)
        spent_s = time.process_time() - began_s
        delays.found["announced, all"] += [heard_s + spent_s - each.start_s for each in told]
        strokes = [each for each in told if each.state == "stroke"]
        delays.found["announced, strokes"] += [heard_s + spent_s - each.start_s for each in strokes]


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=Path("../shared/data/speech"))
    parser.add_argument("--lines", type=int, default=20)
    arguments = parser.parse_args()
    recordings = list[FloatArray]()
    for corpus in CORPORA:
        paths = sorted(arguments.speech.glob(f"{corpus}/*.flac"))
        for path in random.Random(0).sample(paths, min(arguments.lines, len(paths))):
            audio, _ = decode(path.read_bytes(), audio_limits(Settings()))
            silence = np.zeros(round(BEFORE_S * SAMPLE_RATE_HZ))
            recordings.append(np.concatenate([silence, audio.samples, silence]))
    with Understudy.load(Settings()) as understudy:
        models, delays = LiveModels.load(understudy), Delays()
        for samples in recordings:
            measure(models, samples, delays)
            announced(models, samples, delays)
        for name, found in delays.found.items():
            median, most = np.percentile(found, [50, 95])
            print(f"{name:40s} median {median:.3f} s, p95 {most:.3f} s, of {len(found)}")
        print(f"accents: {delays.accents}")
        costs(models, recordings)


def costs(models: LiveModels, recordings: Sequence[FloatArray]) -> None:
    total_s = sum(map(len, recordings)) / SAMPLE_RATE_HZ
    for frame_rate_hz in (None, 30, 60):
        began_s = time.process_time()
        for samples in recordings:
            for _ in written(models, samples, frame_rate_hz):
                pass
        spent = (time.process_time() - began_s) / total_s
        print(f"processor time, {f'frames at {frame_rate_hz}' if frame_rate_hz else 'events alone'}: {spent:.4f} ×")


if __name__ == "__main__":
    main()
