"""Greta's BML in its old namespace as BML 1.0 core, with the places of its elements.

It differs from the core in names (`character`, `tm` for the marks of a speech, `lexeme` inside a `face`), has ids
twice, and times before the start of the speech, for which the whole block comes later. What the core does not know
keeps the old namespace, and is reported as all that is foreign.
"""

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from types import MappingProxyType

from ...model import Notice
from ...model.targets import LISTENER
from ..markup.documents import Element
from ..markup.elements import BML_CORE, CORE, ElementKind
from ..markup.mistakes import local_name
from ..markup.values import text_of, value_of

GRETA = "http://www.mindmakers.org/projects/BML"

_BLOCK = BML_CORE.roots["bml"]
_COMPOSITIONS: Mapping[str, str] = MappingProxyType({"blend": "MERGE", "append": "APPEND", "replace": "REPLACE"})
_MARKS = frozenset({"tm", "sync"})
_NOT_IN_IDS = re.compile(r"[^A-Za-z0-9_.]")
_SECONDS = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)", re.ASCII)


def in_core_bml(root: Element) -> tuple[Element, tuple[Notice, ...]]:
    """The document in the core's names if it is Greta's, and what was changed; any other unchanged."""
    if root.name != f"{{{GRETA}}}bml":
        return root, ()
    parts = [part for element in root.children for part in _behaviors(element)]
    early_s = _earliest_s(parts)
    parts = [_later(part, -early_s) for part in parts] if early_s < 0 else parts
    block = replace(root, name=_BLOCK.qualified, attributes=_of_block(root), content=tuple(_with_own_ids(parts)))
    late = f"; all of it {-early_s:.3f} s later, since it begins before 0" if early_s < 0 else ""
    return block, (Notice("bml_translated", f"Greta's BML is read as BML 1.0{late}"),)


def _of_block(root: Element) -> dict[str, str]:
    attributes = {name: str(text) for name, text in root.attributes.items()}
    attributes["characterId"] = attributes.pop("character", attributes.get("characterId", ""))
    composition = attributes.get("composition", "")
    attributes["composition"] = _COMPOSITIONS.get(composition, composition)
    return {"id": "bml1", **_sorted_out(attributes, _BLOCK)}


def _sorted_out(attributes: Mapping[str, str], kind: ElementKind) -> dict[str, str]:
    """What the core knows by its own names, the rest in Greta's namespace; nothing empty."""
    own = {name: text for name, text in attributes.items() if name in kind.attributes and _is_valid(text, name, kind)}
    others = {name: text for name, text in attributes.items() if name not in own and text.strip()}
    return own | {name if name.startswith("{") else f"{{{GRETA}}}{name}": text for name, text in others.items()}


def _is_valid(text: str, name: str, kind: ElementKind) -> bool:
    try:
        value_of(text, kind.attributes[name])
    except ValueError:
        return False
    return True


def _behaviors(element: Element) -> Iterator[Element]:
    """The core's behaviours for an element, or itself."""
    match local_name(element.name):
        case "speech":
            yield _speech(element)
        case "face":
            yield from _faces(element)
        case "gaze" | "gazeShift" as name:
            yield _named(replace(element, attributes={"target": LISTENER, **element.attributes}), name)
        case "head" | "gesture" | "pointing" as name:
            yield _named(element, name)
        case name:
            yield replace(element, name=f"{{{GRETA}}}{name}")


def _named(element: Element, name: str, **others: str) -> Element:
    """The behaviour `name` of the core with the element's attributes, and others in their place."""
    kind = _BLOCK.parts[name]
    attributes = {key: str(text) for key, text in element.attributes.items()} | others
    attributes["id"] = _NOT_IN_IDS.sub("_", attributes.get("id", name))
    return replace(element, name=kind.qualified, attributes=_sorted_out(attributes, kind), content=())


def _speech(element: Element) -> Element:
    marked = tuple(_marked(element))
    spoken = any(isinstance(part, str) and part.strip() for part in marked)
    text = marked if spoken else (str(element.attributes.get("text", "")),)
    bare = replace(element, attributes={name: value for name, value in element.attributes.items() if name != "text"})
    return replace(_named(bare, "speech"), content=(Element(f"{{{CORE}}}text", content=text, place=element.place),))


def _marked(element: Element) -> Iterator[Element | str]:
    """The words of a speech and the marks between them."""
    text = ""
    for part in element.content:
        if isinstance(part, str):
            text += part
        elif local_name(part.name) in _MARKS:
            yield from (text, replace(part, name=f"{{{CORE}}}sync", content=()))
            text = ""
    yield text


def _faces(element: Element) -> Iterator[Element]:
    """A face for each of its lexemes."""
    parts = [part for part in element.children if local_name(part.name) == "lexeme"]
    lexemes = [str(part.attributes.get("lexeme", "")) for part in parts] or [str(element.attributes.get("lexeme", ""))]
    for lexeme in lexemes:
        peak = {"attackPeak": str(element.attributes["ready"])} if "ready" in element.attributes else {}
        yield _named(element, "faceLexeme", lexeme=lexeme, **peak)


def _earliest_s(parts: Sequence[Element]) -> float:
    return min((float(text) for part in parts for _name, text in _seconds(part)), default=0.0)


def _seconds(element: Element) -> Iterator[tuple[str, str]]:
    """The sync points of a behaviour of the core that are in seconds."""
    kind = _BLOCK.parts.get(local_name(element.name))
    for name in kind.syncs if kind and element.name == kind.qualified else ():
        text = str(element.attributes.get(name, ""))
        if _SECONDS.fullmatch(text):
            yield name, text


def _later(element: Element, by_s: float) -> Element:
    """The behaviour with all its times in seconds later; a speech without any begins then."""
    moved = {name: text_of(round(float(text) + by_s, 3) + 0.0) for name, text in _seconds(element)}
    if element.name == f"{{{CORE}}}speech" and "start" not in element.attributes:
        moved["start"] = text_of(round(by_s, 3))
    return replace(element, attributes={**element.attributes, **moved})


def _with_own_ids(parts: Sequence[Element]) -> Iterator[Element]:
    """The parts, those whose id is taken with another."""
    taken: set[str] = set()
    for part in parts:
        name = str(part.attributes.get("id", ""))
        number = 1
        while name and name in taken:
            number += 1
            name = f"{part.attributes['id']}_{number}"
        taken.add(name)
        yield replace(part, attributes={**part.attributes, "id": name}) if name else part
