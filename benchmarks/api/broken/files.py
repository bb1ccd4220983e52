"""Files that are read from disk rather than sent, almost valid, and what becomes of them: read, or an error of ours.

A kind of file is a row of `KINDS`: something valid to break, and what reads it. Anything but a result or an
UnderstudyError is a fault, and so is a file that takes longer than `LONGEST_S`.
"""

import io
import random
import shutil
import sqlite3
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import closing, suppress
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile

from openpyxl import Workbook

from understudy.batch.manifest.entries import COLUMNS
from understudy.batch.manifest.hashes import KnownRecording
from understudy.batch.manifest.store import FILE, Manifest
from understudy.batch.scripts.reading import read_script
from understudy.errors import UnderstudyError
from understudy.files import resource_folder
from understudy.model.schedule import DEFAULT_CHARACTER
from understudy.profiles.files.reading import read_profile_text
from understudy.studio.scenes import OpenedScene
from understudy.yaml_files import Source

from ..bars import Bar
from .breaking import VALUES, Rng, broken

LONGEST_S = 5.0
_CUT = 4000
"""Bytes of a valid file that are broken: enough to have all of its forms."""

_YAML_MARKS = ("[", "{", "- ", "? ", "&a ", "*a", "!!python/object:x ", "\t", "|", ">", '"', "'", "#", ": ", "\n" * 50)


@dataclass(frozen=True, slots=True)
class FileKind:
    """A valid file's bytes, and what reads a file of that kind from a path."""

    name: str
    valid: Callable[[], bytes]
    read: Callable[[Path], object]
    break_it: Callable[[bytes, Rng], bytes] = broken


def yaml_broken(content: bytes, rng: Rng) -> bytes:
    """As any bytes, or with marks of YAML's put in, very often now and then."""
    if rng.random() < 0.5:
        return broken(content, rng)
    lines = content.decode("utf-8", "replace").split("\n")
    for _ in range(rng.randint(1, 5)):
        at = rng.randrange(len(lines))
        lines[at] = rng.choice(_YAML_MARKS) * rng.choice((1, 1, 2, 40, 3000)) + lines[at]
    return "\n".join(lines).encode()


def _lexicon(name: str) -> bytes:
    return (resource_folder("lexicon") / name).read_bytes()[:_CUT]


def _profile(path: Path) -> object:
    return read_profile_text(path.read_text("utf-8", "replace"), "p", frozenset({"BEAT"}), {})


def _scene(path: Path) -> object:
    index = path.with_name("index.json")
    path.replace(index)
    scene = OpenedScene.of(path.parent)
    return [scene.file(name) for name in scene.names]


@cache
def _workbook() -> bytes:
    book, content = Workbook(), io.BytesIO()
    sheet = book.active
    assert sheet is not None, "a new workbook has a sheet"
    for row in (("id", "character", "text"), ("a", "Ann", "No, not those."), ("b", "Ben", 3.0)):
        sheet.append(row)
    book.create_sheet("notes").append(("nothing",))
    book.save(content)
    return content.getvalue()


def zip_broken(content: bytes, rng: Rng) -> bytes:
    """As any bytes, or with parts of it broken, left out, renamed or very long."""
    if rng.random() < 0.3:
        return broken(content, rng)
    changed = io.BytesIO()
    with ZipFile(io.BytesIO(content)) as before, ZipFile(changed, "w", ZIP_DEFLATED) as after:
        chosen = set(rng.sample(before.namelist(), rng.randint(1, 2)))
        for name in before.namelist():
            part, kind = before.read(name), rng.randrange(8) if name in chosen else -1
            if kind != 0:
                after.writestr(f"../{name}" if kind == 1 else name, xml_broken(part, rng) if kind > 1 else part)
    return changed.getvalue()


_ENTITIES = b"".join(b'<!ENTITY e%d "%s">' % (n + 1, b"&e%d;" % n * 10) for n in range(9))
_INSIDE = (
    b"<c><v>1e999</v></c>",
    b"<a>" * 3000,
    b'<c r="XFD1048577" t="s"><v>-1</v></c>',
    b"\x00",
    b"x" * 99_999,
)


def xml_broken(content: bytes, rng: Rng) -> bytes:
    """As any bytes, or with elements put in, or entities that expand without end."""
    kind = rng.random()
    if kind < 0.5:
        return broken(content, rng)
    if kind < 0.6:
        return b'<!DOCTYPE a [<!ENTITY e0 "ha">' + _ENTITIES + b"]><a>&e9;</a>"
    at = content.find(b">", rng.randrange(max(1, len(content)))) + 1
    return content[:at] + rng.choice(_INSIDE) + content[at:]


_OUTPUTS = '[["bml", "", "a.bml", 12]]'
_ROW = (*("a", 0, 1, "Ann", "default", "No.", "", "a.wav", None, None, "i", "s", "done"), _OUTPUTS, "[]")
_CELLS: tuple[object, ...] = (
    *(each for each in VALUES if isinstance(each, str | float | None) and each != "\ud800"),
    *(b"\x00\xff", -(2**63), "[[]]", "[1]", "[" * 9000, "{}", '{"a": 1}'),
    *('[["bml", "", "../../x", 1]]', '[["bml", "", "/etc/passwd", 1]]'),
)


