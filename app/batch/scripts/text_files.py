"""Decodes a text file of any encoding: by its byte order mark, else as UTF-8, else as charset-normalizer judges.

The last is a guess, so it is reported.
"""

import codecs
from dataclasses import dataclass

from charset_normalizer import from_bytes

from ...errors import UndecodableError

_MARKS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
MOST_BEYOND_ASCII = 1 / 4
"""The largest share of non-ASCII bytes in text taken for Western: with so few of them language statistics mislead."""

WESTERN = "cp1252"
"""What Windows and older spreadsheets write in the countries whose languages we perform."""


@dataclass(frozen=True, slots=True)
class TextFile:
    """A file's text; `remark` says what was guessed, empty if nothing was."""

    text: str
    remark: str = ""


def decode_text(content: bytes, name: str) -> TextFile:
    """The text in `content`; raises UndecodableError `text_not_utf8` when it is in no known encoding."""
    for mark, encoding in _MARKS:
        if content.startswith(mark):
            return TextFile(_decoded(content, encoding, name))
    try:
        return TextFile(content.decode("utf-8"))
    except UnicodeDecodeError:
        guessed = _guessed(content)
    if guessed is None:
        raise UndecodableError("text_not_utf8", f"{name}: in no encoding we know; save it as UTF-8", field="script")
    return TextFile(_decoded(content, guessed, name), f"{name} is not UTF-8; read as {guessed}")


def _guessed(content: bytes) -> str | None:
    """The encoding of text without a mark: Western for text with few non-ASCII bytes, else by statistics."""
    beyond = sum(byte > 0x7F for byte in content)
    if b"\0" not in content and beyond <= MOST_BEYOND_ASCII * len(content) and _is_decodable(content, WESTERN):
        return WESTERN
    best = from_bytes(content).best()
    return None if best is None else best.encoding


def _is_decodable(content: bytes, encoding: str) -> bool:
    try:
        content.decode(encoding)
    except UnicodeDecodeError:
        return False
    return True


def _decoded(content: bytes, encoding: str, name: str) -> str:
    try:
        return content.decode(encoding)
    except UnicodeDecodeError as error:
        message = f"{name}: not {encoding} at byte {error.start}; save it as UTF-8"
        raise UndecodableError("text_not_utf8", message, field="script") from None
