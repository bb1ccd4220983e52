"""How often the slots of words are right (docs/slots.md), on written cases, by kind.

    python -m benchmarks.behavior.slots [--errors] [--only shown|blind|fresh|later|again|last]

The cases stand in benchmarks/behavior/slots.yaml: on those `shown` the patterns were mended; 75 `blind` ones were
written after the first patterns and 150 `fresh` ones before these were widened a first time. The `later` ones were
written when they had been widened again by what the blind part missed; what those missed in turn was then added as
general classes. It was done so twice more: 40 cases `again`, and 40 when what these missed was added, the `last`, whose
score at first sight counts (docs/measurements/understanding.md); none is blind now. A case asks for one slot of some
words of a line; it is right if the value is, or if there is none where none is wanted.
"""

import argparse
from collections import defaultdict
from collections.abc import Iterator
from pathlib import Path
from typing import Literal

from pydantic import Field

from understudy.behavior.slots.findings import Finding
from understudy.behavior.slots.gestures import slots_of, slots_said
from understudy.behavior.slots.table import SlotTable
from understudy.models import LanguageModels, load_characters, load_families, load_slots
from understudy.rules.stage import find_functions
from understudy.settings import Settings
from understudy.yaml_files import Entry, Source

CASES = Path(__file__).with_suffix(".yaml")
LISTENERS = ("anna", "tom")
PARTS = ("shown", "blind", "fresh", "later", "again", "last")


class Case(Entry):
    """What words of a line should say."""

    text: str
    at: str
    ask: Literal["height", "size", "count", "side", "distance", "elevation", "which", "referent", "listener"]
    right: str = Field(alias="is")

    @property
    def span(self) -> tuple[int, int]:
        """The first and last word of `at`."""
        words, part = self.text.split(), self.at.split()
        starts = (
            start
            for start in range(len(words))
            if [each.strip(",.!?;:").lower() for each in words[start : start + len(part)]]
            == [each.strip(",.!?;:").lower() for each in part]
        )
        first = next(starts)
        return first, first + len(part) - 1


class Cases(Entry):
    """The file."""

    shown: tuple[Case, ...]
    blind: tuple[Case, ...] = ()
    fresh: tuple[Case, ...] = ()
    later: tuple[Case, ...] = ()
    again: tuple[Case, ...] = ()
    last: tuple[Case, ...] = ()


def said(language: LanguageModels, table: SlotTable, text: str) -> tuple[Finding, ...]:
    """What the words of a line say."""
    analysis = find_functions(language, text)
    return slots_said(table, analysis.utterance, analysis.functions, LISTENERS)


def answer(language: LanguageModels, table: SlotTable, case: Case) -> str:
    """What we say of a case."""
    slots = slots_of(table, said(language, table, case.text), *case.span)
    if case.ask == "elevation":
        degrees = slots.elevation_deg
        return "none" if degrees is None else "up" if degrees > 0 else "down"
    value = getattr(slots, case.ask)
    return "none" if value is None else str(value)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--errors", action="store_true", help="print what is wrong")
    parser.add_argument("--only", choices=PARTS)
    arguments = parser.parse_args()
    language = LanguageModels.load(Settings())
    table = load_slots(load_families(load_characters()))
    cases = Source(CASES).validated(Cases)
    for part in (arguments.only,) if arguments.only else PARTS:
        print("\n".join(_report(part, getattr(cases, part), language, table, errors=arguments.errors)))


def _report(
    part: str, cases: tuple[Case, ...], language: LanguageModels, table: SlotTable, *, errors: bool
) -> Iterator[str]:
    right: dict[str, list[bool]] = defaultdict(list)
    for case in cases:
        told = answer(language, table, case)
        right[case.ask].append(told == case.right)
        if errors and told != case.right:
            yield f"  {case.ask}: {told}, not {case.right}, for {case.at!r} in {case.text!r}"
    right["all"] = [each for answers in right.values() for each in answers]
    for kind, results in right.items():
        yield f"{part:6} {kind:10} {sum(results):3} of {len(results):3}  {sum(results) / max(1, len(results)):.3f}"


if __name__ == "__main__":
    main()
