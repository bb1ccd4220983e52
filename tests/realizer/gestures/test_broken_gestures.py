"""Gesture files broken in any way are told as mistakes, each at a place that is there; nothing else is raised."""

from pathlib import Path

from hypothesis import given
from hypothesis import strategies as st

from tests.docs.test_gesture_language_page import EXAMPLES
from tests.support.examples import examples
from understudy.realizer.gestures.checking import duplicate_names
from understudy.realizer.gestures.definitions import definition
from understudy.realizer.gestures.language import parse_gestures
from understudy.realizer.gestures.statements import LocatedMistake, mistake_in

LINES = tuple("\n".join(EXAMPLES).splitlines())
WORDS = sorted({word for line in LINES for word in line.split()})


@st.composite
def broken_lines(draw: st.DrawFn) -> list[str]:
    """Lines of good gestures after a few slips of an editor."""
    lines = list(LINES)
    for _ in range(draw(st.integers(1, 6))):
        at = draw(st.integers(0, len(lines) - 1))
        words = lines[at].split(" ")
        word = draw(st.integers(0, len(words) - 1))
        slip = draw(st.sampled_from(["drop", "repeat", "word", "cut", "character"]))
        if slip == "drop":
            del lines[at : at + draw(st.integers(1, 3))]
            lines = lines or [""]
        elif slip == "repeat":
            lines.insert(at, draw(st.sampled_from(LINES)))
        elif slip == "word":
            lines[at] = " ".join([*words[:word], draw(st.sampled_from(WORDS)), *words[word + 1 :]])
        elif slip == "cut":
            lines[at] = " ".join(words[:word])
        else:
            lines[at] = " ".join([*words[:word], draw(st.text(max_size=2)), *words[word:]])
    return lines


@examples(150)
@given(broken_lines())
def test_every_mistake_has_its_place(lines: list[str]) -> None:
    file, mistakes = parse_gestures("\n".join(lines), Path("broken.gesture"))
    wrong: list[LocatedMistake] = []
    found = [definition(tree, file.path, wrong) for tree in file.gestures]
    told = [*mistakes, *(mistake_in(file, one) for one in wrong), *duplicate_names([file])]
    assert all(found) or told
    for one in told:
        assert 1 <= one.column <= len(file.lines[one.line - 1]) + 1
        assert one.message
