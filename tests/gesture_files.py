"""Gesture files for tests: a sound gesture to put lines into."""

from pathlib import Path

from app.errors import Mistake
from app.realizer.gesture import Definition
from app.realizer.library import read_definitions

FIRST = "FRAMETYPE stroke_start\n  ARM XC YCC ZNear"
LAST = "FRAMETYPE stroke_end\n  ARM XP YCC ZFar"


def gesture(header: str = "", *, first: str = FIRST, last: str = LAST, name: str = "trial") -> str:
    """A gesture of two frames, with these lines in its header and frames."""
    return (
        f"GESTURECLASS beat\nGESTUREINSTANCE {name}\nDURATION 2\n{header}\n"
        f"STARTFRAME 0.25\n  {first}\nENDFRAME\nSTARTFRAME 0.75\n  {last}\nENDFRAME\n"
    )


def read(folder: Path, text: str) -> tuple[tuple[Definition, ...], tuple[Mistake, ...]]:
    """What a file of that text defines, and what is wrong with it."""
    path = folder / "trial.gesture"
    path.write_text(text, encoding="utf-8")
    return read_definitions([path])


def read_one(folder: Path, text: str) -> Definition:
    """The one gesture in a file of that text, which must be right."""
    definitions, mistakes = read(folder, text)
    assert mistakes == ()
    assert len(definitions) == 1
    return definitions[0]
