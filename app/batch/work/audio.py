"""The recording of a line: a file or its content, whole or an interval of it.

The interval is cut out first, so the whole recording may be longer than a line is allowed to be.
"""

import io
from dataclasses import dataclass, field
from pathlib import Path

import soundfile

from ...errors import InputError, UndecodableError
from ...model import Interval
from ..compressed import converted, is_compressed


@dataclass(frozen=True, slots=True)
class AudioSource:
    """A recording: its path, its content if the worker cannot read the file, and the interval that is meant."""

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
