"""Greta's BML as BML 1.0 core, with the places of its elements: in its old namespace, or in none, alone or in an
`fml-apml`, of which only the `bml` is read.

It differs from the core in names (`character`, `tm` for the marks of a speech, `lexeme` inside a `face`, the `level` of
a `description`), has ids twice, and times before the start of the speech, for which the whole block comes later. What
the core does not know is put into the old namespace, and is reported as all that is foreign.

A `bml` without a namespace is SmartBody's, unless it has marks or heads that are not.
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

_BLOCKS = frozenset({"bml", f"{{{GRETA}}}bml"})
_BLOCK = BML_CORE.roots["bml"]
_COMPOSITIONS: Mapping[str, str] = MappingProxyType({"blend": "MERGE", "append": "APPEND", "replace": "REPLACE"})
_MARKS = frozenset({"tm", "sync"})
_NOT_IN_IDS = re.compile(r"[^A-Za-z0-9_.]")
_SECONDS = re.compile(r"[+-]?(\d+(\.\d*)?|\.\d+)", re.ASCII)


def in_core_bml(root: Element) -> tuple[Element, tuple[Notice, ...]]:
    """The document in the core's names if it is Greta's, and what was changed; any other unchanged."""
    found = _block_in(root)
    if found is None:
        return root, ()
    parts = [part for element in found.children for part in _behaviors(element)]
    early_s = _earliest_s(parts)
    parts = [_later(part, -early_s) for part in parts] if early_s < 0 else parts
    block = replace(found, name=_BLOCK.qualified, attributes=_of_block(found), content=tuple(_with_own_ids(parts)))
    late = f", shifted by {-early_s:.3f} s, since it begins before 0" if early_s < 0 else ""
    unread = "".join(f"; the <{local_name(each.name)}> beside it is ignored" for each in _beside(found, root))
    return block, (Notice("bml_translated", f"Greta's BML is read as BML 1.0{late}{unread}"),)


def _block_in(root: Element) -> Element | None:
    """The block of a document of Greta's."""
    if root.name == "fml-apml":
        return next((part for part in root.children if part.name in _BLOCKS), None)
    return root if root.name in _BLOCKS and (root.name != "bml" or any(map(_is_gretas, root.children))) else None


def _beside(block: Element, root: Element) -> Iterator[Element]:
    return (part for part in root.children if root is not block and part is not block and part.content)


def _is_gretas(behavior: Element) -> bool:
    """Whether SmartBody has no such behaviour: a head with a lexeme instead of a type, a speech with Greta's marks."""
    match behavior.name:
        case "head":
            return "lexeme" in behavior.attributes and "type" not in behavior.attributes
        case "speech":
            return any(part.name == "tm" for part in behavior.children)
        case _:
            return False


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
            yield _in_core(replace(element, attributes={"target": LISTENER, **element.attributes}), _BLOCK.parts[name])
        case name if name in _BLOCK.parts:
            yield _in_core(element, _BLOCK.parts[name])
        case name:
            yield replace(element, name=f"{{{GRETA}}}{name}")


def _in_core(element: Element, kind: ElementKind) -> Element:
    """An element that the core has too, with its parts."""
    attributes = {key: str(text) for key, text in element.attributes.items()}
    if "id" in kind.attributes:
        attributes["id"] = _NOT_IN_IDS.sub("_", attributes.get("id", kind.name))
    if kind.name == "description" and "level" in attributes:  # as BML was before 1.0
        attributes = {"priority": attributes.pop("level"), **attributes}
    known = ((part, kind.parts.get(local_name(part.name))) for part in element.children)
    parts = tuple(_in_core(part, inside) for part, inside in known if inside)
    return replace(element, name=kind.qualified, attributes=_sorted_out(attributes, kind), content=parts)


def _speech(element: Element) -> Element:
    marked = tuple(_marked(element))
    spoken = any(isinstance(part, str) and part.strip() for part in marked)
    text = marked if spoken else (str(element.attributes.get("text", "")),)
    bare = {name: value for name, value in element.attributes.items() if name != "text"}
    named = _in_core(replace(element, attributes=bare, content=()), _BLOCK.parts["speech"])
    return replace(named, content=(Element(f"{{{CORE}}}text", content=text, place=element.place),))


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
        attributes = {**element.attributes, **peak, "lexeme": lexeme}
        yield _in_core(replace(element, attributes=attributes, content=()), _BLOCK.parts["faceLexeme"])


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
