"""Answers lines of `{"id", "text"}` with lines of functions: `understudy functions` without `--text`.

Every line gets one line of output, in order and at once; a wrong one gets `{"id", "error": {"code", "message"}}`, and
the others are still answered. Lines that have already arrived are parsed together, which is faster; no line waits for
one that has not.

`rules unused` reads its corpus by the same lines: an utterance each, as plain text or JSON; empty lines are skipped.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from io import BufferedIOBase
from pathlib import Path

from ...errors import InputError
from ...library.language import find_functions_in_all
from ...model import Word
from ...models import LanguageModels
from ...schemas.requests import line_id, read_object, read_request
from ...schemas.responses import FunctionsResponse, MistakeResponse
from ...text.transcript import read_transcript
from ..files import write_standard

MOST_TOGETHER = 32
READ_BYTES = 65_536


def answer_lines(language: LanguageModels, stream: BufferedIOBase) -> None:
    """Raises InputError `lines_wrong` after the last line when some were wrong."""
    wrong: list[int] = []
    before = 0
    for lines in waiting_lines(stream):
        spoken = [_read(line) if line.strip() else None for line in lines]
        analyses = find_functions_in_all(language, [asked.words for asked in spoken if isinstance(asked, _TextLine)])
        for number, asked in enumerate(spoken, start=before + 1):
            if isinstance(asked, MistakeResponse):
                wrong.append(number)
                write_standard(asked.to_json() + b"\n")
            elif asked is not None:
                write_standard(FunctionsResponse.of(next(analyses), asked.id).to_json() + b"\n")
        before += len(lines)
    if wrong:
        raise InputError("lines_wrong", f"standard input: {len(wrong)} lines are wrong, the first is line {wrong[0]}")


def waiting_lines(stream: BufferedIOBase) -> Iterator[Sequence[bytes]]:
    """The lines of a stream, in groups of those that can be read without waiting for more, at most `MOST_TOGETHER`
    each."""
    begun: list[bytes] = []
    while chunk := stream.read1(READ_BYTES):
        begun.append(chunk)
        if b"\n" in chunk:
            *whole, rest = b"".join(begun).split(b"\n")
            begun = [rest]
            for start in range(0, len(whole), MOST_TOGETHER):
                yield whole[start : start + MOST_TOGETHER]
    yield [b"".join(begun)]


@dataclass(frozen=True, slots=True)
class _TextLine:
    id: str | int | None
    words: tuple[Word, ...]


def _read(line: bytes) -> _TextLine | MistakeResponse:
    fields: dict[str, object] = {}
    try:
        fields = read_object(line, "line")
        question = read_request(fields)
        return _TextLine(question.id, read_transcript(question.text))
    except InputError as error:
        return MistakeResponse.of(error, line_id(fields))


def read_corpus(name: str) -> Iterator[str]:
    """The texts of a file. Raises InputError `file_unreadable`, and for an unusable line an error that names it."""
    try:
        with Path(name).open("rb") as lines:
            for number, line in enumerate(lines, start=1):
                if line.strip():
                    yield _text(line, f"{name}, line {number}")
    except (OSError, ValueError) as error:
        raise InputError("file_unreadable", f"{name}: cannot be read: {error}", field="corpus") from None


def _text(line: bytes, place: str) -> str:
    try:
        is_json = line.lstrip().startswith(b"{")
        text = read_request(read_object(line, "line")).text if is_json else line.decode()
        read_transcript(text)
    except InputError as error:
        raise InputError(error.code, f"{place}: {error.message}", field="corpus") from None
    except UnicodeDecodeError:
        raise InputError("text_not_utf8", f"{place}: not UTF-8; save the corpus as UTF-8", field="corpus") from None
    return text.strip()
