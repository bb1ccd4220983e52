"""Parses untrusted XML into elements with expanded names, attributes as text, and the position of every start tag.

UTF-8 only. A DOCTYPE is rejected immediately, so there are no entities but XML's own five and nothing is fetched; size
and depth are limited. Comments and processing instructions are ignored. SmartBody's `sbm:` is often used without a
declaration, which its own parser does not need: it is bound then.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from xml.parsers import expat

from .documents import Element, TagPosition
from .elements import BMLA, BMLT, SBM

_SEPARATOR = "}"

_UNBOUND_PREFIX = expat.errors.codes[expat.errors.XML_ERROR_UNBOUND_PREFIX]
_NAMESPACES: Mapping[str, str] = MappingProxyType({"sbm": SBM, "bmlt": BMLT, "bmla": BMLA})
"""The namespaces of usual prefixes."""

_BOUND = "sbm"
_PREFIX = re.compile(r"[\s<]([A-Za-z_][\w.-]*):[A-Za-z_]")
_XML_DECLARATION = re.compile(r"\A\s*<\?xml\s.*?\?>", re.DOTALL)


@dataclass(frozen=True, slots=True)
class ReadingLimits:
    """The maximum size of a BML file and depth of nesting."""

    max_bytes: int = 1024 * 1024
    max_depth: int = 32


class NotXmlError(Exception):
    """The bytes are not acceptable XML; caught by the reader, which knows the file's name."""

    def __init__(self, message: str, place: TagPosition) -> None:
        super().__init__(message)
        self.message = message
        self.place = place


@dataclass(frozen=True, slots=True)
class ParsedDocument:
    """The root element of a file with all its content; `is_bound` if `sbm:` had to be bound to its namespace."""

    root: Element
    is_bound: bool = False


class _UnboundPrefixError(NotXmlError):
    """A prefix is not declared."""


@dataclass(frozen=True, slots=True)
class _OpenElement:
    """An element whose end tag has not been reached."""

    name: str
    attributes: dict[str, str]
    content: list[Element | str]
    place: TagPosition


class _ElementBuilder:
    """Builds the elements from the parser's events."""

    def __init__(self, max_depth: int, *, lines_before: int = 0) -> None:
        self._max_depth = max_depth
        self._lines_before = lines_before
        self._open = [_OpenElement("", {}, [], TagPosition(1, 1))]
        self._parser = expat.ParserCreate(namespace_separator=_SEPARATOR)
        self._parser.buffer_text = True
        self._parser.StartDoctypeDeclHandler = self._refuse_doctype
        self._parser.StartElementHandler = self._start
        self._parser.EndElementHandler = self._end
        self._parser.CharacterDataHandler = self._text

    def build(self, text: str) -> Element:
        try:
            self._parser.Parse(text, True)
        except expat.ExpatError as error:
            place = TagPosition(error.lineno - self._lines_before, error.offset + 1)
            if error.code == _UNBOUND_PREFIX:
                raise _UnboundPrefixError("not well-formed XML: a prefix is not declared", place) from None
            raise NotXmlError(f"not well-formed XML: {expat.ErrorString(error.code)}", place) from None
        (root,) = self._open[0].content
        assert isinstance(root, Element)
        return root

    def _place(self) -> TagPosition:
        return TagPosition(self._parser.CurrentLineNumber - self._lines_before, self._parser.CurrentColumnNumber + 1)

    def _refuse_doctype(self, *_declaration: object) -> None:
        raise NotXmlError("BML has no DOCTYPE; leave it out", self._place())

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        if len(self._open) > self._max_depth:
            raise NotXmlError(f"elements nested more than {self._max_depth} deep", self._place())
        named = {_qualified(each): value for each, value in attributes.items()}
        self._open.append(_OpenElement(_qualified(name), named, [], self._place()))

    def _end(self, _name: str) -> None:
        done = self._open.pop()
        self._open[-1].content.append(Element(done.name, done.attributes, tuple(done.content), done.place))

    def _text(self, text: str) -> None:
        if len(self._open) > 1:
            self._open[-1].content.append(text.replace("\r", "\n"))


def parse(content: bytes, limits: ReadingLimits) -> ParsedDocument:
    """The file as elements. Raises NotXmlError. The caller must check the size."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        column = error.start - content.rfind(b"\n", 0, error.start)
        raise NotXmlError("not UTF-8; write BML in UTF-8", TagPosition(line, column)) from None
    try:
        return ParsedDocument(_ElementBuilder(limits.max_depth).build(text))
    except _UnboundPrefixError as error:
        if _prefix_at(text, error.place) != _BOUND:
            raise _with_remedy(error, text) from None
    try:
        return ParsedDocument(_with_bound_prefix(text, limits), is_bound=True)
    except _UnboundPrefixError as error:
        raise _with_remedy(error, text) from None


def _prefix_at(text: str, place: TagPosition) -> str | None:
    """The first prefix in the tag at a place that is not declared, as far as one can see; what is bound comes last."""
    lines = re.split(r"\r\n?|\n", text)[place.line - 1 :]
    tag = "\n".join([lines[0][place.column - 1 :], *lines[1:]]).partition(">")[0]
    names = [found[1] for found in _PREFIX.finditer(tag)]
    unbound = [name for name in names if not name.startswith("xml") and f"xmlns:{name}=" not in text]
    return next((name for name in unbound if name != _BOUND), _BOUND if unbound else None)


def _with_remedy(error: NotXmlError, text: str) -> NotXmlError:
    prefix = _prefix_at(text, error.place) or "PREFIX"
    remedy = f'declare it in the root element: xmlns:{prefix}="{_NAMESPACES.get(prefix, "its namespace")}"'
    return NotXmlError(f"{error.message}; {remedy}", error.place)


def _with_bound_prefix(text: str, limits: ReadingLimits) -> Element:
    """The file's root, read inside an element that declares the prefix."""
    whole = _XML_DECLARATION.sub(
        lambda found: "\n" * found[0].count("\n") + " " * len(found[0].rpartition("\n")[2]), text
    )
    around = f'<file xmlns:{_BOUND}="{_NAMESPACES[_BOUND]}">\n{whole}</file>'
    file = _ElementBuilder(limits.max_depth + 1, lines_before=1).build(around)
    roots = list(file.children)
    if len(roots) != 1:
        raise NotXmlError("not well-formed XML: there must be one root element", file.place or TagPosition(1, 1))
    return roots[0]


def _qualified(name: str) -> str:
    """`{namespace}name`, or the plain name if it has no namespace."""
    return f"{{{name}" if _SEPARATOR in name else name
