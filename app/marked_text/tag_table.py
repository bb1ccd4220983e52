"""What tags of a text mean, read from `lexicon/tags.yaml`; every mistake in it is reported at once, with its place."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from ..errors import AuthoringError, Mistake, did_you_mean
from ..model import PLAIN
from ..yaml_files import Entry, Source

FILE = "tags.yaml"

Meanings = Mapping[str, Mapping[str, Mapping[str, str]]]


class _TagFile(Entry):
    """The file's schema: by tag, attribute and value, `class` or `class.subtype`."""

    functions: dict[str, dict[str, dict[str, str]]]


@dataclass(frozen=True, slots=True)
class TagTable:
    """The class and subtype of a function by tag, attribute and value."""

    meanings: Meanings

    @classmethod
    def load(cls, path: Path, classes: Mapping[str, Mapping[str, float]]) -> Self:
        """`classes` are the classes of functions with their subtypes. Raises AuthoringError with every mistake."""
        source = Source(path)
        meanings = source.validated(_TagFile).functions
        if mistakes := tuple(_wrong(source, meanings, {name: set(subtypes) for name, subtypes in classes.items()})):
            raise AuthoringError(mistakes)
        return cls(meanings)

    def functions_of(self, tag: str, attributes: Mapping[str, str]) -> Iterator[tuple[str, str]]:
        """The class and subtype of each function that a tag names; values count in any case."""
        for attribute, value in attributes.items():
            told = self.meanings.get(tag, {}).get(attribute, {}).get(value.strip().lower())
            if told is not None:
                yield _parts(told)


def _wrong(source: Source, meanings: Meanings, classes: Mapping[str, set[str]]) -> Iterator[Mistake]:
    for tag, attributes in meanings.items():
        for attribute, values in attributes.items():
            for value, told in values.items():
                name, subtype = _parts(told)
                where = ("functions", tag, attribute, value)
                if name not in classes:
                    yield source.mistake(where, f"no function has the class {name!r}{did_you_mean(name, classes)}")
                elif subtype not in classes[name]:
                    known = ", ".join(sorted(classes[name]))
                    yield source.mistake(where, f"{name} has no subtype {subtype!r}; there are {known}")


def _parts(told: str) -> tuple[str, str]:
    name, _, subtype = told.partition(".")
    return name, subtype or PLAIN
