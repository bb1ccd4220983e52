"""The recording of a line: a file or its content, whole or an interval of it, converted by ffmpeg, where it is
installed, if it is compressed in a way that we do not read ourselves.

The interval is cut out first, so the whole recording may be longer than a line is allowed to be. ffmpeg reads only the
file itself, whatever it says of others, and only its first sound.
"""

import io
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory

import soundfile

from ..errors import InputError, UndecodableError
from ..model import Interval

SUFFIXES = frozenset({".mp3", ".m4a", ".aac", ".mp4", ".wma", ".webm", ".aif", ".aiff", ".caf", ".amr"})
"""Opus in an .opus or .ogg file needs no conversion."""

LONGEST_S = 600.0
"""The most time for one recording."""


def is_compressed(path: Path) -> bool:
    """Whether a file, by its name, is to be converted."""
    return path.suffix.lower() in SUFFIXES


def converter() -> str | None:
    """The path of ffmpeg, None where it is not installed."""
    return shutil.which("ffmpeg")


def advice(path: Path) -> str:
    """What to do about a recording that cannot be converted here."""
    return f"{path.name} is there; convert it to .wav or .flac, or install ffmpeg"


def converted(path: Path) -> bytes:
    """The recording as a WAV file. Raises InputError `audio_compressed` without ffmpeg, UndecodableError
    `audio_undecodable`."""
    ffmpeg = converter()
    if ffmpeg is None:
        raise InputError("audio_compressed", advice(path), field="audio")
    with TemporaryDirectory() as folder:
        whole = Path(folder) / "whole.wav"
        given = ["-nostdin", "-v", "error", "-protocol_whitelist", "file", "-i", f"file:{path.absolute()}"]
        command = [ffmpeg, *given, "-map", "0:a:0", "-c:a", "pcm_s16le", "-f", "wav", str(whole)]
        try:
            done = subprocess.run(command, capture_output=True, timeout=LONGEST_S, check=False)
        except (OSError, subprocess.TimeoutExpired) as error:
            raise UndecodableError("audio_undecodable", f"{path}: ffmpeg: {error}", field="audio") from None
        if done.returncode != 0 or not whole.is_file():
            lines = done.stderr.decode(errors="replace").strip().splitlines() or ["it has no sound"]
            raise UndecodableError("audio_undecodable", f"{path}: ffmpeg: {lines[-1]}", field="audio")
        return whole.read_bytes()


@dataclass(frozen=True, slots=True)
class AudioSource:
    """A recording: its path, its content if the worker cannot read the file, and the interval of the line in it."""

    path: Path
    sent: bytes | None = field(default=None, repr=False)
    interval: Interval | None = None

    def content(self) -> bytes:
        """The file's bytes, or those of a WAV file of the interval, or of a compressed recording.

        Raises InputError `file_unreadable`, `cut_outside` and `audio_compressed`, UndecodableError `audio_undecodable`.
        """
        try:
            known = converted(self.path) if self.sent is None and is_compressed(self.path) else self.sent
            if self.interval is not None:
                return _cut(io.BytesIO(known) if known is not None else self.path, self.interval)
            return self.path.read_bytes() if known is None else known
        except OSError as error:
            message = f"{self.path}: cannot be read: {error.strerror}"
            raise InputError("file_unreadable", message, field="audio") from None

    def to_send(self) -> "AudioSource":
        """The same with its content, for a worker on another machine; raises as `content` does."""
        return AudioSource(self.path, self.content())


def _cut(audio: Path | io.BytesIO, interval: Interval) -> bytes:
    """The interval of the recording as a WAV file of the same rate and channels."""
    try:
        with soundfile.SoundFile(audio) as file:
            first, last = (round(time_s * file.samplerate) for time_s in (interval.start_s, interval.end_s))
            if first >= file.frames:
                length_s = file.frames / file.samplerate
                message = f"the line begins at {interval.start_s:.2f} s, the recording ends at {length_s:.2f} s"
                raise InputError("cut_outside", message, field="audio")
            file.seek(first)
            samples, rate = file.read(last - first, dtype="float32", always_2d=True), file.samplerate
    except soundfile.LibsndfileError as error:
        raise UndecodableError("audio_undecodable", f"cannot be read as sound: {error}", field="audio") from None
    content = io.BytesIO()
    soundfile.write(content, samples, rate, format="WAV", subtype="PCM_16")
    return content.getvalue()
