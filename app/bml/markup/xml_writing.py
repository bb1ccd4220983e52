"""Writes BML documents as XML that strict realizers accept (shared/bml.md).

UTF-8 without character references; every namespace is declared as the default where it begins, and only foreign
attributes have prefixes. Elements are on lines of their own, except next to text and outside the dialect, where white
space might be significant. Characters that XML cannot represent become U+FFFD.
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
    """The document as XML; deterministic."""
    kind = DIALECTS[document.dialect].roots[document.root.name]
    markup = "".join(_markup(document.root, kind, namespace="", margin="\n"))
    return f"<?xml version='1.0' encoding='UTF-8'?>\n{markup}\n".encode()


def _markup(element: Element, kind: ElementKind | None, *, namespace: str, margin: str) -> Iterator[str]:
    """The pieces of an element in a context with the default `namespace` and the indentation `margin`."""
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
    """The declarations of prefixes, then all attributes."""
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
    """Attributes in the order of the table, then all others."""
    if kind is None:
        return attributes
    return {name: attributes[name] for name in kind.attributes if name in attributes} | dict(attributes)


def _split(qualified: str) -> tuple[str, str]:
    """The namespace and local name of `{namespace}name`."""
    namespace, _, name = qualified.rpartition("}")
    return namespace.removeprefix("{"), name


def _quoted(text: str) -> str:
    return escape(_writable(text), {'"': "&quot;"})


def _writable(text: str) -> str:
    return _UNWRITABLE.sub("\ufffd", text)
