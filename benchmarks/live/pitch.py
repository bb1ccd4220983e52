"""Agreement of f0 tracked in a live signal with f0 of the recording.

    python -m benchmarks.live.pitch [--speech FOLDER] [--each N]

N recordings each of TIMIT, RAVDESS, EmoDB, FDA and LibriVox, drawn by chance, in chunks of .03 s. Of the frames that
both call voiced, the share within 2 %; of all frames, those voiced alike; processor time over length; how late frames
came.
"""

import argparse
import random
import time
from pathlib import Path

import numpy as np

from understudy.acoustic.pitch.streaming import StreamingPitch
from understudy.acoustic.pitch.tracking import track_f0
from understudy.acoustic.signal.decoding import decode
from understudy.acoustic.stage import audio_limits
from understudy.model import FRAME_SHIFT_S, SAMPLE_RATE_HZ, FloatArray
from understudy.settings import Settings

CORPORA = ("timit/*", "ravdess", "emodb", "fda", "lines")
CHUNK = round(0.03 * SAMPLE_RATE_HZ)
NEAR = 0.02


def streamed(samples: FloatArray) -> tuple[FloatArray, float]:
    """f0 as it comes, and the longest that a frame was waited for, in seconds."""
    live, parts, latest_s, count = StreamingPitch(), list[FloatArray](), 0.0, 0
    for first in range(0, len(samples), CHUNK):
        parts.append(live.hear(samples[first : first + CHUNK]))
        count += len(parts[-1])
        latest_s = max(latest_s, min(first + CHUNK, len(samples)) / SAMPLE_RATE_HZ - count * FRAME_SHIFT_S)
    return np.concatenate([*parts, live.finish()]), latest_s


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speech", type=Path, default=Path("../shared/data/speech"))
    parser.add_argument("--each", type=int, default=12)
    arguments = parser.parse_args()
    for corpus in CORPORA:
        paths = sorted(arguments.speech.glob(f"{corpus}/*.flac"))
        both_voiced = near = alike = frames = 0
        spent_s = latest_s = 0.0
        for path in random.Random(0).sample(paths, min(arguments.each, len(paths))):
            audio, _ = decode(path.read_bytes(), audio_limits(Settings()))
            began_s = time.process_time()
            live_hz, late_s = streamed(audio.samples)
            spent_s, latest_s = spent_s + time.process_time() - began_s, max(latest_s, late_s)
            whole_hz = track_f0(audio)
            both = (live_hz > 0) & (whole_hz > 0)
            both_voiced, frames = both_voiced + int(both.sum()), frames + len(both)
            near += int((np.abs(live_hz[both] / whole_hz[both] - 1) < NEAR).sum())
            alike += int(((live_hz > 0) == (whole_hz > 0)).sum())
        print(
            f"{corpus:8s} {100 * near / both_voiced:.1f} % of {both_voiced} voiced frames within 2 %, "
            f"{100 * alike / frames:.1f} % voiced alike, {spent_s / (frames * FRAME_SHIFT_S):.4f} × real time, "
            f"latest {latest_s:.3f} s",
            flush=True,
        )


if __name__ == "__main__":
    main()
