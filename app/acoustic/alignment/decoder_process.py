"""Our end of the process in which pocketsphinx works (`decoder_worker`): starts it, asks it, survives its death."""

import json
import subprocess
import sys
import threading
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Self

from ...errors import ServiceError

WORKER = Path(__file__).with_name("decoder_worker.py")
TIME_LIMIT_S = 120.0

Pronunciations = Sequence[str]
"""The ways in which a word may be said, each phones between spaces."""


@dataclass(frozen=True, slots=True)
class DecodedPhone:
    """A phone where the decoder heard it, in its frames; `score` sums the log likelihoods of its frames."""

    label: str
    first_frame: int
    frames: int
    score: int

    def later(self, frames: int) -> Self:
        """The same so many frames later."""
        return replace(self, first_frame=self.first_frame + frames)


@dataclass(frozen=True, slots=True)
class Decoded:
    """The phones of each word, and fillers ("um") that no word stands for."""

    words: list[list[DecodedPhone]]
    fillers: list[DecodedPhone]

    def later(self, frames: int) -> Self:
        """The same so many frames later."""
        words = [[phone.later(frames) for phone in word] for word in self.words]
        return replace(self, words=words, fillers=[filler.later(frames) for filler in self.fillers])


@dataclass(frozen=True, slots=True)
class Span:
    """Where a word or a filler is, in the decoder's frames."""

    is_word: bool
    first_frame: int
    frames: int

    @property
    def end_frame(self) -> int:
        return self.first_frame + self.frames


class DecoderProcess:
    """One worker, started when first needed and again after a crash; threads take turns.

    The worker ends when its standard input does, so it never outlives us. It has a session of its own: Ctrl-C at the
    terminal is ours to handle.
    """

    def __init__(self, worker: Path = WORKER, *, time_limit_s: float = TIME_LIMIT_S) -> None:
        self._command = [sys.executable, "-P", str(worker)]
        self._time_limit_s = time_limit_s
        self._turn = threading.Lock()
        self._process: subprocess.Popen[bytes] | None = None

    def start(self) -> None:
        """Starts the worker, if it does not run yet."""
        with self._turn:
            self._running()

    def align(self, audio: bytes, words: Sequence[Pronunciations]) -> Decoded | None:
        """The phones of each word; None when the decoder finds no path.

        `audio` is 16-bit mono at 16 kHz. Raises ServiceError `aligner_crashed` when the worker dies over it or takes
        longer than the time limit; the next call has a new one.
        """
        answer = self._answer(audio, words, more=False)
        if answer["words"] is None:
            return None
        decoded = [[DecodedPhone(*phone) for phone in word] for word in answer["words"]]
        return Decoded(decoded, [DecodedPhone(*filler) for filler in answer["fillers"]])

    def find(self, audio: bytes, words: Sequence[Pronunciations]) -> list[Span]:
        """Roughly where the first of the words are, as many as `audio` holds, and the fillers between them: it is the
        first stretch of a longer one.

        Raises what `align` does.
        """
        return [Span(*span) for span in self._answer(audio, words, more=True)["spans"]]

    def _answer(self, audio: bytes, words: Sequence[Pronunciations], *, more: bool) -> dict[str, Any]:
        request = json.dumps({"words": words, "bytes": len(audio), "more": more}).encode() + b"\n" + audio
        with self._turn:
            answer: dict[str, Any] = json.loads(self._asked(self._running(), request))
        return answer

    def close(self) -> None:
        """Ends the worker. A later `align` starts another."""
        with self._turn:
            if self._process is not None:
                self._end(self._process)

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
        """Closes the pipes, waits, and forgets the process."""
        self._process = None
        for pipe in (process.stdin, process.stdout):
            if pipe is not None:
                with suppress(BrokenPipeError):
                    pipe.close()
        process.wait()
