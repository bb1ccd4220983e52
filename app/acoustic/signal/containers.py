"""Identifies audio files by their first bytes and checks that they are complete, before decoding.

libsndfile reads some thirty formats, accepts a truncated WAV as a shorter one, and fails obscurely on a truncated Ogg;
so container and completeness are checked here.
"""

import struct
from enum import StrEnum

from ...errors import UndecodableError, UnsupportedFormatError
from ...model import Notice

_UNSTATED_WAV_BYTES = 0xFFFFFFFF
_WAV_HEADER_BYTES = 12
_CHUNK_HEADER_BYTES = 8
_FLAC_TOTAL = slice(21, 26)
_FLAC_TOTAL_BITS = 36
_OGG_PAGE_HEADER_BYTES = 27
_OGG_LAST_PAGE = 0x04


class Container(StrEnum):
    """The supported file formats."""

    WAV = "WAV"
    FLAC = "FLAC"
    OGG = "OGG"


def container_of(content: bytes) -> Container:
    """The container according to the first bytes. Raises UnsupportedFormatError for any other."""
    if content.startswith(b"RIFF") and content[8:12] == b"WAVE":
        return Container.WAV
    if content.startswith(b"fLaC"):
        return Container.FLAC
    if content.startswith(b"OggS"):
        return Container.OGG
    raise UnsupportedFormatError(
        "audio_format_unsupported",
        f"the audio is none of WAV, FLAC and OGG (its first bytes are {content[:8]!r}); send one of these",
        field="audio",
    )


def check_complete(content: bytes, container: Container) -> tuple[Notice, ...]:
    """Raises UndecodableError if the file ends before the end that it states, as far as its bytes show.

    Truncated FLAC is detected only on decoding. The notice says that a file states no length.
    """
    if container is Container.WAV:
        return _check_wav(content)
    if container is Container.FLAC:
        _check_flac(content)
    else:
        _check_ogg(content)
    return ()


def truncated(what: str) -> UndecodableError:
    """The error for an incomplete file; `what` says which part is missing."""
    return UndecodableError("audio_truncated", f"the audio is not whole: {what}; send the complete file", field="audio")


def _check_wav(content: bytes) -> tuple[Notice, ...]:
    """The data chunk must lie within the file, unless its size is all ones, as written to pipes."""
    position = _WAV_HEADER_BYTES
    while position + _CHUNK_HEADER_BYTES <= len(content):
        name, size = struct.unpack_from("<4sI", content, position)
        position += _CHUNK_HEADER_BYTES
        if name == b"data":
            return _check_wav_data(size, len(content) - position)
        position += size + size % 2
    raise truncated("the WAV file ends before its data chunk")


def _check_wav_data(promised_bytes: int, present_bytes: int) -> tuple[Notice, ...]:
    if promised_bytes == _UNSTATED_WAV_BYTES:
        return (Notice("audio_length_unstated", "the WAV header states no length; the audio is taken to be whole"),)
    if promised_bytes > present_bytes:
        raise truncated(f"the WAV header promises {promised_bytes} bytes of sound and {present_bytes} are there")
    return ()


def _check_flac(content: bytes) -> None:
    """The number of samples must be stated: libsndfile cannot find the end without it."""
    total = int.from_bytes(content[_FLAC_TOTAL], "big") & ((1 << _FLAC_TOTAL_BITS) - 1)
    if total == 0:
        raise UndecodableError(
            "audio_length_unstated",
            "the FLAC header states no length, as when it was written to a pipe; write it to a file instead",
            field="audio",
        )


def _check_ogg(content: bytes) -> None:
    """The last page must be complete and marked as the last of the stream."""
    start = content.rfind(b"OggS")
    header = content[start : start + _OGG_PAGE_HEADER_BYTES]
    if len(header) < _OGG_PAGE_HEADER_BYTES:
        raise truncated("the OGG file ends within a page")
    body = start + _OGG_PAGE_HEADER_BYTES
    segments = content[body : body + header[-1]]
    if len(segments) < header[-1] or body + len(segments) + sum(segments) > len(content):
        raise truncated("the OGG file ends within a page")
    if not header[5] & _OGG_LAST_PAGE:
        raise truncated("the OGG file has no last page")
