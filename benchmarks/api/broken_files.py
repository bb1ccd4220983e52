"""Files that are read from disk rather than sent, almost valid, and what becomes of them: read, or an error of ours.

A kind of file is a row of `KINDS`: something valid to break, and what reads it. Anything but a result or an
UnderstudyError is a fault, and so is a file that takes longer than `LONGEST_S`.
"""

import random
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from understudy.errors import UnderstudyError
from understudy.model.schedule import DEFAULT_CHARACTER
from understudy.profiles.files.reading import read_profile_text
from understudy.resources import resource_folder
from understudy.studio.scenes import OpenedScene
from understudy.yaml_files import Source

from .bars import Bar
from .breaking import Rng, broken

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


KINDS: tuple[FileKind, ...] = (
    FileKind("words", lambda: _lexicon("en/spatial.yaml"), Source, yaml_broken),
    FileKind("characters", lambda: _lexicon(f"characters/{DEFAULT_CHARACTER}.yaml"), Source, yaml_broken),
    FileKind("profiles", lambda: _lexicon("profiles/sparing.yaml"), _profile, yaml_broken),
    FileKind("scenes", lambda: b'{"lines": [{"files": {"wav": "a.wav"}, "listeners": {"B": {"c": "b"}}}]}', _scene),
)
"""The batch side adds what it reads: workbooks, manifests, zip files."""


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