@cache
def _manifest() -> bytes:
    with tempfile.TemporaryDirectory() as folder:
        with Manifest(Path(folder)) as manifest:
            manifest.know_recordings([("a.wav", KnownRecording(1, 2, "3"))])
        with closing(sqlite3.connect(Path(folder, FILE), isolation_level=None)) as connection:
            connection.execute("PRAGMA journal_mode = DELETE")
            marks = ", ".join("?" * len(_ROW))
            connection.execute(f"INSERT INTO lines ({', '.join(COLUMNS[: len(_ROW)])}) VALUES ({marks})", _ROW)
        return Path(folder, FILE).read_bytes()


def manifest_broken(content: bytes, rng: Rng) -> bytes:
    """As any bytes, or with cells of other kinds, another version, or other tables."""
    if rng.random() < 0.4:
        return broken(content, rng)
    with closing(sqlite3.connect(":memory:", isolation_level=None)) as connection:
        connection.deserialize(content)
        kind = rng.random()
        if kind < 0.1:
            connection.execute(f"PRAGMA user_version = {rng.choice((-1, 0, 2, 2**31 - 1))}")
        elif kind < 0.2:
            connection.executescript("DROP TABLE lines; CREATE VIEW lines AS SELECT 1 AS id")
        for _ in range(rng.randint(1, 3)):
            table, columns = rng.choice((("lines", COLUMNS), ("recordings", ("path", "size", "modified_ns", "hash"))))
            with suppress(sqlite3.Error):
                connection.execute(f"UPDATE {table} SET {rng.choice(columns)} = ?", (rng.choice(_CELLS),))
        return connection.serialize()


def _read_manifest(path: Path) -> object:
    """As a batch that goes on does; a file outside its folder that it would remove is a fault."""
    folder = path.with_name("batch")
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir()
    path.replace(folder / FILE)
    with Manifest(folder) as manifest:
        entries, known = manifest.entries(), manifest.known_recordings()
    for entry in entries.values():
        for file in entry.outputs:
            if not (folder / file.path).resolve().is_relative_to(folder.resolve()):
                raise AssertionError(file.path)
    return [each.hash.encode() for each in known.values()]


def _script(suffix: str) -> Callable[[Path], object]:
    return lambda path: read_script(path.replace(path.with_suffix(suffix)), {})


_LINES = b'{"id": "a", "text": "No, not those.", "character": "Ann"}\n{"id": "b", "text": "Yes."}\n'
_SHEET = b'id;character;text\na;Ann;"No, not\nthose."\nb;Ben;Yes.\n'
_CUES = b"1\n00:00:01,000 --> 00:00:02,500\nANN: No, not those.\n\n2\n00:00:03,000 --> 00:00:04,000\nYes.\n"
_PLAY = b"INT. HOUSE - DAY\n\nANN (CONT'D)\n(whispers)\nNo, not those.\n\nBEN ^\nYes.\n"
_FINAL_DRAFT = (
    b'<?xml version="1.0"?><FinalDraft><Content><Paragraph Type="Character"><Text>ANN</Text></Paragraph>'
    b'<Paragraph Type="Dialogue"><Text>No, not those.</Text></Paragraph></Content></FinalDraft>'
)

KINDS: tuple[FileKind, ...] = (
    FileKind("words", lambda: _lexicon("en/spatial.yaml"), Source, yaml_broken),
    FileKind("characters", lambda: _lexicon(f"characters/{DEFAULT_CHARACTER}.yaml"), Source, yaml_broken),
    FileKind("profiles", lambda: _lexicon("profiles/sparing.yaml"), _profile, yaml_broken),
    FileKind("scenes", lambda: b'{"lines": [{"files": {"wav": "a.wav"}, "listeners": {"B": {"c": "b"}}}]}', _scene),
    FileKind("workbooks", _workbook, _script(".xlsx"), zip_broken),
    FileKind("manifests", _manifest, _read_manifest, manifest_broken),
    FileKind("JSON lines", lambda: _LINES, _script(".jsonl")),
    FileKind("sheets", lambda: _SHEET, _script(".csv")),
    FileKind("subtitles", lambda: _CUES, _script(".srt")),
    FileKind("screenplays", lambda: _PLAY, _script(".fountain")),
    FileKind("Final Draft", lambda: _FINAL_DRAFT, _script(".fdx"), xml_broken),
)


def files_broken(count: int, seed: int) -> Iterator[Bar]:
    """So many files, of all kinds in turns."""
    rng, outcomes, faults = random.Random(seed), Counter[tuple[str, str]](), list[str]()
    with tempfile.TemporaryDirectory() as folder:
        for number in range(count):
            kind = KINDS[number % len(KINDS)]
            path = Path(folder, "broken")
            path.write_bytes(kind.break_it(kind.valid(), rng))
            outcome = _outcome(kind, path)
            outcomes[kind.name, outcome] += 1
            if outcome not in ("read", "refused"):
                faults.append(f"{kind.name}, {number} of seed {seed}: {outcome}")
    for (name, outcome), times in sorted(outcomes.items()):
        print(f"  {name:12s} {outcome}: {times}")
    yield Bar(f"wrong ends of {count} files", "; ".join(faults[:5]) or "0", "0", not faults)


def _outcome(kind: FileKind, path: Path) -> str:
    began_s = time.process_time()
    try:
        kind.read(path)
        told = "read"
    except UnderstudyError:
        told = "refused"
    except Exception as error:  # noqa: BLE001 - the faults that are looked for
        told = f"{type(error).__name__}: {error}"[:200]
    took_s = time.process_time() - began_s
    return told if took_s <= LONGEST_S else f"{took_s:.0f} s"
