"""Lists gestures for people: one a line, counted by category, or explained."""

from collections.abc import Iterable, Iterator, Sequence
from pathlib import Path

from ...authoring.gesture_views import Definition, Library, clips_by_level, place_of
from ...model import Hand, Level

_FACTORS = ("amplitude", "tempo", "fluidity", "power", "repetition")
_MARKERS = ("ready", "stroke_start", "stroke", "stroke_end", "relax", "end")


def headline(definition: Definition) -> str:
    arms = definition.hand or "one"
    levels = "" if len(definition.levels) == len(Level) else f" ({', '.join(definition.levels)})"
    shows = ", ".join(definition.categories) + (" at a target" if definition.aimed else "") + levels
    return f"{definition.name:32s} {definition.gesture_class:11s} {arms:6s} {shows:40s} {place_of(definition)}"


def counts(library: Library) -> Iterator[str]:
    """How many gestures each category has, for one hand and for both."""
    yield f"{'category':32s}{'one hand':>10s}{'both':>10s}"
    for category, definitions in library.by_category.items():
        both = sum(one.hand is Hand.BOTH for one in definitions)
        yield f"{category:32s}{len(definitions) - both or '':>10}{both or '':>10}"
    yield f"{len(library.categories)} categories, {len(library.definitions)} gestures"


def explanation(definition: Definition) -> Iterator[str]:
    """A gesture as in its file, with its expressivity and times at each level."""
    yield f"{definition.name}: {place_of(definition)}"
    yield from (f"    {line}" for line in _source(definition))
    yield f"  {'':8s}" + "".join(f"{name:>13s}" for name in (*_FACTORS, "stroke m/s"))
    clips = clips_by_level(definition)
    for one in clips:
        factors = [getattr(one.expressivity, name) for name in _FACTORS]
        yield f"  {one.level:8s}" + _numbers([*factors, one.stroke_speed_m_s])
    yield f"  {'':8s}" + "".join(f"{name + ' s':>15s}" for name in _MARKERS)
    for one in clips:
        yield f"  {one.level:8s}" + "".join(f"{getattr(one.markers, name):15.3f}" for name in _MARKERS)


def _numbers(values: Iterable[float]) -> str:
    return "".join(f"{value:13.2f}" for value in values)


def _source(definition: Definition) -> Sequence[str]:
    """The gesture's lines in its file, with the comment directly above them."""
    lines = _lines(definition.path)
    first = definition.line - 1
    last = next((k for k in range(first + 1, len(lines)) if lines[k].startswith("GESTURECLASS")), len(lines))
    while first > 0 and lines[first - 1].lstrip().startswith("#"):
        first -= 1
    while last > first and (not lines[last - 1].strip() or lines[last - 1].lstrip().startswith("#")):
        last -= 1
    return lines[first:last]


def _lines(path: Path | None) -> Sequence[str]:
    return path.read_text(encoding="utf-8-sig").splitlines() if path else ()
