"""Gesture files for tests: a sound gesture to put lines into."""

from pathlib import Path

import pytest

from understudy.errors import AuthoringError, Mistake
from understudy.realizer.gestures.gesture import Definition
from understudy.realizer.gestures.library import read_definitions

FIRST = "FRAMETYPE stroke_start\n  ARM XC YCC ZNear"
LAST = "FRAMETYPE stroke_end\n  ARM XP YCC ZFar"


def gesture(header: str = "", *, first: str = FIRST, last: str = LAST, name: str = "trial") -> str:
    """A gesture of two frames, with these lines in its header and frames."""
    return (
        f"GESTURECLASS beat\nGESTUREINSTANCE {name}\nDURATION 2\n{header}\n"
        f"STARTFRAME 0.25\n  {first}\nENDFRAME\nSTARTFRAME 0.75\n  {last}\nENDFRAME\n"
    )


def mistakes_in(folder: Path, text: str) -> tuple[Mistake, ...]:
    """What is wrong with a file of that text, in which something must be."""
    with pytest.raises(AuthoringError) as caught:
        read_one(folder, text)
    return caught.value.mistakes


def read_one(folder: Path, text: str) -> Definition:
    """The one gesture in a file of that text, which must be right."""
    path = folder / "trial.gesture"
    path.write_text(text, encoding="utf-8")
    (found,) = read_definitions([path])
    return found
