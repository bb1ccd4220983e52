"""Compressed recordings: converted where there is ffmpeg, told where there is none."""

import os
import stat
from pathlib import Path

import pytest
import soundfile

from understudy.batch.audio import AudioSource
from understudy.batch.matching import find_recordings, join_recordings
from understudy.batch.model import ScriptLine
from understudy.batch.planning import BatchRequest, plan_batch, without_audio
from understudy.errors import InputError, UndecodableError
from understudy.model import Interval

SAID = Path(__file__).parents[1] / "audio" / "figure8.flac"


@pytest.fixture
def ffmpeg(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A program of that name, which takes what it is given for WAV; "broken" is broken."""
    folder = tmp_path / "bin"
    folder.mkdir()
    program = folder / "ffmpeg"
    program.write_text(
        "#!/bin/sh\n"
        'for last; do [ "$before" = -i ] && given="${last#file:}"; before="$last"; done\n'
        'case "$given" in *broken*) echo "first" >&2; echo "Invalid data found" >&2; exit 1;; esac\n'
        'cp "$given" "$last"\n'
    )
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("PATH", f"{folder}{os.pathsep}{os.environ['PATH']}")
    return folder


@pytest.fixture
def no_ffmpeg(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PATH", str(tmp_path / "nothing"))


def recorded(path: Path) -> Path:
    samples, rate = soundfile.read(SAID)
    soundfile.write(path, samples, rate, format="WAV")
    return path


@pytest.mark.usefixtures("ffmpeg")
def test_ffmpeg_makes_wav_of_it_and_lines_are_cut_out(tmp_path: Path) -> None:
    path = recorded(tmp_path / "VO_005.mp3")
    assert AudioSource(path).content() == path.read_bytes()
    cut = AudioSource(path, interval=Interval(0.5, 1.5)).content()
    (tmp_path / "cut.wav").write_bytes(cut)
    assert soundfile.info(tmp_path / "cut.wav").duration == pytest.approx(1.0)
    assert AudioSource(path).to_send().content() == path.read_bytes()


@pytest.mark.usefixtures("ffmpeg")
def test_what_ffmpeg_cannot_read_is_told_in_its_last_words(tmp_path: Path) -> None:
    with pytest.raises(UndecodableError, match="ffmpeg: Invalid data found"):
        AudioSource(recorded(tmp_path / "broken.m4a")).content()


@pytest.mark.usefixtures("no_ffmpeg")
def test_without_ffmpeg_the_line_says_which_file_is_there(tmp_path: Path) -> None:
    (tmp_path / "audio").mkdir()
    recorded(tmp_path / "audio" / "VO_005.mp3")
    recorded(tmp_path / "audio" / "VO_006.wav")
    (tmp_path / "lines.csv").write_text("ID,Line\nVO_005,No.\nVO_006,Yes.\nVO_007,Perhaps.\n")
    plan = plan_batch(BatchRequest(tmp_path / "lines.csv", tmp_path / "audio", tmp_path / "out"))
    assert [take.id for take, _job in plan.jobs] == ["VO_006"]
    told = [without_audio(missing, plan.script.unit) for missing in plan.joined.missing]
    assert told[0] == "row 2: no recording: VO_005.mp3 is there; convert it to .wav or .flac, or install ffmpeg"
    assert told[1] == "row 4: no recording"
    with pytest.raises(InputError) as raised:
        AudioSource(tmp_path / "audio" / "VO_005.mp3").content()
    assert raised.value.code == "audio_compressed"


def test_a_recording_that_we_read_goes_before_a_compressed_one(tmp_path: Path) -> None:
    for name in ("a.wav", "a.mp3", "b.mp3"):
        (tmp_path / name).write_bytes(b"")
    files = find_recordings(tmp_path, without=tmp_path / "out")
    assert [file.path.name for file in files] == ["a.wav", "b.mp3"]
    joined = join_recordings([ScriptLine(1, "a", "No."), ScriptLine(2, "b", "No.")], files)
    assert [take.recording.path.name for take in joined.takes] == ["a.wav", "b.mp3"]
