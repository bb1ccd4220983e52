"""A BML document as a value: elements with typed attributes and, between them, text.

An element of the document's dialect goes by its name in the table (`understudy.bml.markup.elements`), any other by the
name that XML tools give it, `{namespace}name`, with its attributes as text. Times are seconds from the start of the
block, or references to what another behaviour reaches. Where an element stood in a file is no part of its value.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from types import MappingProxyType


class DialectName(StrEnum):
    """The dialects of BML that are read and written (shared/bml.md)."""

    BML = "bml"
    SMARTBODY = "smartbody"


class TimeForm(StrEnum):
    """How times are written: in seconds, or from the marks of the speech."""

    ABSOLUTE = "absolute"
    SYNC = "sync"


@dataclass(frozen=True, slots=True)
class Reference:
    """The time `offset_s` after `behavior` reaches `point`; `block` is given when the behaviour is in another block."""

    behavior: str
    point: str
    offset_s: float = 0.0
    block: str | None = None


Time = float | Reference
Value = str | int | float | Reference


@dataclass(frozen=True, slots=True)
class Place:
    """Where a start tag begins in a file; both count from 1."""

    line: int
    column: int


@dataclass(frozen=True, slots=True)
class Element:
    """A BML element. `content` holds the elements and texts inside it, in order."""

    name: str
    attributes: Mapping[str, Value] = field(default_factory=dict)
    content: tuple["Element | str", ...] = ()
    place: Place | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "attributes", MappingProxyType(dict(self.attributes)))

    @property
    def children(self) -> Iterator["Element"]:
        """The elements inside, without the text between them."""
        return (part for part in self.content if isinstance(part, Element))

    @property
    def id(self) -> str | None:
        found = self.attributes.get("id")
        return found if isinstance(found, str) else None


@dataclass(frozen=True, slots=True)
class Document:
    """A document of one dialect; `root` is its outermost element."""

    dialect: DialectName
    root: Element
