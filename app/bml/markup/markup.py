"""A BML document as XML in the form that strict realizers read (shared/bml.md).

UTF-8 without character references; every namespace is the default one where it begins, and only foreign attributes
have prefixes. Elements stand each on a line of its own, but where text is among them or they are not of the dialect:
white space might mean something there. Characters that XML cannot hold become U+FFFD.
"""

import re
from collections.abc import Iterator, Mapping
from types import MappingProxyType
from xml.sax.saxutils import escape

from .documents import Document, Element, Value
from .elements import DIALECTS, SBM, ElementKind
from .values import text_of

_PREFIXES: Mapping[str, str] = MappingProxyType({"http://www.w3.org/XML/1998/namespace": "xml", SBM: "sbm"})
_UNWRITABLE = re.compile("[^\t\n\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_INDENT = "  "


def to_xml(document: Document) -> bytes:
    """The document as XML; the same document gives the same bytes."""
    kind = DIALECTS[document.dialect].roots[document.root.name]
    markup = "".join(_markup(document.root, kind, namespace="", margin="\n"))
    return f"<?xml version='1.0' encoding='UTF-8'?>\n{markup}\n".encode()


def _markup(element: Element, kind: ElementKind | None, *, namespace: str, margin: str) -> Iterator[str]:
    """The pieces of an element whose surroundings have the default `namespace` and begin new lines with `margin`."""
    own_namespace, name = _split(kind.qualified if kind else element.name)
    yield f"<{name}"
    if own_namespace != namespace:
        yield f' xmlns="{_quoted(own_namespace)}"'
    yield from _attributes(element, kind)
    if not element.content:
        yield "/>"
        return
    yield ">"
    in_lines = kind is not None and not kind.free and not any(isinstance(part, str) for part in element.content)
    for part in element.content:
        if isinstance(part, str):
            yield escape(_writable(part))
        else:
            yield margin + _INDENT if in_lines else ""
            inside = kind.parts.get(part.name) if kind else None
            yield from _markup(part, inside, namespace=own_namespace, margin=margin + _INDENT)
    yield margin if in_lines else ""
    yield f"</{name}>"


def _attributes(element: Element, kind: ElementKind | None) -> Iterator[str]:
    """The prefixes of foreign attributes, then all attributes."""
    ordered = _in_order(element.attributes, kind)
    namespaces = dict.fromkeys(namespace for namespace, _ in map(_split, ordered) if namespace)
    prefixes = {each: _PREFIXES.get(each, f"ns{number}") for number, each in enumerate(namespaces, start=1)}
    for namespace, prefix in prefixes.items():
        yield "" if prefix == "xml" else f' xmlns:{prefix}="{_quoted(namespace)}"'
    for qualified, value in ordered.items():
        namespace, name = _split(qualified)
        yield f' {prefixes[namespace]}:{name}="' if namespace else f' {name}="'
        yield f'{_quoted(text_of(value))}"'


def _in_order(attributes: Mapping[str, Value], kind: ElementKind | None) -> Mapping[str, Value]:
    """Those of the table in its order, then the others."""
    if kind is None:
        return attributes
    return {name: attributes[name] for name in kind.attributes if name in attributes} | dict(attributes)


def _split(qualified: str) -> tuple[str, str]:
    """Namespace and local name of `{namespace}name`."""
    namespace, _, name = qualified.rpartition("}")
    return namespace.removeprefix("{"), name


def _quoted(text: str) -> str:
    return escape(_writable(text), {'"': "&quot;"})


def _writable(text: str) -> str:
    return _UNWRITABLE.sub("\ufffd", text)
