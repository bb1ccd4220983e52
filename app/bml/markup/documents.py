"""The data model of BML documents: elements with typed attributes and mixed content.

An element of the document's dialect has its name in the table (`understudy.bml.markup.elements`), any other its
expanded name `{namespace}name`, with its attributes as text. Times are seconds from the start of the block, or
references to sync points of other behaviours. An element's position in a file is not part of its value.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType

from ...model.formats import DialectName


@dataclass(frozen=True, slots=True)
class Reference:
    """The time `offset_s` after the sync point `point` of `behavior`; `block` is set if that is in another block."""

    behavior: str
    point: str
    offset_s: float = 0.0
    block: str | None = None


Time = float | Reference
Value = str | int | float | Reference


@dataclass(frozen=True, slots=True)
class TagPosition:
    """The position of a start tag in a file; both count from 1."""

    line: int
    column: int


@dataclass(frozen=True, slots=True)
class Element:
    """A BML element. `content` has its child elements and texts in order."""

    name: str
    attributes: Mapping[str, Value] = field(default_factory=dict)
    content: tuple["Element | str", ...] = ()
    place: TagPosition | None = field(default=None, compare=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "attributes", MappingProxyType(dict(self.attributes)))

    @property
    def children(self) -> Iterator["Element"]:
        """The child elements, without text."""
        return (part for part in self.content if isinstance(part, Element))

    @property
    def id(self) -> str | None:
        """The value of the attribute `id`."""
        found = self.attributes.get("id")
        return found if isinstance(found, str) else None


@dataclass(frozen=True, slots=True)
class Document:
    """A document of one dialect; `root` is its root element."""

    dialect: DialectName
    root: Element
