"""What the bytes of an audio file claim to be, and whether they are all there, judged before anything is decoded.

libsndfile reads some thirty formats, takes a WAV that breaks off for a shorter one, and fails obscurely on an Ogg that
does; so the container is named by its first bytes, and its end is looked for, here.
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
    """The file formats that are read."""

    WAV = "WAV"
    FLAC = "FLAC"
    OGG = "OGG"


def recognise(content: bytes) -> Container:
    """The container that the first bytes announce. Raises UnsupportedFormatError for any other."""
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


def check_whole(content: bytes, container: Container) -> tuple[Notice, ...]:
    """Raises UndecodableError when the file breaks off before the end that it announces, as far as bytes show that.

    A FLAC file that breaks off shows only on decoding. The notice says that a file announces no end.
    """
    if container is Container.WAV:
        return _check_wav(content)
    if container is Container.FLAC:
        _check_flac(content)
    else:
        _check_ogg(content)
    return ()


def truncated(what: str) -> UndecodableError:
    """The error for a file of which a part is missing; `what` says which."""
    return UndecodableError("audio_truncated", f"the audio is not whole: {what}; send the complete file", field="audio")


def _check_wav(content: bytes) -> tuple[Notice, ...]:
    """The data chunk must lie within the file; only a size of all ones, which is what a pipe writes, may point past
    its end."""
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
    """The last page must be complete and be marked as the stream's last."""
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
