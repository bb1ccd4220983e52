"""A batch from its script to its reports: what is performed, what is performed again, what is reported."""

import csv
import errno
import json
import shutil
import sys
from concurrent.futures import Future
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
import soundfile

import understudy
from understudy.batch.audio import AudioSource
from understudy.batch.manifest.entries import ManifestEntry, State
from understudy.batch.manifest.hashes import installation_hash
from understudy.batch.planning import BatchRequest
from understudy.batch.whole_run import Nobody, run_batch
from understudy.batch.work.files import unwritable
from understudy.batch.work.formats import LineFormat
from understudy.batch.work.jobs import LineJob, LineOutcome, OutputTarget
from understudy.batch.work.performing import perform_job
from understudy.bml.writing.writer import write_bml
from understudy.errors import InputError
from understudy.files import replace_file
from understudy.model import Line
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.settings import Settings

from ..support.batches import ThisProcess

AUDIO = Path(__file__).parents[1] / "audio"
TEXT = (AUDIO / "figure8.txt").read_text(encoding="utf-8").strip()


class Batch:
    """A folder with a script of two good lines and three bad ones, and the commands on it."""

    def __init__(self, folder: Path, models: Understudy) -> None:
        self.folder, self.models = folder, models
        (folder / "audio").mkdir()
        for name in ("one", "two", "spare"):
            shutil.copy(AUDIO / "figure8.flac", folder / "audio" / f"{name}.flac")
        self.request = BatchRequest(folder / "lines.csv", folder / "audio", folder / "out")
        self.write(one=TEXT, two=TEXT, gone="no", empty="")

    def write(self, **texts: str) -> None:
        rows = [["id", "text"], *texts.items(), ["one", "again"]]
        with (self.folder / "lines.csv").open("w", encoding="utf-8", newline="") as file:
            csv.writer(file).writerows(rows)

    def run(self, **changes: object) -> tuple[list[str], dict[str, ManifestEntry]]:
        """Which lines were performed, and the rows of all."""
        engine = ThisProcess(self.models)
        request = replace(self.request, **changes)  # type: ignore[arg-type]
        entries = run_batch(request, Settings(), lambda: engine, Nobody())
        return engine.performed, {entry.id: entry for entry in entries}

    def bytes_out(self) -> dict[str, bytes]:
        files = [path for path in sorted((self.folder / "out").rglob("*")) if path.is_file()]
        return {path.name: path.read_bytes() for path in files if path.suffix in {".bml", ".json", ".csv", ".html"}}


hashed_once = cache(installation_hash)
"""No test changes what is installed, 50 MB of models among it."""


@pytest.fixture
def batch(tmp_path: Path, understudy: Understudy, monkeypatch: pytest.MonkeyPatch) -> Batch:
    monkeypatch.setattr("understudy.batch.whole_run.installation_hash", hashed_once)
    monkeypatch.setitem(sys.modules, "matplotlib.figure", None)  # reports without histograms, which take long
    return Batch(tmp_path, understudy)


def test_lines_are_performed_as_by_themselves_and_wrong_ones_are_named(batch: Batch) -> None:
    performed, entries = batch.run()
    assert performed == ["one", "two"]
    alone = perform(batch.models, Line((AUDIO / "figure8.flac").read_bytes(), TEXT), Options())
    assert batch.bytes_out()["one.bml"] == write_bml(alone)
    assert {name: entry.failure.code for name, entry in entries.items() if entry.failure} == {
        "empty": "text_empty",
        "one (row 6)": "id_repeated",
        "gone": "audio_missing",
    }
    rows = list(csv.DictReader((batch.folder / "out" / "report.csv").read_text("utf-8-sig").splitlines()))
    assert [row["state"] for row in rows] == ["failed"] * 3 + ["done"] * 2
    assert [line["id"] for line in json.loads(batch.bytes_out()["index.json"])["lines"]] == ["one", "two"]


