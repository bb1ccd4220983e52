"""The manifest returns what was stored, is used by one command at a time, and reports files that are not manifests."""

import sqlite3
from contextlib import closing
from dataclasses import replace
from pathlib import Path

import pytest

from understudy.batch.manifest.entries import ManifestEntry, State, WrittenFile
from understudy.batch.manifest.hashes import KnownRecording
from understudy.batch.manifest.store import FILE, VERSION, Manifest
from understudy.batch.work.jobs import Failure, Measures
from understudy.errors import InputError
from understudy.model import Notice

MEASURES = Measures(1.5, 4, "low", {"negation": 1}, 1, 0, 5, 2, None)
DONE = ManifestEntry(
    "b",
    1,
    3,
    "Ann",
    "default",
    "No — not those.",
    "whispers",
    "audio/b.wav",
    None,
    None,
    "input",
    "settings",
    State.DONE,
    (WrittenFile("bml", "", "b.bml", 12), WrittenFile("bml", "Ben", "b.Ben.bml", 3)),
    (Notice("audio_quiet", "very low"),),
    MEASURES,
    None,
    0.25,
)
FAILED = replace(DONE, id="a", place=0, start_s=1.0, end_s=2.5, state=State.FAILED, failure=Failure("x", "y"))


def test_rows_come_back_in_the_order_of_the_script(tmp_path: Path) -> None:
    with Manifest(tmp_path / "out") as manifest:
        manifest.put([DONE, FAILED])
    with Manifest(tmp_path / "out") as manifest:
        assert list(manifest.entries().items()) == [("a", FAILED), ("b", DONE)]
        manifest.put([replace(DONE, text="other")])
        manifest.remove(["a"])
        assert list(manifest.entries().values()) == [replace(DONE, text="other")]


def test_others_may_read_it_meanwhile(tmp_path: Path) -> None:
    with Manifest(tmp_path) as manifest:
        manifest.put([DONE])
        with closing(sqlite3.connect(tmp_path / FILE)) as other:
            told = other.execute("SELECT id, state FROM lines").fetchall()
    assert told == [("b", "done")]
    assert sorted(path.name for path in tmp_path.iterdir()) == [".lock", FILE]


def test_one_command_at_a_time(tmp_path: Path) -> None:
    with Manifest(tmp_path), pytest.raises(InputError) as raised:
        Manifest(tmp_path)
    assert raised.value.code == "out_in_use"
    Manifest(tmp_path).close()


@pytest.mark.parametrize("content", [b"no database at all, but some text that is long enough", None])
def test_what_is_no_manifest_of_ours_is_told(content: bytes | None, tmp_path: Path) -> None:
    if content is None:
        sqlite3.connect(tmp_path / FILE).execute("CREATE TABLE lines (id TEXT PRIMARY KEY)")
    else:
        (tmp_path / FILE).write_bytes(content)
    with pytest.raises(InputError) as raised:
        Manifest(tmp_path)
    assert raised.value.code == "manifest_unreadable"


def test_recordings_are_read_again_only_when_they_changed(tmp_path: Path) -> None:
    recording = tmp_path / "a.wav"
    recording.write_bytes(b"one")
    known = KnownRecording.of(recording)
    lied = replace(known, hash="not read")
    assert KnownRecording.of(recording, lied) == lied
    with Manifest(tmp_path / "out") as manifest:
        manifest.know_recordings([("a.wav", known)])
        assert manifest.known_recordings() == {"a.wav": known}
    recording.write_bytes(b"three")
    assert KnownRecording.of(recording, known).hash != known.hash


@pytest.mark.parametrize(
    "path",
    ["../../victim", "/etc/hostname", "a/../../victim", "linked/victim", "..", "", "a\0b", "manifest.sqlite-wal"],
)
def test_files_outside_the_folder_and_itself_are_not_the_manifests(path: str, tmp_path: Path) -> None:
    """A batch removes the files of a line's former version, and a folder may come from anybody."""
    out = tmp_path / "deep" / "out"
    with Manifest(out) as manifest:
        manifest.put([replace(DONE, outputs=(WrittenFile("bml", "", path, 1),))])
    (out / "linked").symlink_to(tmp_path, target_is_directory=True)
    with Manifest(out) as manifest, pytest.raises(InputError) as raised:
        manifest.entries()
    assert raised.value.code == "manifest_unreadable"
    assert "'b'" in raised.value.message


