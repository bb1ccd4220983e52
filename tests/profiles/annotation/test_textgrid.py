"""TextGrids as Praat writes them, long and short, and where they are wrong."""

from pathlib import Path

import pytest

from understudy.profiles.annotation.model import AnnotationError
from understudy.profiles.annotation.textgrid import read_textgrid

LONG = """File type = "ooTextFile"
Object class = "TextGrid"

xmin = 0
xmax = 2.3
tiers? <exists>
size = 2
item []:
    item [1]:
        class = "IntervalTier"
        name = "words"
        xmin = 0
        xmax = 2.3
        intervals: size = 2
        intervals [1]:
            xmin = 0
            xmax = 1.5
            text = "say ""no"" 7"
        intervals [2]:
            xmin = 1.5
            xmax = 2.3
            text = ""
    item [2]:
        class = "TextTier"
        name = "clicks"
        xmin = 0
        xmax = 2.3
        points: size = 1
        points [1]:
            number = 1.1
            mark = "H*"
"""
SHORT = """File type = "ooTextFile"
Object class = "TextGrid"

0
2.3
<exists>
1
"IntervalTier"
"words"
0
2.3
1
0
1.5
"say ""no"" 7"
"""


@pytest.mark.parametrize("text", [LONG, SHORT, LONG.replace("\n", "\r\n")])
@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16"])
def test_intervals_with_labels(text: str, encoding: str) -> None:
    [track] = read_textgrid(text.encode(encoding), Path("x.TextGrid"))
    assert track.name == "words"
    assert [(span.start_s, span.end_s, span.label) for span in track.spans] == [(0.0, 1.5, 'say "no" 7')]


@pytest.mark.parametrize(
    ("changed", "told"),
    [
        (("xmax = 1.5", "xmax = 1.5s"), ["x: words: line 17: '1.5s' is not a number"]),
        (("xmin = 1.5", "xmin = nan"), ["x: words: line 20: 'nan' is not a number"]),
        (('"IntervalTier"', '"Intervals"'), ["x: words: line 11: 'Intervals' is not a class of tiers"]),
        (("intervals: size = 2", "intervals: size = 3"), ["x: words: line 24: a number is expected"]),
        (("points: size = 1", "points: size = 2"), ["x: clicks: line 31: the file ends before"]),
        (("ooTextFile", "ooBinaryFile"), ["x: not a TextGrid"]),
    ],
)
def test_mistakes_have_their_lines(changed: tuple[str, str], told: list[str]) -> None:
    with pytest.raises(AnnotationError) as raised:
        read_textgrid(LONG.replace(*changed).encode(), Path("x"))
    assert [str(each).startswith(wanted) for each, wanted in zip(raised.value.mistakes, told, strict=True)] == [True]
