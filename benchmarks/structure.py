"""The structure of the code in a line of figures, and as a picture: `python -m benchmarks.structure [--draw FILE.svg]`

Modules, folders and levels of `app/` (without `__init__`), its largest room, the lengths of functions in lines, and
class names that mean several things, from the syntax trees. The picture has the layers that import-linter keeps
(pyproject.toml), the doors at the top, and within each room its modules.
"""

import argparse
import ast
import tomllib
from collections import defaultdict
from collections.abc import Iterator, Sequence
from pathlib import Path
from xml.sax.saxutils import escape

import numpy as np
from numpy.typing import NDArray

from benchmarks.figures import add_record_option, record

ROOT = Path(__file__).resolve().parents[1]
APP = ROOT / "app"

WIDTH, MARGIN, ROW, BOX = 1180, 20, 58, 42

LAYER_TITLES = {
    "cli": "doors: command line, service, batch, studio, studies",
    "schemas": "what doors say and check",
    "performance": "Figure 2: the stages in order",
    "behavior": "stages, none of which imports another",
    "model": "values and the ground floor",
}


def modules(root: Path = APP) -> tuple[Path, ...]:
    """The Python modules below a folder, without `__init__`."""
    return tuple(sorted(path for path in root.rglob("*.py") if path.name != "__init__.py"))


def function_lengths(paths: Sequence[Path]) -> list[int]:
    """The lines of each function."""
    return [
        (node.end_lineno or node.lineno) - node.lineno + 1
        for path in paths
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)
    ]


def shared_names(paths: Sequence[Path]) -> dict[str, tuple[Path, ...]]:
    """The names that public classes of several modules have, with these modules."""
    places = defaultdict[str, list[Path]](list)
    for path in paths:
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
                places[node.name].append(path)
    return {name: tuple(found) for name, found in sorted(places.items()) if len(found) > 1}


def rooms(paths: Sequence[Path]) -> dict[Path, int]:
    """The number of modules in each folder."""
    return {folder: sum(path.parent == folder for path in paths) for folder in {path.parent for path in paths}}


def layers() -> Iterator[tuple[str, ...]]:
    """The packages of each layer of the house, the highest first, as the contract on them names them."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"][
        "contracts"
    ]
    for layer in next(each for each in contracts if each["name"].startswith("Data flows one way"))["layers"]:
        yield tuple(name.strip().removeprefix("understudy.") for name in layer.split("|"))


def picture() -> str:
    """The layers as SVG: a row a layer, a box a room or module, with its number of modules."""
    rows = list(layers())
    parts = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {MARGIN * 2 + ROW * len(rows)}" '
        'font-family="system-ui, sans-serif" font-size="14">',
        '<rect width="100%" height="100%" fill="#fbfaf8"/>',
    ]
    for number, names in enumerate(rows):
        parts += _row(names, MARGIN + number * ROW)
    return "\n".join([*parts, "</svg>", ""])


def _row(names: Sequence[str], top: int) -> Iterator[str]:
    width = (WIDTH - 2 * MARGIN - 8 * (len(names) - 1)) / len(names)
    for place, name in enumerate(names):
        left = MARGIN + place * (width + 8)
        count = len(modules(APP / name)) if (APP / name).is_dir() else 0
        label = f"{name}/  {count}" if count else f"{name}.py"
        fill = "#e4edf5" if count else "#f3ead8"
        box = f'x="{left:.0f}" y="{top}" width="{width:.0f}" height="{BOX}" rx="6"'
        yield f'<rect {box} fill="{fill}" stroke="#8899aa"/>'
        yield f'<text x="{left + width / 2:.0f}" y="{top + 26}" text-anchor="middle" fill="#223">{escape(label)}</text>'
    title = next((LAYER_TITLES[name] for name in names if name in LAYER_TITLES), None)
    if title:
        yield f'<text x="{MARGIN + 6}" y="{top - 4}" font-size="11" fill="#667">{escape(title)}</text>'


def record_figures(paths: Sequence[Path], filled: dict[Path, int], lengths: NDArray[np.int_]) -> None:
    record("house", "modules of app/", len(paths), bar="≤ 667", aim="≤ 480")
    record("house", "folders of app/", len(filled))
    record("house", "levels of folders, app/ counted", levels(paths), bar="≤ 4", aim="≤ 3")
    record("house", "modules in the largest room", max(filled.values()), bar="≤ 20", aim="≤ 16")
    record("house", "class names that stand twice or more", len(shared_names(paths)), bar="≤ 46", aim="≤ 0")
    record("house", "lines of a function, 90 %", np.percentile(lengths, 90), bar="≤ 15")
    record("house", "lines of the longest function", lengths.max(), bar="≤ 40")


def levels(paths: Sequence[Path]) -> int:
    """The most folders above a module, `app/` counted."""
    return max(len(path.relative_to(APP).parts) for path in paths)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--draw", type=Path, help="write the picture of the layers")
    add_record_option(parser)
    options = parser.parse_args()
    paths = modules()
    filled = rooms(paths)
    largest = max(filled, key=lambda folder: filled[folder])
    lengths = np.array(function_lengths(paths))
    print(
        f"{len(paths)} modules in {len(filled)} folders, up to {levels(paths)} levels; "
        f"largest room {largest.relative_to(ROOT)} with {filled[largest]}; "
        f"{len(lengths)} functions, median {np.median(lengths):.0f}, p90 {np.percentile(lengths, 90):.0f}, "
        f"longest {lengths.max()} lines"
    )
    for name, places in shared_names(paths).items():
        print(f"{name} stands in {', '.join(str(path.relative_to(ROOT)) for path in places)}")
    if options.record:
        record_figures(paths, filled, lengths)
    if options.draw:
        options.draw.write_text(picture(), encoding="utf-8")


if __name__ == "__main__":
    main()