def test_only_what_changed_is_done_again(batch: Batch) -> None:
    batch.run()
    before = batch.bytes_out()
    assert batch.run()[0] == []
    assert batch.bytes_out() == before
    (batch.folder / "out" / "two.bml").write_bytes(b"half")
    assert batch.run()[0] == ["two"]
    assert batch.bytes_out() == before
    batch.write(two=TEXT, one=f"{TEXT} No.")
    assert batch.run()[0] == ["one"]
    (batch.folder / "audio" / "two.flac").write_bytes((AUDIO / "figure8.flac").read_bytes())
    assert batch.run()[0] == []
    assert batch.run(formats=(LineFormat.BML, LineFormat.PERFORMANCE))[0] == ["two", "one"]
    assert batch.run(again=True)[0] == ["two", "one"]


def test_a_line_that_fails_now_leaves_nothing_of_what_it_was(batch: Batch) -> None:
    batch.run()
    (batch.folder / "audio" / "two.flac").write_bytes(b"no sound")
    _performed, entries = batch.run()
    assert (entries["two"].state, entries["two"].outputs) == (State.FAILED, ())
    assert "two.bml" not in batch.bytes_out()
    shutil.copy(AUDIO / "figure8.flac", batch.folder / "audio" / "two.flac")
    assert batch.run()[0] == ["two"]
    assert "two.bml" in batch.bytes_out()


def test_a_speaker_is_judged_by_his_other_lines(batch: Batch) -> None:
    names = [f"l{number}" for number in range(4)]
    for name in names:
        shutil.copy(AUDIO / "figure8.flac", batch.folder / "audio" / f"{name}.flac")
    rows = ["id,character,scene,text", *(f'{name},Ann,1,"{TEXT}"' for name in names), f'one,Ben,1,"{TEXT}"']
    (batch.folder / "lines.csv").write_text("\n".join(rows), encoding="utf-8")
    performed, entries = batch.run()
    assert performed == [*names, "one"]
    kept = batch.folder / "out" / "references" / "ann.json"
    heard = understudy.make_reference(batch.models, [AUDIO / "figure8.flac"] * 4)
    assert json.loads(kept.read_bytes())["mean"] == heard.mean.tolist()
    assert [file.path for file in entries["l3"].outputs] == ["l3.bml", "l3.Ben.bml"]
    assert [file.path for file in entries["l0"].outputs] == ["l0.bml", "l0.Ben.bml"]
    assert not entries["l0"].warnings
    assert batch.run()[0] == []
    assert batch.run(learns_voices=False)[0] == names


def test_no_output_is_written_over_what_is_read(batch: Batch) -> None:
    shutil.copy(AUDIO / "figure8.flac", batch.folder / "audio" / "x.wav")
    (batch.folder / "lines.csv").write_text(f'id,file,text\nx,x.wav,"{TEXT}"\n', encoding="utf-8")
    with pytest.raises(InputError) as raised:
        batch.run(out=batch.folder / "audio", formats=(LineFormat.WAV,))
    assert raised.value.code == "files_same"


def test_lines_are_cut_out_of_one_recording_by_their_times(batch: Batch) -> None:
    script = batch.folder / "film.srt"
    cues = ["1\n00:00:00,150 --> 00:00:01,050\nANN: I guess not.", "2\n00:09:00,000 --> 00:09:01,000\nNo."]
    script.write_text("\n\n".join(cues))
    shutil.copy(AUDIO / "figure8.flac", batch.folder / "audio" / "film.flac")
    performed, entries = batch.run(script=script, formats=(LineFormat.WAV,))
    assert performed == ["film_0001", "film_0002"]
    first, second = entries.values()
    assert first.measures is not None
    assert first.measures.duration_s == pytest.approx(0.9)
    assert soundfile.info(batch.folder / "out" / "film_0001.wav").duration == pytest.approx(0.9)
    assert second.failure is not None
    assert second.failure.code == "cut_outside"


