"""What tags of a text mean, read from `lexicon/tags.yaml`; every mistake in it is reported at once, with its place."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from pydantic import Field

from ..errors import AuthoringError, Mistake, did_you_mean
from ..model import PLAIN
from ..yaml_files import Entry, Source

FILE = "tags.yaml"

Meanings = Mapping[str, Mapping[str, Mapping[str, str]]]


class _TagFile(Entry):
    """The file's schema: by tag, attribute and value, or by tag alone, `class` or `class.subtype`."""

    functions: dict[str, dict[str, dict[str, str]]]
    by_name: dict[str, str] = Field(default_factory=dict)


@dataclass(frozen=True, slots=True)
class TagTable:
    """The class and subtype of a function by tag, attribute and value, and by the tag's name alone."""

    meanings: Meanings
    by_name: Mapping[str, str]

    @classmethod
    def load(cls, path: Path, classes: Mapping[str, Mapping[str, float]]) -> Self:
        """`classes` are the classes of functions with their subtypes. Raises AuthoringError with every mistake."""
        source = Source(path)
        file = source.validated(_TagFile)
        if mistakes := tuple(_wrong(source, file, {name: set(subtypes) for name, subtypes in classes.items()})):
            raise AuthoringError(mistakes)
        return cls(file.functions, file.by_name)

    def functions_of(self, tag: str, attributes: Mapping[str, str]) -> Iterator[tuple[str, str]]:
        """The class and subtype of each function that a tag's attributes name; values count in any case."""
        for attribute, value in attributes.items():
            meaning = self.meanings.get(tag, {}).get(attribute, {}).get(value.strip().lower())
            if meaning is not None:
                yield _parts(meaning)

    def function_named(self, tag: str) -> tuple[str, str] | None:
        """The class and subtype of the function that a tag names whatever its attributes are."""
        return _parts(self.by_name[tag]) if tag in self.by_name else None


def _wrong(source: Source, file: _TagFile, classes: Mapping[str, set[str]]) -> Iterator[Mistake]:
    for where, told in _told(file):
        name, subtype = _parts(told)
        if name not in classes:
            yield source.mistake(where, f"no function has the class {name!r}{did_you_mean(name, classes)}")
        elif subtype not in classes[name]:
            known = ", ".join(sorted(classes[name]))
            yield source.mistake(where, f"{name} has no subtype {subtype!r}; there are {known}")


def _told(file: _TagFile) -> Iterator[tuple[tuple[str, ...], str]]:
    """Everything that the file says, with its place there."""
    for tag, attributes in file.functions.items():
        for attribute, values in attributes.items():
            for value, told in values.items():
                yield ("functions", tag, attribute, value), told
    for tag, told in file.by_name.items():
        yield ("by_name", tag), told


def _parts(text: str) -> tuple[str, str]:
    name, _, subtype = text.partition(".")
    return name, subtype or PLAIN
