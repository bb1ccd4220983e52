"""Writes the kept behaviours of a performance as BML, in the requested dialect and time form (docs/references.md).

`understudy.bml.writing.blocks` and `understudy.bml.writing.smartbody` build the document; here it is written as XML
that strict realizers accept, or as JSON (docs/bml-json.md has the schema).

XML is UTF-8 without character references; every namespace is declared as the default where it begins, and only foreign
attributes have prefixes. Elements are on lines of their own, except next to text and outside the dialect, where white
space might be significant. Characters that XML cannot represent become U+FFFD.

In JSON an element is an object with the keys `element`, `attributes` and `content`, the last two only if not empty.
Numbers are numbers, a reference is an object, everything else is text.
"""

import json
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType

from ...model import Listening, Notice, Parse, Performance
from ...model.formats import CORE_FORM, BmlForm, DialectName, TimeForm
from ..markup.documents import Document, Element, Reference, Value
from ..markup.elements import DIALECTS, SBM, ElementKind
from ..markup.values import text_of
from .blocks import to_core
from .smartbody import left_out, safe, speech_file, to_smartbody
from .smartbody_tables import shipped_tables

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
            pieces.append(_escaped(part))
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
    return text if _PLAIN.fullmatch(text) else _escaped(text).replace('"', "&quot;")


def _escaped(text: str) -> str:
    """The text between tags. The standard library's `escape` would import its HTTP client too."""
    writable = _UNWRITABLE.sub("\ufffd", text)
    return writable.replace("&", "&amp;").replace(">", "&gt;").replace("<", "&lt;")


@dataclass(frozen=True, slots=True)
class SpeechFile:
    """The file that SmartBody requires in the folder of the recording."""

    name: str
    content: bytes

    @property
    def left_out(self) -> Notice:
        """The notice if the file cannot be written."""
        message = f"SmartBody needs {self.name} beside the recording; "
        return Notice("speech_file_left_out", message + "write to a file (-o act.xml), or ask the service for JSON")


def write_bml(performance: Performance, form: BmlForm = CORE_FORM) -> bytes:
    """The BML document as UTF-8 XML."""
    return to_xml(to_document(performance, form))


def listener_part(performance: Performance, listening: Listening) -> Performance:
    """A listener's behaviour as a performance of its own, in which nothing is said."""
    silent = replace(performance.utterance, words=(), parse=Parse((), (), ()))
    return Performance(silent, (), listening.behaviors, listening.name, performance.seed)


def write_listener(performance: Performance, listening: Listening, form: BmlForm) -> bytes:
    """A listener's BML. Its times are always absolute, because a listener has no speech whose sync points they could
    refer to."""
    return write_bml(listener_part(performance, listening), replace(form, timing=TimeForm.ABSOLUTE, audio_file=None))


def write_bml_json(performance: Performance, form: BmlForm = CORE_FORM) -> bytes:
    """The same document as UTF-8 JSON (docs/bml-json.md)."""
    return to_json(to_document(performance, form))


def write_speech_file(performance: Performance, form: BmlForm) -> SpeechFile | None:
    """NAME.bml with the times of words and visemes; None in BML 1.0, for a performance without words, and if the
    recording has no name."""
    name = speech_file_name(form)
    if name is None or not performance.utterance.words:
        return None
    return SpeechFile(name, to_xml(speech_file(performance, shipped_tables().visemes[form.visemes])))


def speech_file_name(form: BmlForm) -> str | None:
    """NAME.bml, if SmartBody's dialect needs it and the recording has a name."""
    named = form.dialect is DialectName.SMARTBODY and form.audio_name
    return f"{safe(named)}.bml" if named else None


def losses(performance: Performance, form: BmlForm) -> tuple[Notice, ...]:
    """Notices about what the form cannot express."""
    is_smartbody = form.dialect is DialectName.SMARTBODY
    return tuple(left_out(performance, form.audio_name, shipped_tables())) if is_smartbody else ()


def to_document(performance: Performance, form: BmlForm = CORE_FORM) -> Document:
    """The BML document as a value."""
    match form.dialect:
        case DialectName.BML:
            return to_core(performance, form.timing, form.audio_file if form.bmlt_audio else None)
        case DialectName.SMARTBODY:
            return to_smartbody(performance, form.timing, shipped_tables(), audio_name=form.audio_name)


Json = str | int | float | dict[str, "Json"] | list["Json"]


def to_json(document: Document) -> bytes:
    """The document as indented UTF-8 JSON; deterministic."""
    document_json: Json = {"dialect": document.dialect.value, "root": _element(document.root)}
    return json.dumps(document_json, ensure_ascii=False, indent=1).encode() + b"\n"


def _element(element: Element) -> Json:
    fields: dict[str, Json] = {"element": element.name}
    if element.attributes:
        fields["attributes"] = {name: _value(value) for name, value in element.attributes.items()}
    if element.content:
        fields["content"] = [part if isinstance(part, str) else _element(part) for part in element.content]
    return fields


def _value(value: Value) -> Json:
    if not isinstance(value, Reference):
        return value
    block: dict[str, Json] = {"block": value.block} if value.block else {}
    return {**block, "behavior": value.behavior, "point": value.point, "offset_s": value.offset_s}