def test_edits_beside_a_recording_are_made_again_when_they_change(batch: Batch) -> None:
    plain, _entries = batch.run()
    assert set(plain) == {"one", "two"}
    edits = batch.folder / "audio" / "two.edits.json"
    edits.write_text('{"behaviors": [{"add": "gesture", "on": {"word": 8}, "lexeme": "POINT_FRONT"}]}')
    changed, entries = batch.run()
    assert changed == ["two"]
    assert entries["two"].state is State.DONE
    assert b'lexeme="POINT_FRONT"' in (batch.folder / "out" / "two.bml").read_bytes()
    edits.write_text('{"behavior": []}')
    wrong, entries = batch.run()
    assert wrong == []
    [failed] = [entry for entry in entries.values() if entry.failure and entry.failure.code == "edits_wrong"]
    assert failed.state is State.FAILED


def test_a_disk_that_is_full_for_a_worker_is_told_as_such(
    understudy: Understudy, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_given: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr("understudy.batch.work.performing.write_files", fail)
    audio, target = AudioSource(AUDIO / "figure8.flac"), OutputTarget(LineFormat.BML, "one.bml")
    with pytest.raises(InputError) as raised:
        perform_job(LineJob("one", TEXT, audio, Options(), (target,), folder=tmp_path), understudy)
    assert raised.value.code == "disk_full"


class SmallDisk:
    """Room for so many outputs, the same for all of a batch."""

    def __init__(self, room: int) -> None:
        self.room = room

    def replace_file(self, target: Path, content: bytes, *, unfinished: Path | None = None) -> None:
        if not self.room:
            raise OSError(errno.ENOSPC, "No space left on device")
        self.room -= 1
        replace_file(target, content, unfinished=unfinished)


def on_a_disk(room: int, patch: pytest.MonkeyPatch) -> SmallDisk:
    disk = SmallDisk(room)
    patch.setattr("understudy.batch.work.files.replace_file", disk.replace_file)
    return disk


def test_a_full_disk_ends_the_batch_which_goes_on_when_there_is_room(
    batch: Batch, monkeypatch: pytest.MonkeyPatch
) -> None:
    names = ["one", "two", "three", "four", "five", "six"]
    for name in names[2:]:
        shutil.copy(AUDIO / "figure8.flac", batch.folder / "audio" / f"{name}.flac")
    batch.write(**dict.fromkeys(names, TEXT))
    disk = on_a_disk(1, monkeypatch)
    engine = ThisProcess(batch.models)
    with pytest.raises(InputError, match="the disk is full; free some space") as raised:
        run_batch(batch.request, Settings(), lambda: engine, Nobody())
    assert raised.value.code == "disk_full"
    assert engine.performed == names[:3]  # the one that finds no room, and the next, which is under way by then
    assert (batch.folder / "out" / "one.bml").is_file()
    disk.room = 100
    performed, entries = batch.run()
    assert performed == names[1:]
    assert {entries[name].state for name in names} == {State.DONE}


class WithoutRoom(ThisProcess):
    """An engine on a disk that is full already."""

    def submit(self, job: LineJob) -> "Future[LineOutcome]":
        self.performed.append(job.id)
        future: Future[LineOutcome] = Future()
        future.set_exception(unwritable(OSError(errno.ENOSPC, "No space left on device"), Path("out")))
        return future


def test_a_full_disk_ends_a_batch_also_where_only_pictures_are_missing(batch: Batch) -> None:
    shutil.copy(AUDIO / "figure8.flac", batch.folder / "audio" / "three.flac")
    batch.write(one=TEXT, two=TEXT, three=TEXT)
    batch.run()
    engine = WithoutRoom(batch.models)
    with pytest.raises(InputError) as raised:
        run_batch(replace(batch.request, thumbnails=3), Settings(), lambda: engine, Nobody())
    assert raised.value.code == "disk_full"
    assert len(engine.performed) == 2  # of three
