"""Functions that the readers of scripts share: decoding a text file of any encoding (by its byte order mark, else as
UTF-8, else as charset-normalizer judges), ids of lines, names before words, removal of what is not spoken."""

import codecs
import re
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass, replace

from charset_normalizer import from_bytes

from ...errors import UndecodableError
from ..model import ScriptLine

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
        raise UndecodableError("text_not_utf8", f"{name}: unknown encoding; save it as UTF-8", field="script")
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


_BEFORE_WORDS = re.compile(r"(?P<name>[A-Z][\w .'’&-]{0,40}?)\s*:\s+(?P<words>\S.*)", re.DOTALL)
_NOT_SPOKEN = re.compile(r"\[[^\]]*\]|\([^)]*\)|[♪♫#]+")
_TAGS = re.compile(r"<[^>]*>|\{\\[^}]*\}")
_CONTINUED = re.compile(r"\s*\(\s*(?:cont(?:['’]?d|inued)|more)\.?\s*\)\s*", re.IGNORECASE)
_EXTENSION = re.compile(r"\s*\(([^)]*)\)\s*")

PLACES_OF_NUMBER = 3


def without_tags(text: str) -> str:
    """The text without subtitle tags."""
    return _TAGS.sub("", text)


def spoken(text: str) -> str:
    """The text without descriptions of sounds ("[door slams]"), in one line."""
    return " ".join(_NOT_SPOKEN.sub(" ", text).split())


def with_name(text: str) -> tuple[str, str]:
    """A name before the words ("ANNA: No.") and the words; an empty name where there is none."""
    match = _BEFORE_WORDS.fullmatch(text.strip())
    return (match["name"].strip(), match["words"].strip()) if match else ("", text.strip())


def cue_name(cue: str) -> tuple[str, str]:
    """A character's name without its extensions in a screenplay, and the extensions ("V.O.") except "continued"."""
    plain = _CONTINUED.sub(" ", cue).strip()
    return _EXTENSION.sub(" ", plain).strip(), "; ".join(_EXTENSION.findall(plain))


def numbered(lines: Iterable[ScriptLine]) -> tuple[ScriptLine, ...]:
    """The lines, those without an id numbered by scene and place in the scene (`scene2_014`)."""
    count: Counter[str] = Counter()
    named = []
    for line in lines:
        count[line.scene] += 1
        name = line.id or f"scene{line.scene}_{count[line.scene]:0{PLACES_OF_NUMBER}}"
        named.append(replace(line, id=name))
    return tuple(named)
