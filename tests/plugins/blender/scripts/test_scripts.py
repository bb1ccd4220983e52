"""Sheets, subtitles and screenplays as lines, and the recordings that are found for them."""

from pathlib import Path

import pytest

from plugins.blender.scripts.model import ScriptError, ScriptLine
from plugins.blender.scripts.reading import read_script, recordings
from understudy.batch.scripts.screenplays import read_fountain
from understudy.batch.scripts.subtitles import read_srt

FOUNTAIN = """Title: Lights
Author: Nobody

INT. HOUSE - DAY #1A#

ANNA looks up.

ANNA (V.O.)
(softly)
I *never* saw [[id: a12]] those,
_never_.

@McTeague ^
No!

EXT. HILL - NIGHT

ANNA (CONT'D)
Go.

BEN
(waits)

CUT TO:
"""
SRT = """1
00:00:01,000 --> 00:00:02,500
ANNA: I <i>never</i>
saw those.

2
00:00:03,000 --> 00:00:04,000
[door slams]

3
00:01:05,250 --> 00:01:06,000
No!
"""


def read(folder: Path, name: str, content: str, encoding: str = "utf-8") -> tuple[ScriptLine, ...]:
    path = folder / name
    path.write_text(content, encoding=encoding)
    return read_script(path)


@pytest.mark.parametrize(
    "content",
    [
        'ID,Character,Line\nvo_1,Zoë,"No, not those."\nvo_2,Ben,\n',
        "Line;Text;Speaker\nvo_1;No, not those.;Zoë\n",
        "Night scene\tdraft 2\t\n\t\t\nKey\tDialogue\tRole\nvo_1\tNo, not those.\tZoë\n",
    ],
)
def test_a_sheet_by_its_headings(tmp_path: Path, content: str) -> None:
    for encoding in ("utf-8-sig", "cp1252"):
        assert read(tmp_path, "a.csv", content, encoding) == (ScriptLine("vo_1", "No, not those.", "Zoë"),)


def test_lines_without_an_id_are_numbered(tmp_path: Path) -> None:
    (line,) = read(tmp_path, "night.tsv", "Text\tFile\nNo.\ttakes/a.wav\n")
    assert (line.id, line.audio) == ("night_0001", "takes/a.wav")


def test_subtitles_are_read_as_the_batch_reads_them(tmp_path: Path) -> None:
    ours = read(tmp_path, "night.srt", SRT)
    theirs = read_srt(SRT.encode(), tmp_path / "night.srt", {}).lines
    assert [(line.id, line.text, line.character) for line in ours] == [
        (line.id, line.text, line.character) for line in theirs
    ]
    assert [(line.start_s, line.end_s) for line in ours] == [(1.0, 2.5), (65.25, 66.0)]


def test_a_screenplay_is_read_as_the_batch_reads_it(tmp_path: Path) -> None:
    ours = read(tmp_path, "lights.fountain", FOUNTAIN)
    theirs = read_fountain(FOUNTAIN.encode(), tmp_path / "lights.fountain", {}).lines
    assert [(line.id, line.text, line.character) for line in ours] == [
        (line.id, line.text, line.character) for line in theirs
    ]


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        ("a.csv", "Scene,Take\n1,2\n", "no column has the words"),
        ("a.srt", "nothing", "no cue with words"),
        ("a.fountain", "Somebody walks.", "no speech"),
        ("a.docx", "", "a script is .csv"),
    ],
)
def test_what_is_no_script_is_told(tmp_path: Path, name: str, content: str, said: str) -> None:
    with pytest.raises(ScriptError, match=said):
        read(tmp_path, name, content)


def test_recordings_are_found_by_name(tmp_path: Path) -> None:
    for name in ("VO_1.wav", "takes/a.mp3", "night.flac", "night.txt"):
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).touch()
    lines = [
        ScriptLine("vo_1", "No."),
        ScriptLine("vo_2", "No.", audio="elsewhere\\A.wav"),
        ScriptLine("vo_3", "No.", start_s=1.0, end_s=2.0),
        ScriptLine("vo_4", "No."),
    ]
    found = recordings(lines, tmp_path / "night.srt", tmp_path)
    assert {name: path.name for name, path in found.items()} == {
        "vo_1": "VO_1.wav",
        "vo_2": "a.mp3",
        "vo_3": "night.flac",
    }
