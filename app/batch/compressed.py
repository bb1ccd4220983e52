"""Compressed recordings that we do not read ourselves, converted by ffmpeg where it is installed.

Only the file itself is read, whatever it says of others, and only its first sound.
"""

import shutil
import subprocess
from pathlib import Path
from tempfile import TemporaryDirectory

from ..errors import InputError, UndecodableError

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
            told = done.stderr.decode(errors="replace").strip().splitlines() or ["it has no sound"]
            raise UndecodableError("audio_undecodable", f"{path}: ffmpeg: {told[-1]}", field="audio")
        return whole.read_bytes()
