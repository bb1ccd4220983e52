"""Writes BML documents as XML that strict realizers accept (docs/references.md).

UTF-8 without character references; every namespace is declared as the default where it begins, and only foreign
attributes have prefixes. Elements are on lines of their own, except next to text and outside the dialect, where white
space might be significant. Characters that XML cannot represent become U+FFFD.
"""

import re
from collections.abc import Mapping
from types import MappingProxyType
from xml.sax.saxutils import escape

from .documents import Document, Element, Value
from .elements import DIALECTS, SBM, ElementKind
from .values import text_of

_PREFIXES: Mapping[str, str] = MappingProxyType({"http://www.w3.org/XML/1998/namespace": "xml", SBM: "sbm"})
_UNWRITABLE = re.compile("[^\t\n\x20-\ud7ff\ue000-\ufffd\U00010000-\U0010ffff]")
_PLAIN = re.compile("[\x20!#-%'-;=?-~]*")
"""What needs neither escape nor replacement, as nearly all that is written."""

_INDENT = "  "


def to_xml(document: Document) -> bytes:
    """The document as XML; deterministic."""
    kind = DIALECTS[document.dialect].roots[document.root.name]
    pieces: list[str] = []
    _write(pieces, document.root, kind, namespace="", margin="\n")
    return f"<?xml version='1.0' encoding='UTF-8'?>\n{''.join(pieces)}\n".encode()


def _write(pieces: list[str], element: Element, kind: ElementKind | None, *, namespace: str, margin: str) -> None:
    """Appends the pieces of an element in a context with the default `namespace` and the indentation `margin`."""
    own_namespace, name = (kind.namespace, kind.name) if kind else _split(element.name)
    declared = f' xmlns="{_quoted(own_namespace)}"' if own_namespace != namespace else ""
    pieces.append(f"<{name}{declared}{_attributes(element, kind)}")
    if not element.content:
        pieces.append("/>")
        return
    pieces.append(">")
    in_lines = kind is not None and not kind.free and not any(isinstance(part, str) for part in element.content)
    for part in element.content:
        if isinstance(part, str):
            pieces.append(escape(_writable(part)))
        else:
            pieces.append(margin + _INDENT if in_lines else "")
            inside = kind.parts.get(part.name) if kind else None
            _write(pieces, part, inside, namespace=own_namespace, margin=margin + _INDENT)
    pieces.append(f"{margin if in_lines else ''}</{name}>")


def _attributes(element: Element, kind: ElementKind | None) -> str:
    """The declarations of prefixes, then all attributes."""
    ordered = _in_order(element.attributes, kind)
    if not any(name[0] == "{" for name in ordered):
        return "".join([f' {name}="{_quoted(text_of(value))}"' for name, value in ordered.items()])
    namespaces = dict.fromkeys(_split(name)[0] for name in ordered if name[0] == "{")
    prefixes = {each: _PREFIXES.get(each, f"ns{number}") for number, each in enumerate(namespaces, start=1)}
    pieces = [f' xmlns:{prefix}="{_quoted(each)}"' for each, prefix in prefixes.items() if prefix != "xml"]
    for qualified, value in ordered.items():
        namespace, name = _split(qualified)
        prefix = f"{prefixes[namespace]}:" if namespace else ""
        pieces.append(f' {prefix}{name}="{_quoted(text_of(value))}"')
    return "".join(pieces)


def _in_order(attributes: Mapping[str, Value], kind: ElementKind | None) -> Mapping[str, Value]:
    """Attributes in the order of the table, then all others."""
    if kind is None:
        return attributes
    return {name: attributes[name] for name in kind.attributes if name in attributes} | dict(attributes)


def _split(qualified: str) -> tuple[str, str]:
    """The namespace and local name of `{namespace}name`."""
    if qualified[0] != "{":
        return "", qualified
    namespace, _, name = qualified[1:].rpartition("}")
    return namespace, name


def _quoted(text: str) -> str:
    return text if _PLAIN.fullmatch(text) else escape(_writable(text), {'"': "&quot;"})


def _writable(text: str) -> str:
    return _UNWRITABLE.sub("\ufffd", text)
