"""Parses untrusted XML into elements with expanded names, attributes as text, and the position of every start tag.

UTF-8 only. A DOCTYPE is rejected immediately, so there are no entities but XML's own five and nothing is fetched; size
and depth are limited. Comments and processing instructions are ignored.
"""

from dataclasses import dataclass
from xml.parsers import expat

from .documents import Element, Place

_SEPARATOR = "}"


@dataclass(frozen=True, slots=True)
class ReadingLimits:
    """The maximum size of a BML file and depth of nesting."""

    max_bytes: int = 1024 * 1024
    max_depth: int = 32


class NotXmlError(Exception):
    """The bytes are not acceptable XML; caught by the reader, which knows the file's name."""

    def __init__(self, message: str, place: Place) -> None:
        super().__init__(message)
        self.message = message
        self.place = place


@dataclass(frozen=True, slots=True)
class _Open:
    """An element whose end tag has not been reached."""

    name: str
    attributes: dict[str, str]
    content: list[Element | str]
    place: Place


class _Builder:
    """Builds the elements from the parser's events."""

    def __init__(self, max_depth: int) -> None:
        self._max_depth = max_depth
        self._open = [_Open("", {}, [], Place(1, 1))]
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
            raise NotXmlError(
                f"not well-formed XML: {expat.ErrorString(error.code)}", Place(error.lineno, error.offset + 1)
            ) from None
        (root,) = self._open[0].content
        assert isinstance(root, Element)
        return root

    def _place(self) -> Place:
        return Place(self._parser.CurrentLineNumber, self._parser.CurrentColumnNumber + 1)

    def _refuse_doctype(self, *_declaration: object) -> None:
        raise NotXmlError("BML has no DOCTYPE; leave it out", self._place())

    def _start(self, name: str, attributes: dict[str, str]) -> None:
        if len(self._open) > self._max_depth:
            raise NotXmlError(f"more than {self._max_depth} elements inside one another", self._place())
        named = {_qualified(each): value for each, value in attributes.items()}
        self._open.append(_Open(_qualified(name), named, [], self._place()))

    def _end(self, _name: str) -> None:
        done = self._open.pop()
        self._open[-1].content.append(Element(done.name, done.attributes, tuple(done.content), done.place))

    def _text(self, text: str) -> None:
        if len(self._open) > 1:
            self._open[-1].content.append(text.replace("\r", "\n"))


def parse(content: bytes, limits: ReadingLimits) -> Element:
    """The root element with all content. Raises NotXmlError. The caller must check the size."""
    try:
        text = content.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = content.count(b"\n", 0, error.start) + 1
        column = error.start - content.rfind(b"\n", 0, error.start)
        raise NotXmlError("not UTF-8; write BML in UTF-8", Place(line, column)) from None
    return _Builder(limits.max_depth).build(text)


def _qualified(name: str) -> str:
    """`{namespace}name`, or the plain name if it has no namespace."""
    return f"{{{name}" if _SEPARATOR in name else name
