"""The gestures of docs/gesture-language.md are right, and the page has every word of the language."""

import re
from pathlib import Path

import pytest

from tests.support.motion.gesture_files import mistakes_in, read_one
from understudy.model import Level
from understudy.realizer.gestures.definitions import FACTORS, MEDIUM, RANGES, SUMMANDS
from understudy.realizer.gestures.gesture import (
    Bend,
    Depth,
    Finger,
    FrameType,
    HandDirection,
    HandForm,
    HeightSector,
    Sideways,
    Thumb,
)
from understudy.realizer.gestures.language import FRAME, HEADER
from understudy.realizer.gestures.library import EMPHASIS
from understudy.realizer.gestures.specifiers import ARM_JOINTS, MAX_OFFSET_M
from understudy.realizer.gestures.statements import OTHER

ROOT = Path(__file__).resolve().parents[2]
PAGE = (ROOT / "docs" / "gesture-language.md").read_text(encoding="utf-8")
EXAMPLES = re.findall(r"```gesture\n(.*?)```", PAGE, flags=re.DOTALL)


def test_every_gesture_on_the_page_is_right(tmp_path: Path) -> None:
    assert [read_one(tmp_path, text).name for text in EXAMPLES] == ["small", "into_the_palm"]
    assert len(EXAMPLES) == PAGE.count("```gesture")


def test_the_paper_s_example_is_the_one_in_use() -> None:
    assert (ROOT / "lexicon" / "gestures" / "small.gesture").read_text(encoding="utf-8") == EXAMPLES[0]


@pytest.mark.parametrize(
    "words",
    [
        HEADER,
        FRAME,
        [OTHER],
        FrameType,
        Sideways,
        HeightSector,
        Depth,
        HandForm,
        Finger,
        Bend,
        HandDirection,
        RANGES,
        Level,
    ],
)
def test_every_word_is_on_the_page(words: list[str]) -> None:
    assert [word for word in words if not re.search(rf"`[^`\n]*\b{word}\b[^`\n]*`", PAGE)] == []


def test_thumbs_and_joints_are_on_the_page() -> None:
    assert all(f"`_{thumb}`" in PAGE for thumb in Thumb if thumb is not Thumb.DEFAULT)
    fingers = {f"{finger}…" for finger in ("Middle", "Ring", "Little")}
    told = {joint for joint in ARM_JOINTS if f"`{joint}`" in PAGE} | {one for one in fingers if f"`{one}`" in PAGE}
    assert {joint for joint in ARM_JOINTS if not joint.startswith(("Middle", "Ring", "Little"))} | fingers == told


def test_the_numbers_on_the_page_are_those_in_use() -> None:
    rows = dict(re.findall(r"^\| `(\w+)` \| ([^|]*\|[^|]*\|[^|]*\|[^|]*)\|", PAGE, flags=re.MULTILINE))
    for place, name in enumerate(RANGES):
        least, most = RANGES[name]
        expected = [f"{least:g} – {most:g}", f"{getattr(MEDIUM, name):g}"]
        for level in (Level.LOW, Level.HIGH):
            factors = (*(f"× {factor:g}" for factor in FACTORS[level]), *map(_signed, SUMMANDS[level]))
            expected.append(factors[place])
        assert [cell.strip() for cell in rows[name].split("|")] == expected
    assert f"{EMPHASIS} of the stroke" in PAGE
    assert f"at most {MAX_OFFSET_M:g} each way" in PAGE


def test_the_mistakes_on_the_page_are_told_so(tmp_path: Path) -> None:
    text = (
        "GESTURECLASS beat\nSTARTFRAME 0.4\n  FRAMETYPE stroke_start\n  HAND form_fits\n  WRIST FBUp PalmDown\n"
        "  ARM XC YCC ZNear\nENDFRAME\n\nSTARTFRAME 0.4\n  FRAMETYPE stroke_end\nENDFRAME\n"
    )
    told = {f"own.gesture:{one.line}:{one.column}: {one.message}" for one in mistakes_in(tmp_path, text)}
    shown, _ = re.findall(r"```console\n(.*?)```", PAGE, flags=re.DOTALL)
    assert set(shown.splitlines()) <= told


def _signed(summand: float) -> str:
    return f"{'−' if summand < 0 else '+'} {abs(summand):g}"
