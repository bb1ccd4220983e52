"""The client of the process that runs pocketsphinx (`decoder_worker`): starts it, sends requests, handles crashes.

The decoder hears 16-bit samples, normalized and padded with faint noise (`pcm`), and counts in frames.
"""

import json
import subprocess
import sys
import threading
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Self

import numpy as np

from ...errors import ServiceError
from ...model import SAMPLE_RATE_HZ, FloatArray

FRAMES_PER_S = 100
FRAME_SAMPLES = SAMPLE_RATE_HZ // FRAMES_PER_S
PADDING_FRAMES = FRAMES_PER_S // 5

PEAK = 0.9
NOISE_AMPLITUDE = 3e-4
NOISE_SEED = 20_200

WORKER = Path(__file__).with_name("decoder_worker.py")
TIME_LIMIT_S = 120.0

Pronunciations = Sequence[str]
"""The alternative pronunciations of a word, each as phones separated by spaces."""


def pcm(samples: FloatArray) -> bytes:
    """The signal with `PADDING_FRAMES` of noise before and after it; deterministic."""
    noise = np.random.default_rng(NOISE_SEED).standard_normal(2 * PADDING_FRAMES * FRAME_SAMPLES) * NOISE_AMPLITUDE
    before, after = np.split(noise, 2)
    peak = float(np.abs(samples).max(initial=0.0)) or 1.0
    padded = np.concatenate([before, samples * (PEAK / peak), after])
    return (padded * 32767).round().astype("<i2").tobytes()


@dataclass(frozen=True, slots=True)
class DecodedPhone:
    """A phone with its time in decoder frames; `score` sums the log likelihoods of its frames."""

    label: str
    first_frame: int
    frames: int
    score: int

    def delayed(self, frames: int) -> Self:
        """The same phone, this many frames later."""
        return replace(self, first_frame=self.first_frame + frames)


@dataclass(frozen=True, slots=True)
class DecodedLine:
    """The phones of each word, and fillers ("um") that are not in the transcript."""

    words: list[list[DecodedPhone]]
    fillers: list[DecodedPhone]

    def delayed(self, frames: int) -> Self:
        """The same, this many frames later."""
        words = [[phone.delayed(frames) for phone in word] for word in self.words]
        return replace(self, words=words, fillers=[filler.delayed(frames) for filler in self.fillers])


@dataclass(frozen=True, slots=True)
class FrameSpan:
    """The time of a word or a filler in decoder frames."""

    is_word: bool
    first_frame: int
    frames: int

    @property
    def end_frame(self) -> int:
        return self.first_frame + self.frames


class DecoderProcess:
    """A worker process, started on demand and again after a crash; threads take turns.

    The worker ends when its standard input closes, so it never outlives its parent. It has a session of its own, so
    that Ctrl-C at the terminal reaches only the parent.
    """

    def __init__(self, worker: Path = WORKER, *, time_limit_s: float = TIME_LIMIT_S) -> None:
        self._command = [sys.executable, "-P", str(worker)]
        self._time_limit_s = time_limit_s
        self._turn = threading.Lock()
        self._process: subprocess.Popen[bytes] | None = None

    def start(self) -> None:
        """Start the worker if it is not running."""
        with self._turn:
            self._running()

    def align(self, audio: bytes, words: Sequence[Pronunciations]) -> DecodedLine | None:
        """The phones of each word; None if the decoder finds no path.

        `audio` is 16-bit mono at 16 kHz. Raises ServiceError `aligner_crashed` if the worker dies or exceeds the time
        limit; the next call starts a new one.
        """
        answer = self._answer(audio, words, more=False)
        if answer["words"] is None:
            return None
        decoded = [[DecodedPhone(*phone) for phone in word] for word in answer["words"]]
        return DecodedLine(decoded, [DecodedPhone(*filler) for filler in answer["fillers"]])

    def find(self, audio: bytes, words: Sequence[Pronunciations]) -> list[FrameSpan]:
        """Approximate times of those words that `audio`, the first stretch of a longer recording, contains, and of the
        fillers between them.

        Raises as `align` does.
        """
        return [FrameSpan(*span) for span in self._answer(audio, words, more=True)["spans"]]

    def _answer(self, audio: bytes, words: Sequence[Pronunciations], *, more: bool) -> dict[str, Any]:
        request = json.dumps({"words": words, "bytes": len(audio), "more": more}).encode() + b"\n" + audio
        with self._turn:
            answer: dict[str, Any] = json.loads(self._asked(self._running(), request))
        return answer

    def close(self) -> None:
        """Stop the worker. A later `align` starts a new one."""
        with self._turn:
            if self._process is not None:
                self._end(self._process)

    def interrupt(self) -> None:
        """Kill the worker, whoever waits for it. A later `align` starts a new one."""
        process = self._process
        if process is not None:
            process.kill()

    def _running(self) -> subprocess.Popen[bytes]:
        if self._process is not None and self._process.poll() is not None:
            self._end(self._process)
        if self._process is None:
            self._process = subprocess.Popen(
                self._command,
                stdin=subprocess.PIPE,
                stdout=subprocess.PIPE,
                stderr=subprocess.DEVNULL,
                start_new_session=True,
            )
        return self._process

    def _asked(self, process: subprocess.Popen[bytes], request: bytes) -> bytes:
        assert process.stdin is not None
        assert process.stdout is not None
        timer = threading.Timer(self._time_limit_s, process.kill)
        timer.start()
        answer = b""
        try:
            with suppress(BrokenPipeError):
                process.stdin.write(request)
                process.stdin.flush()
                answer = process.stdout.readline()
        finally:
            timer.cancel()
            if not answer.endswith(b"\n"):  # dead, or interrupted here: the next request must not read this answer
                process.kill()
                self._end(process)
        if process.returncode is not None:
            raise ServiceError(
                "aligner_crashed",
                f"the aligner's process ended (status {process.returncode}) while it aligned this line; "
                "other lines are not affected",
            )
        return answer

    def _end(self, process: subprocess.Popen[bytes]) -> None:
        """Close the pipes, wait, and forget the process."""
        self._process = None
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                with suppress(BrokenPipeError):
                    pipe.close()
        process.wait()
