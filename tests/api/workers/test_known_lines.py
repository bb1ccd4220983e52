"""A worker that knows a line already answers as one that does not, and does not hear it again where nothing that it
hears has changed."""

from dataclasses import replace

import pytest

from understudy.api.workers.known_lines import LONGEST_S, KnownLines
from understudy.files import resource_folder
from understudy.library.performing import perform_line
from understudy.model import Affect, AffectTrack, Direction, GivenFunction, Level, Line, Mode
from understudy.model.edits import Edits, WordEdit, WordMark, WordReference
from understudy.models import Understudy
from understudy.options import Options

AUDIO = (resource_folder("examples") / "example.flac").read_bytes()
TEXT = (resource_folder("examples") / "example.txt").read_text(encoding="utf-8")
SAID = Line(None, "No, I will not go there.")
ANGRY = AffectTrack((0.0,), (Affect(activation=0.8, valence=-0.8, dominance=0.8),))
IMPORTANT = Edits(words=(WordEdit(WordReference(4), mark=WordMark.IMPORTANT),))


@pytest.fixture
def known(understudy: Understudy) -> KnownLines:
    """It has performed the line once."""
    lines = KnownLines()
    lines.performed(understudy, SAID, Options(), {})
    return lines


@pytest.mark.parametrize(
    ("line", "options", "is_known"),
    [
        (SAID, Options(seed=7), True),
        (SAID, Options(mode=Mode.RANDOM, stillness=0.5, lead_in_s=1.0, contours=True), True),
        (replace(SAID, direction=Direction()), Options(), True),
        (SAID, Options(agitation=Level.HIGH), False),
        (SAID, Options(affect=ANGRY), False),
        (SAID, Options().with_edits(IMPORTANT), False),
        (replace(SAID, functions=(GivenFunction("negation", "plain", 0, 1),)), Options(), False),
        (replace(SAID, text="Yes, I will go there."), Options(), False),
    ],
)
def test_a_known_line_is_performed_as_one_that_is_new(
    understudy: Understudy, known: KnownLines, line: Line, options: Options, is_known: bool
) -> None:
    before = known.performed(understudy, SAID, Options(), {})
    again = known.performed(understudy, line, options, {})
    assert again == perform_line(understudy, line, options)
    assert (again.analysis is before.analysis) is is_known


def test_rules_with_edits_understand_anew(understudy: Understudy, known: KnownLines) -> None:
    before = known.performed(understudy, SAID, Options(), {})
    assert known.performed(understudy, SAID, Options(), {"a.rules": ""}).analysis is not before.analysis


def test_a_recording_is_heard_once_and_another_as_itself(understudy: Understudy) -> None:
    lines = KnownLines()
    first, second = (lines.performed(understudy, Line(AUDIO, TEXT), Options(seed=seed), {}) for seed in (0, 1))
    assert second.analysis is first.analysis
    assert lines.performed(understudy, Line(None, TEXT), Options(), {}).analysis.heard is None


def test_lines_that_were_not_asked_about_lately_or_are_long_are_forgotten(
    understudy: Understudy, known: KnownLines
) -> None:
    first = known.performed(understudy, SAID, Options(), {})
    for text in ("Yes.", "No."):
        known.performed(understudy, Line(None, text), Options(), {})
    assert known.performed(understudy, SAID, Options(), {}).analysis is not first.analysis
    long = Line(None, "No, I will not go there. " * 40)
    once, again = (known.performed(understudy, long, Options(), {}).analysis for _ in range(2))
    assert once.utterance.duration_s is not None
    assert once.utterance.duration_s > LONGEST_S
    assert again is not once
