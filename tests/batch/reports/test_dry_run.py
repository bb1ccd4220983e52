"""The dry run says how the script was understood, and what all that is asked for costs."""

import shutil
from dataclasses import replace
from pathlib import Path

import pytest

from understudy.batch.planning import BatchRequest, plan_batch
from understudy.batch.reports.dry_run import dry_run
from understudy.batch.work.formats import LineFormat
from understudy.model.formats import MotionFormat

from ...support.words.voice_scripts import SCREENPLAY, SHEET, acts

SAID = Path(__file__).parents[2] / "audio" / "figure8.flac"


def request_for(folder: Path, name: str, content: bytes, *recordings: str) -> BatchRequest:
    (folder / "audio").mkdir()
    for recording in recordings:
        shutil.copy(SAID, folder / "audio" / f"{recording}.flac")
    (folder / name).write_bytes(content)
    return BatchRequest(folder / name, folder / "audio", folder / "out")


def told(request: BatchRequest, thumbnails: int = 0) -> list[str]:
    return list(dry_run(plan_batch(request), {}, workers=1, thumbnails=thumbnails).lines)


def test_columns_and_the_first_lines_are_told_as_they_were_understood(tmp_path: Path) -> None:
    lines = told(request_for(tmp_path, "lines.csv", SHEET, "VO_001", "VO_002", "VO_003", "VO_004"))
    assert lines[:3] == ["id           <- A (Line #)", "character    <- B (Character)", "text         <- C (Line)"]
    assert "row 5, VO_001: Zoë: You can't cross here. Not tonight." in lines
    assert sum(line.startswith("row ") for line in lines) == 3
    assert any("not UTF-8" in line for line in lines)


def test_what_of_a_workbook_is_left_out_is_told(tmp_path: Path) -> None:
    lines = told(request_for(tmp_path, "lines.xlsx", acts(), "A1_01"))
    assert any("left out 'Info', 'Budget'" in line for line in lines)
    assert "sheet 'Act 1', row 2, A1_01: Zoë: You can't cross here." in lines
    assert "wrong rows: 2" in lines


def test_screenplays_have_lines(tmp_path: Path) -> None:
    lines = told(request_for(tmp_path, "watch.fountain", SCREENPLAY.encode(), "scene1_001"))
    assert "  scene1_002, line 9: no recording" in lines


@pytest.mark.parametrize("changes", [{"formats": (LineFormat.BML, MotionFormat.SHEET)}, {"thumbnails": 3}])
def test_the_estimate_has_what_formats_and_pictures_cost(changes: dict[str, object], tmp_path: Path) -> None:
    recordings = [f"VO_{number:03d}" for number in range(300)]
    script = "id,text\n" + "".join(f"{name},no\n" for name in recordings)
    request = request_for(tmp_path, "lines.csv", script.encode(), *recordings[:60])
    more = replace(request, **{name: value for name, value in changes.items() if name != "thumbnails"})  # type: ignore[arg-type]
    pictures = int(str(changes.get("thumbnails", 0))) * 20
    assert seconds(told(more, pictures)) > 1.5 * seconds(told(request))


def seconds(lines: list[str]) -> float:
    number, unit = lines[-1].partition("about ")[2].split()[:2]
    return float(number) * {"s": 1, "min": 60}[unit]
