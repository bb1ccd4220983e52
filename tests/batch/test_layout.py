"""Names of outputs: their folders, characters that no file system permits, and no two lines with the same name."""

from pathlib import Path

import pytest

from understudy.batch.layout import Layout, require_apart
from understudy.batch.model import Recording, ScriptLine, Take
from understudy.batch.work.formats import LineFormat
from understudy.batch.work.jobs import OutputTarget
from understudy.errors import InputError
from understudy.model.formats import MotionFormat


def test_a_path_for_each_format() -> None:
    line = ScriptLine(row=4, id="a/1", text="no", character="MRS. O'HARA:", scene="2")
    take = Take("a/1", line, Recording(Path("x.wav")), 3)
    targets = Layout("{character}/{ext}/s{scene}_{id}_{take}_{row}.{ext}").targets(
        take, [LineFormat.BML, MotionFormat.JSON, LineFormat.PERFORMANCE]
    )
    assert [target.path for target in targets] == [
        "MRS. O'HARA_/bml/s2_a_1_3_4.bml",
        "MRS. O'HARA_/clip.json/s2_a_1_3_4.clip.json",
        "MRS. O'HARA_/json/s2_a_1_3_4.json",
    ]


@pytest.mark.parametrize(
    "text", ["{id}", "{name}.{ext}", "{character}.{ext}", "/tmp/{id}.{ext}", "../{id}.{ext}", "{id}}.{ext}"]
)
def test_a_layout_that_cannot_be_is_refused(text: str) -> None:
    with pytest.raises(InputError) as raised:
        Layout(text)
    assert raised.value.code == "layout_wrong"


@pytest.mark.parametrize("path", ["a/X.bml", "report.csv"])
def test_no_two_lines_share_a_file_and_none_takes_the_batch_own(path: str) -> None:
    first, second = OutputTarget(LineFormat.BML, "a/x.bml"), OutputTarget(LineFormat.BML, path)
    require_apart([("one", first), ("one", first)])
    with pytest.raises(InputError, match="two"):
        require_apart([("one", first), ("two", second)])
