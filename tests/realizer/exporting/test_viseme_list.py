"""The list of visemes: one line a change, silence in gaps and at the end."""

import pytest

from understudy.model import Interval, Viseme
from understudy.realizer.exporting.viseme_list import to_viseme_text


def viseme(label: str, start_s: float, end_s: float) -> Viseme:
    return Viseme(label, Interval(start_s, end_s), 0.8, 0.4)


@pytest.mark.parametrize(
    ("visemes", "lines"),
    [
        (
            (viseme("PP", 0.1, 0.2), viseme("aa", 0.2, 0.5)),
            ["0.000 sil", "0.100 PP", "0.200 aa", "0.500 sil", "1.000 sil"],
        ),
        ((viseme("PP", 0.0, 0.2), viseme("aa", 0.4, 1.0)), ["0.000 PP", "0.200 sil", "0.400 aa", "1.000 sil"]),
        ((viseme("nn", 0.0, 0.2), viseme("nn", 0.2, 1.0)), ["0.000 nn", "1.000 sil"]),
        ((viseme("sil", 0.0, 1.0),), ["0.000 sil"]),
        ((), ["0.000 sil", "1.000 sil"]),
    ],
)
def test_text_has_a_line_for_each_change(visemes: tuple[Viseme, ...], lines: list[str]) -> None:
    found = to_viseme_text(visemes, 1.0).decode()
    assert found.replace("\t", " ").splitlines() == lines
