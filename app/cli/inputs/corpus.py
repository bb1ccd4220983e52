"""Reads a corpus: one utterance a line, as plain text or as JSON `{"id", "text"}`; empty lines are skipped."""

from collections.abc import Iterator
from pathlib import Path

from ...errors import InputError
from ...schemas.requests import read_object, read_request
from ...transcript import read_transcript


def read_corpus(name: str, *, max_characters: int) -> Iterator[str]:
    """The texts of a file. Raises InputError `file_unreadable`, and for an unusable line an error that names it."""
    try:
        with Path(name).open("rb") as lines:
            for number, line in enumerate(lines, start=1):
                if line.strip():
                    yield _text(line, f"{name}, line {number}", max_characters=max_characters)
    except (OSError, ValueError) as error:
        raise InputError("file_unreadable", f"{name}: cannot be read: {error}", field="corpus") from None


def _text(line: bytes, place: str, *, max_characters: int) -> str:
    try:
        is_json = line.lstrip().startswith(b"{")
        text = read_request(read_object(line, "line")).text if is_json else line.decode()
        read_transcript(text, max_characters=max_characters)
    except InputError as error:
        raise InputError(error.code, f"{place}: {error.message}", field="corpus") from None
    except UnicodeDecodeError:
        raise InputError("text_not_utf8", f"{place}: not UTF-8; save the corpus as UTF-8", field="corpus") from None
    return text.strip()
