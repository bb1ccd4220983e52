"""The weights of a mesh's shape keys: ARKit's 52 as rigs spell them, else visemes, else sums of both as
`faces/*.toml` has them for families of avatars.

A mesh with ARKit's mouth gets no visemes, which would open it twice; and as eyes turn by their bones, `eyeLook…`
shapes, which move only the lids, are used as they are.
"""

import re
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path

import numpy as np

from ..motion.clip import Clip
from ..motion.rotations import Array

FOLDER = Path(__file__).parent / "faces"
_SEPARATORS = re.compile(r"[\s_.\-]+")
_LETTER = re.compile(r"[_.\-]([lr])$", re.IGNORECASE)
_ENOUGH = 8
"""So many of ARKit's shapes make a face; a few of the same name may be chance."""

Sums = Mapping[str, Mapping[str, float]]


def load_sums(folder: Path = FOLDER) -> tuple[Sums, ...]:
    """The tables of the families of avatars."""
    paths = sorted(folder.glob("*.toml"))
    return tuple(tomllib.loads(path.read_text(encoding="utf-8"))["shapes"] for path in paths)


def face_weights(keys: Iterable[str], clip: Clip) -> dict[str, Array]:
    """The weights (T,) of the shape keys with these names that show something; empty for a mesh without a face."""
    names = list(keys)
    shapes = {_plain(name): weights for name, weights in clip.shapes.items()}
    found = {name: shapes[_plain(name)] for name in names if _plain(name) in shapes}
    if len(found) >= _ENOUGH:
        return found
    sources = {f"viseme_{name}": weights for name, weights in clip.visemes.items()} | dict(clip.shapes)
    by_viseme = {_plain(name): weights for name, weights in sources.items() if name.startswith("viseme_")}
    found = {name: by_viseme[_plain(name)] for name in names if _plain(name) in by_viseme}
    if found:
        return found
    best = max(load_sums(), key=lambda sums: len(sums.keys() & names))
    return {name: _sum(best[name], sources, clip.frames) for name in names if name in best}


def _sum(parts: Mapping[str, float], sources: Mapping[str, Array], frames: int) -> Array:
    """Parts that the clip lacks, such as visemes without speech, are 0."""
    total = sum((share * sources[name] for name, share in parts.items() if name in sources), np.zeros(frames))
    return np.clip(total, 0.0, 1.0)


def _plain(name: str) -> str:
    """A shape's name as it is compared: `eyeBlink_L`, `EyeBlinkLeft` and `eye_blink_left` are one."""
    whole = _LETTER.sub(lambda found: "left" if found[1] in "lL" else "right", name)
    return _SEPARATORS.sub("", whole).lower()
