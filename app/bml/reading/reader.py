"""Reads BML 1.0 core or SmartBody's dialect, identified by the root, from XML, with the place of every mistake.

In the core, every name in its namespaces must be known. Elements and attributes of other namespaces are extensions,
which are kept and reported; in SmartBody's dialect, which has many more names than we know, this holds for all unknown
names. White space between elements is ignored, runs of it in attributes count as one space. The content of a
`description` is not checked.
"""

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from itertools import islice
from pathlib import Path

from ...errors import Mistake, TooLargeError, WrongBmlError
from ...model import Notice
from ..markup.documents import Document, Element, TagPosition, Value
from ..markup.elements import DIALECTS, OURS, SBM, Dialect, ElementKind
from ..markup.mistakes import is_foreign, kind_of, local_name, mistakes_of, typed_attributes
from ..markup.parsing import NotXmlError, ParsedDocument, ReadingLimits, parse
from .greta import in_core_bml
from .moved_points import with_following_points

MOST_MISTAKES = 100
"""The maximum number of reported mistakes, and of foreign names, per file."""

_MOST_IN_MESSAGE = 5
_XML_LINE_END = re.compile(r"\r\n?|\n")
_DEFAULT_LIMITS = ReadingLimits()


def read_bml(
    content: bytes, path: Path, limits: ReadingLimits = _DEFAULT_LIMITS
) -> tuple[Document, tuple[Notice, ...]]:
    """The document, and Notices: `bml_point_moved` for every behaviour of ours of which a point was moved by hand,
    `bml_foreign` for every name that is not in its dialect, `bml_namespace` where a prefix was bound, and what was
    changed to read Greta's.

    `path` names the file in messages. Raises WrongBmlError `bml_wrong` with all mistakes, and TooLargeError
    `bml_too_large`.
    """
    parsed = _parsed(content, path, limits)
    root, translated = in_core_bml(parsed.root)
    found = _dialect_of(root)
    if found is None:
        message = f"the outermost element is <{root.name[:100]}>; write <bml> of BML 1.0, or SmartBody's <act>"
        raise _wrong_bml(content, path, [(root.place or TagPosition(1, 1), message)])
    dialect, kind = found
    root, moves = with_following_points(root, kind)
    mistakes = list(islice(mistakes_of(root, kind, dialect), MOST_MISTAKES))
    if mistakes:
        raise _wrong_bml(content, path, mistakes)
    notices = (*translated, *_bound(parsed), *moves, *_foreign(root, kind, dialect))
    return Document(dialect.name, _element(root, kind)), notices


def _parsed(content: bytes, path: Path, limits: ReadingLimits) -> ParsedDocument:
    if len(content) > limits.max_bytes:
        message = f"{path}: {len(content)} bytes of BML; no more than {limits.max_bytes} are read"
        raise TooLargeError("bml_too_large", message, field="bml")
    try:
        return parse(content, limits)
    except NotXmlError as error:
        raise _wrong_bml(content, path, [(error.place, error.message)]) from None


def _bound(parsed: ParsedDocument) -> Iterator[Notice]:
    if parsed.is_bound:
        message = f'sbm: is not declared; it is taken as SmartBody\'s: write xmlns:sbm="{SBM}" in the outermost element'
        yield Notice("bml_namespace", message)


def _dialect_of(root: Element) -> tuple[Dialect, ElementKind] | None:
    kinds = ((dialect, dialect.roots.get(local_name(root.name))) for dialect in DIALECTS.values())
    return next(((dialect, kind) for dialect, kind in kinds if kind and kind.qualified == root.name), None)


def _element(element: Element, kind: ElementKind | None) -> Element:
    """The element with typed attribute values and its name in the table."""
    if kind is None or kind.free:
        parts = tuple(
            part if isinstance(part, str) else _element(part, kind_of(part, kind) if kind else None)
            for part in element.content
        )
    else:
        parts = tuple(_content(element, kind))
    if kind is None:
        return Element(element.name, _single_spaced(element.attributes), parts, element.place)
    attributes = typed_attributes(element, kind)
    others = {name: text for name, text in element.attributes.items() if name not in kind.attributes}
    return Element(kind.name, attributes | _single_spaced(others), parts, element.place)


def _content(element: Element, kind: ElementKind) -> Iterator[Element | str]:
    speaks = any(isinstance(part, str) and part.strip() for part in element.content)
    for part in element.content:
        if isinstance(part, Element):
            yield _element(part, kind_of(part, kind))
        elif speaks:
            yield part


def _single_spaced(attributes: Mapping[str, Value]) -> dict[str, Value]:
    return {name: " ".join(str(text).split()) for name, text in attributes.items()}


def _foreign(root: Element, kind: ElementKind, dialect: Dialect) -> tuple[Notice, ...]:
    """A notice for each foreign name, with the line of its first occurrence."""
    met = list(_foreign_names(root, kind, dialect))
    counts = Counter(name for name, _ in met)
    lines = {name: place.line for name, place in reversed(met)}
    return tuple(
        Notice(
            "bml_foreign", f"{name} (line {lines[name]}, {count} in all) is not of {dialect.title}; it is kept as it is"
        )
        for name, count in counts.most_common(MOST_MISTAKES)
    )


def _foreign_names(element: Element, kind: ElementKind, dialect: Dialect) -> Iterator[tuple[str, TagPosition]]:
    place = element.place or TagPosition(1, 1)
    for name in element.attributes:
        if name not in kind.attributes and is_foreign(name, dialect):
            yield f"the attribute {name}", place
    for name, attribute in kind.attributes.items():
        if attribute.one_of and name in element.attributes and element.attributes[name] not in attribute.one_of:
            yield f"{name}={element.attributes[name]!r}", place
    if kind.free:
        return
    for part in element.children:
        inside = kind_of(part, kind)
        if inside:
            yield from _foreign_names(part, inside, dialect)
        elif not part.name.startswith(f"{{{OURS}}}"):
            yield f"<{part.name}>", part.place or place


def _wrong_bml(content: bytes, path: Path, found: list[tuple[TagPosition, str]]) -> WrongBmlError:
    lines = _XML_LINE_END.split(content.decode(errors="replace"))
    mistakes = tuple(
        Mistake(path, place.line, place.column, message, lines[place.line - 1].replace("\t", " "))
        for place, message in found
    )
    told = "; ".join(f"line {mistake.line}: {mistake.message}" for mistake in mistakes[:_MOST_IN_MESSAGE])
    more = f"; and {len(mistakes) - _MOST_IN_MESSAGE} more" if len(mistakes) > _MOST_IN_MESSAGE else ""
    return WrongBmlError("bml_wrong", f"{path}: {told}{more}", mistakes=mistakes)
