"""The figures of docs/measurements: benchmarks record them as JSON, and the tables of the pages are made from that.

A benchmark that takes `--record` calls `record` once a figure; the entry is written to
docs/measurements/figures/AREA.json with the command that was run, the commit and the date, in place of an earlier one
of that name. `python -m benchmarks.figures` writes the tables into the pages, between `<!-- figures: AREA -->` and
`<!-- end of figures -->`; a test compares pages and JSON.
"""

import argparse
import datetime
import json
import operator
import re
import shlex
import subprocess
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field, TypeAdapter

ROOT = Path(__file__).resolve().parents[1]
PAGES = ROOT / "docs" / "measurements"

_BOUND = r"^(≥|≤|=) -?\d+(\.\d+)?$"
_COMPARISONS: dict[str, Callable[[float, float], bool]] = {"≥": operator.ge, "≤": operator.le, "=": operator.eq}
_TABLE = re.compile(r"(<!-- figures: (\w+) -->\n).*?(<!-- end of figures -->)", re.DOTALL)
_HEADING = (
    "| figure | value | bar | aim | command | commit | date |",
    "|---|---|---|---|---|---|---|",
)


class Figure(BaseModel):
    """One measured figure: `bar` is what it must reach and `aim` what we want, each such as "≥ 0.6"."""

    model_config = ConfigDict(frozen=True, extra="forbid")

    name: Annotated[str, Field(min_length=3, pattern=r"^[^|\n]+$")]
    value: float
    unit: str = ""
    bar: Annotated[str, Field(pattern=_BOUND)] | None = None
    aim: Annotated[str, Field(pattern=_BOUND)] | None = None
    command: str
    commit: str
    """Short hash; with "+" if the tree held changes that were not in it."""
    date: datetime.date

    @property
    def falls_short(self) -> bool:
        """Whether the value does not reach its bar."""
        if self.bar is None:
            return False
        relation, bound = self.bar.split(" ")
        return not _COMPARISONS[relation](self.value, float(bound))


_FIGURES = TypeAdapter(tuple[Figure, ...])


def add_record_option(parser: argparse.ArgumentParser) -> None:
    """`--record`, for a benchmark that records its figures."""
    parser.add_argument("--record", action="store_true", help="keep the figures in docs/measurements")


def record(
    area: str, name: str, value: float, unit: str = "", *, bar: str | None = None, aim: str | None = None
) -> None:
    """Writes a figure of the running benchmark into its area's JSON, in place of an earlier one of that name."""
    figure = Figure(
        name=name,
        value=float(f"{value:.4g}"),
        unit=unit,
        bar=bar,
        aim=aim,
        command=_own_command(),
        commit=_commit(),
        date=datetime.datetime.now(tz=datetime.UTC).date(),
    )
    others = [each for each in read(area) if each.name != name] if _path(area).exists() else []
    write(area, [*others, figure])


def read(area: str) -> tuple[Figure, ...]:
    """The figures of an area, by name."""
    return _FIGURES.validate_json(_path(area).read_bytes())


def write(area: str, figures: Sequence[Figure]) -> None:
    """The area's JSON, a figure a line, so that two who record different figures seldom meet."""
    rows = [
        json.dumps(each.model_dump(mode="json", exclude_none=True), ensure_ascii=False)
        for each in sorted(figures, key=lambda each: each.name)
    ]
    _path(area).write_text("[\n" + ",\n".join(rows) + "\n]\n", encoding="utf-8")


def areas() -> tuple[str, ...]:
    """The areas that have figures."""
    return tuple(sorted(path.stem for path in (PAGES / "figures").glob("*.json")))


def table(figures: Sequence[Figure]) -> str:
    """The figures as a table of Markdown; a value that does not reach its bar is in bold."""
    return "\n".join([*_HEADING, *map(_row, figures), ""])


def with_tables(page: str) -> str:
    """The text of a page with the tables of its areas as the JSON has them."""
    return _TABLE.sub(lambda found: f"{found[1]}\n{table(read(found[2]))}\n{found[3]}", page)


def pages() -> tuple[Path, ...]:
    """The pages of the measurements."""
    return tuple(sorted(PAGES.glob("*.md")))


def _row(figure: Figure) -> str:
    value = f"{figure.value:g} {figure.unit}".rstrip()
    shown = f"**{value}**" if figure.falls_short else value
    command = f"`{figure.command}`".replace("|", "\\|")
    return (
        f"| {figure.name} | {shown} | {figure.bar or ''} | {figure.aim or ''} | {command} "
        f"| {figure.commit} | {figure.date} |"
    )


def _path(area: str) -> Path:
    return PAGES / "figures" / f"{area}.json"


def _own_command() -> str:
    """The command that runs this process, without `--record`."""
    specification = sys.modules["__main__"].__spec__
    name = specification.name.removesuffix(".__main__") if specification else Path(sys.argv[0]).name
    arguments = [each for each in sys.argv[1:] if each != "--record"]
    return shlex.join(["python", "-m", name, *arguments])


def _commit() -> str:
    """The last commit that main has too (branches are rebased), with "+" for what the tree has beside it."""
    base = _git("merge-base", "HEAD", "main") or _git("rev-parse", "HEAD")
    changed = base != _git("rev-parse", "HEAD") or _git("status", "--porcelain", "--untracked-files=no")
    return base[:8] + ("+" if changed else "")


def _git(*arguments: str) -> str:
    """What git answers, or nothing where it refuses."""
    found = subprocess.run(["git", *arguments], cwd=ROOT, capture_output=True, text=True, check=False)
    return found.stdout.strip() if found.returncode == 0 else ""


def main() -> None:
    """Writes the tables of all pages."""
    argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter).parse_args()
    for page in pages():
        text = page.read_text(encoding="utf-8")
        if (made := with_tables(text)) != text:
            page.write_text(made, encoding="utf-8")
            print(f"wrote {page.relative_to(ROOT)}")


if __name__ == "__main__":
    main()
