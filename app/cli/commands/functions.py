"""`understudy functions`: what words alone do, nothing heard.

Without `--text`, every line of standard input, `{"id", "text"}`, gets one line out, in order and at once; a wrong one
gets `{"id", "error": {"code", "message"}}`, the others are answered all the same, and the exit code is 2.
"""

import argparse
import sys
from collections.abc import Iterable

from app.answers import FunctionsAnswer, MistakeAnswer
from app.cli.files import write_standard
from app.cli.log import Log
from app.errors import InputError
from app.performance import Mind, understand
from app.questions import line_id, read_object, read_question
from app.settings import read_settings


def run(arguments: argparse.Namespace, _log: Log) -> int:
    mind = Mind.load(read_settings())
    if arguments.text is None:
        _answer_lines(mind, sys.stdin.buffer)
    else:
        analysis = understand(mind, arguments.text)
        write_standard(FunctionsAnswer.of(analysis).to_json() + b"\n")
    return 0


def _answer_lines(mind: Mind, lines: Iterable[bytes]) -> None:
    """Raises InputError `lines_wrong` after the last line when some were wrong."""
    wrong: list[int] = []
    for number, line in enumerate(lines, start=1):
        if not line.strip():
            continue
        answer = _answer(mind, line)
        if isinstance(answer, MistakeAnswer):
            wrong.append(number)
        write_standard(answer.to_json() + b"\n")
    if wrong:
        raise InputError("lines_wrong", f"standard input: {len(wrong)} lines are wrong, the first is line {wrong[0]}")


def _answer(mind: Mind, line: bytes) -> FunctionsAnswer | MistakeAnswer:
    fields: dict[str, object] = {}
    try:
        fields = read_object(line, "line")
        question = read_question(fields)
        return FunctionsAnswer.of(understand(mind, question.text), question.id)
    except InputError as error:
        return MistakeAnswer.of(error, line_id(fields))
