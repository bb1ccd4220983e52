"""Lines that have arrived are processed together, and none waits for one that has not."""

import io
import os
from collections.abc import Sequence

import pytest

from understudy.cli.inputs.function_lines import MOST_TOGETHER, waiting_lines


class Arriving(io.BytesIO):
    """A stream that brings its pieces one by one, each when it is asked for."""

    def __init__(self, pieces: Sequence[bytes]) -> None:
        super().__init__()
        self.pieces = list(pieces)

    def read1(self, _size: int | None = -1, /) -> bytes:
        return self.pieces.pop(0) if self.pieces else b""


@pytest.mark.parametrize(
    ("pieces", "together"),
    [
        ([b"a\nb\n", b"c\n"], [[b"a", b"b"], [b"c"], [b""]]),
        ([b"a", b"b\nc", b"d"], [[b"ab"], [b"cd"]]),
        ([b"a\r\n\n"], [[b"a\r", b""], [b""]]),
        ([], [[b""]]),
    ],
)
def test_lines_come_together_as_they_arrive(pieces: list[bytes], together: list[list[bytes]]) -> None:
    assert list(waiting_lines(Arriving(pieces))) == together


def test_no_more_than_so_many_are_taken_together() -> None:
    lines = [b"%d" % number for number in range(MOST_TOGETHER + 1)]
    taken = list(waiting_lines(io.BytesIO(b"\n".join(lines))))
    assert [line for some in taken for line in some] == lines
    assert max(map(len, taken)) == MOST_TOGETHER


def test_a_line_is_there_before_the_next_is_sent() -> None:
    reading, writing = os.pipe()
    with os.fdopen(reading, "rb") as stream, os.fdopen(writing, "wb", buffering=0) as sender:
        lines = waiting_lines(stream)
        for line in (b"one", b"two"):
            sender.write(line + b"\n")
            assert next(lines) == [line]
