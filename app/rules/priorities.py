"""The existing functions, by class and subtype, and their base priorities before rules raise them (paper §3.3).

`functions/priorities.yaml` is the single table of both: functions that are not in it are mistakes wherever they are
named.
"""

from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Annotated

from pydantic import ConfigDict, Field, RootModel

from ..errors import LONGEST_SHOWN, Mistake
from ..model import Fact
from ..suggestions import did_you_mean
from ..yaml_files import Source
from .lexicon import LexicalEntry
from .program.program import Rule

Priority = Annotated[float, Field(gt=0, le=100)]


class Priorities(RootModel[Mapping[str, Mapping[str, Priority]]]):
    """The table: class to subtype to priority; higher is more important."""

    model_config = ConfigDict(frozen=True)

    @classmethod
    def load(cls, path: Path) -> "Priorities":
        """Raises AuthoringError with every mistake in the table."""
        return Source(path).validated(cls)

    def facts(self) -> Iterator[Fact]:
        """The table as facts, for the rules that raise priorities."""
        for class_name, subtypes in self.root.items():
            for subtype, priority in subtypes.items():
                yield Fact("base_priority", (class_name, subtype, priority))

    def unknown(self, class_name: str, subtype: str) -> str | None:
        """The message that there is no function of this class and subtype, with the known ones; None if there is
        one."""
        if class_name not in self.root:
            return f"no function has the class {class_name[:LONGEST_SHOWN]}{_meant(class_name, self.root)}"
        known = self.root[class_name]
        if subtype not in known:
            return f"{class_name} has no subtype {subtype[:LONGEST_SHOWN]}; its subtypes are {', '.join(known)}"
        return None

    def mistakes_in_rules(self, rules: Iterable[Rule]) -> Iterator[Mistake]:
        """Mistakes for rules that assert functions that are not in the table, where class and subtype are constants."""
        for rule in rules:
            for mention in rule.asserts:
                class_name, subtype = mention.arguments[:2] if mention.predicate == "fcn" else ("$", "$")
                reason = None if "$" in class_name + subtype else self.unknown(class_name, subtype)
                if reason:
                    yield Mistake(rule.path, rule.line, 1, f"rule {rule.name}: {reason}; priorities.yaml lists them")

    def mistakes_in_words(self, entries: Iterable[LexicalEntry]) -> Iterator[Mistake]:
        """Mistakes for words of a function class whose subtype the class does not have."""
        for entry in entries:
            if entry.subtype is not None and entry.subtype not in self.root.get(entry.class_name, {entry.subtype: 0}):
                yield Mistake(entry.path, entry.line, 1, f"{self.unknown(entry.class_name, entry.subtype)}")


def _meant(name: str, known: Iterable[str]) -> str:
    names = tuple(known)
    return did_you_mean(name, names, otherwise=f"; the classes are {', '.join(names)}")
