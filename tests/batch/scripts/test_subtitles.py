"""Subtitles: cues with their times and voices; sounds are no words."""

from pathlib import Path

import pytest

from understudy.batch.model import ScriptLine
from understudy.batch.scripts.reading import Reader
from understudy.batch.scripts.subtitles import read_srt, read_webvtt
from understudy.errors import UndecodableError
from understudy.model import Interval

SRT = """1
00:00:01,500 --> 00:00:03,000
<i>ANNA: No,
not those.</i>

2
00:00:04,000 --> 00:00:05,000
[door slams] ♪

3
00:01:00,250 --> 00:01:02,000
(sighs) Go: now.
"""

WEBVTT = """WEBVTT

NOTE first draft

intro
00:01.500 --> 00:03.000 align:start
<v.loud Anna>No, <b>not</b> those.

00:01:00.250 --> 00:01:02.000
BEN: Go.
"""


def told(lines: tuple[ScriptLine, ...]) -> list[tuple[int, str, str, str, Interval | None]]:
    return [(line.row, line.id, line.character, line.text, line.interval) for line in lines]


def test_srt() -> None:
    script = read_srt(SRT.encode("utf-8-sig"), Path("film.srt"), {})
    assert told(script.lines) == [
        (1, "film_0001", "ANNA", "No, not those.", Interval(1.5, 3.0)),
        (3, "film_0003", "", "Go: now.", Interval(60.25, 62.0)),
    ]
    assert len(script.remarks) == 1


def test_webvtt() -> None:
    script = read_webvtt(WEBVTT.encode(), Path("film.vtt"), {})
    assert told(script.lines) == [
        (1, "intro", "Anna", "No, not those.", Interval(1.5, 3.0)),
        (2, "film_0002", "BEN", "Go.", Interval(60.25, 62.0)),
    ]


def test_a_cue_that_ends_before_it_begins_is_told() -> None:
    script = read_srt(
        b"1\n00:00:03,000 --> 00:00:02,000\nNo.\n\n2\n00:00:04,000 --> 00:00:05,000\nYes.\n", Path("f"), {}
    )
    assert [line.row for line in script.lines] == [2]
    assert [(problem.row, problem.code) for problem in script.problems] == [(1, "value_wrong")]


@pytest.mark.parametrize("read", [read_srt, read_webvtt])
def test_what_is_no_subtitle_file_is_told(read: Reader) -> None:
    with pytest.raises(UndecodableError) as raised:
        read(b"1\nsoon --> later\nNo.\n", Path("film.srt"), {})
    assert raised.value.code == "subtitles_undecodable"