@pytest.mark.parametrize(
    ("column", "value"),
    [
        ("outputs", "[[1, 2]]"),
        ("outputs", "no JSON"),
        ("outputs", '[["bml", "", "\\ud800", 1]]'),
        ("warnings", '[["code", "\\ud800"]]'),
        ("outputs", '[["bml", "", 7, 12]]'),
        ("outputs", "[" * 100_000),
        ("measures", '{"words": "many"}'),
        ("measures", "[]"),
        ("place", "first"),
        ("warnings", "7"),
    ],
)
def test_rows_that_nobody_of_us_wrote_are_told(column: str, value: str, tmp_path: Path) -> None:
    with Manifest(tmp_path) as manifest:
        manifest.put([DONE])
    with closing(sqlite3.connect(tmp_path / FILE)) as other, other:
        other.execute(f"UPDATE lines SET {column} = ?", (value,))
    with Manifest(tmp_path) as manifest, pytest.raises(InputError) as raised:
        manifest.entries()
    assert raised.value.code == "manifest_unreadable"
    assert "\n" not in raised.value.message


@pytest.mark.parametrize("column", ["path", "size", "modified_ns", "hash"])
def test_recordings_that_nobody_of_us_wrote_are_reported(column: str, tmp_path: Path) -> None:
    with Manifest(tmp_path) as manifest:
        manifest.know_recordings([("a.wav", KnownRecording(1, 2, "3"))])
    with closing(sqlite3.connect(tmp_path / FILE, isolation_level=None)) as other:
        other.execute(f"UPDATE recordings SET {column} = x'00ff'")
    with Manifest(tmp_path) as manifest, pytest.raises(InputError) as raised:
        manifest.known_recordings()
    assert raised.value.code == "manifest_unreadable"


def test_the_manifest_of_a_later_version_is_refused_and_left_alone(tmp_path: Path) -> None:
    Manifest(tmp_path).close()
    with closing(sqlite3.connect(tmp_path / FILE)) as other, other:
        assert other.execute("PRAGMA user_version").fetchone() == (VERSION,)
        other.execute(f"PRAGMA user_version = {VERSION + 1}")
    before = (tmp_path / FILE).read_bytes()
    with pytest.raises(InputError) as raised:
        Manifest(tmp_path)
    assert raised.value.code == "manifest_newer"
    assert "remove it" not in raised.value.message
    assert (tmp_path / FILE).read_bytes() == before


@pytest.mark.parametrize(
    "made",
    [
        "DROP TABLE lines;"
        "CREATE VIEW lines AS WITH RECURSIVE r(a) AS (SELECT 1 UNION ALL SELECT a FROM r) SELECT a FROM r",
        "CREATE TRIGGER put AFTER INSERT ON lines BEGIN DELETE FROM recordings; END",
    ],
    ids=["view", "trigger"],
)
def test_a_manifest_with_more_than_tables_is_refused_before_it_is_read(made: str, tmp_path: Path) -> None:
    Manifest(tmp_path).close()
    with closing(sqlite3.connect(tmp_path / FILE)) as other:
        other.executescript(made)
    with pytest.raises(InputError, match=r"it has a (view, 'lines'|trigger, 'put')") as raised:
        Manifest(tmp_path)
    assert raised.value.code == "manifest_unreadable"


def test_a_full_disk_is_no_broken_manifest(tmp_path: Path) -> None:
    with Manifest(tmp_path) as manifest:
        manifest.put([DONE])
        manifest._connection.execute("PRAGMA max_page_count = 1")  # as SQLite's own tests fill a disk
        with pytest.raises(InputError) as raised:
            manifest.put(replace(DONE, id=f"l{number}", text="x" * 4000) for number in range(100))
    assert raised.value.code == "disk_full"
    assert "remove it" not in raised.value.message
    with Manifest(tmp_path) as manifest:
        assert list(manifest.entries()) == ["b"]


def test_a_manifest_that_another_program_locks_or_that_is_read_only_is_told(tmp_path: Path) -> None:
    with Manifest(tmp_path) as manifest:
        manifest.put([DONE])
        manifest._connection.execute("PRAGMA busy_timeout = 0")
        with closing(sqlite3.connect(tmp_path / FILE, isolation_level=None)) as other:
            other.execute("BEGIN IMMEDIATE")
            with pytest.raises(InputError) as raised:
                manifest.remove(["b"])
        assert raised.value.code == "out_in_use"
        manifest._connection.execute("PRAGMA query_only = 1")
        with pytest.raises(InputError) as raised:
            manifest.remove(["b"])
        assert raised.value.code == "file_unwritable"
        assert list(manifest.entries()) == ["b"]
