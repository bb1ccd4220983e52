"""Validates BML files against the schema and the rules of strict realizers (docs/references.md).

Elements come from the parser with all attributes as text. Names, attributes and content of every element are checked
first, then, block by block, ids, references, the order of sync points, and conflicting gazes.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from itertools import pairwise
from operator import itemgetter

from ...errors import nearest_names
from .documents import Element, Reference, TagPosition, Value
from .elements import CORE, Dialect, ElementKind
from .values import value_of

Found = Iterator[tuple[TagPosition, str]]
"""The place and description of each mistake."""

_LONGEST_SHOWN = 40

_NOWHERE = TagPosition(1, 1)

_HINTS: Mapping[str, str] = {
    "face": "it is abstract; write faceLexeme, or faceFacs of the core extensions",
    "faceShift": "strict realizers refuse it; write faceLexeme",
    "lips": "it is SmartBody's",
    "faceFacs": "it is in the namespace of the core extensions",
    "character": "write characterId",
}
"""Advice about common mistakes."""


@dataclass(frozen=True, slots=True)
class _Behavior:
    """A possible target of references, with its attribute values; `kind` is None for an extension's element."""

    element: Element
    kind: ElementKind | None
    values: Mapping[str, Value]

    @property
    def points(self) -> frozenset[str]:
        marks = (str(part.attributes.get("id")) for text in self.element.children for part in text.children)
        return frozenset(self.kind.syncs if self.kind else ()).union(marks)


def mistakes_of(root: Element, kind: ElementKind, dialect: Dialect) -> Found:
    """All mistakes of a file whose `root` is of type `kind`."""
    yield from _in_element(root, kind, dialect)
    for block, of_kind in _blocks(root, kind):
        behaviors = list(_behaviors(block, of_kind))
        yield from _ids(block, behaviors)
        if dialect.namespaces:
            yield from _references(block, of_kind, behaviors)
            yield from _gazes(behaviors)
        yield from _order(behaviors)


def typed_attributes(element: Element, kind: ElementKind) -> dict[str, Value]:
    """The values of the valid attributes that are in the table."""
    values: dict[str, Value] = {}
    for name, attribute in kind.attributes.items():
        if name in element.attributes:
            try:
                values[name] = value_of(str(element.attributes[name]), attribute)
            except ValueError:
                continue
    return values


def kind_of(element: Element, parent: ElementKind) -> ElementKind | None:
    """The type of `element` inside a `parent`; None if it is not permitted there."""
    kind = parent.parts.get(local_name(element.name))
    return kind if kind and kind.qualified == element.name else None


def local_name(qualified: str) -> str:
    """The name without its namespace."""
    return qualified.rpartition("}")[2]


def is_foreign(qualified: str, dialect: Dialect) -> bool:
    """Whether a name outside the table belongs to an extension and so is not a mistake."""
    return qualified.rpartition("}")[0].removeprefix("{") not in dialect.namespaces


def _in_element(element: Element, kind: ElementKind, dialect: Dialect) -> Found:
    place = element.place or _NOWHERE
    for message in _in_attributes(element, kind, dialect):
        yield place, f"{_shown(element)}: {message}"
    if not kind.mixed and not kind.free:
        yield from _stray_text(element)
    if kind.needs and kind.needs not in {local_name(part.name) for part in element.children}:
        yield place, f"{_shown(element)}: no <{kind.needs}> inside"
    for part in element.children:
        inside = kind_of(part, kind)
        if inside:
            yield from _in_element(part, inside, dialect)
        elif not kind.free and not is_foreign(part.name, dialect):
            name = local_name(part.name)
            unknown = f"<{_short(name)}> is not allowed in <{kind.name}>"
            yield part.place or _NOWHERE, f"{unknown}{_hint(name, kind.parts)}"


def _stray_text(element: Element) -> Found:
    """Text where none is permitted; it has no position of its own and is reported by what precedes it."""
    before = element
    for part in element.content:
        if isinstance(part, Element):
            before = part
        elif part.strip():
            message = f"text {_short(part.strip())!r} after {_shown(before)}; no text is allowed here"
            yield before.place or _NOWHERE, message


def _in_attributes(element: Element, kind: ElementKind, dialect: Dialect) -> Iterator[str]:
    for name, attribute in kind.attributes.items():
        if attribute.required and name not in element.attributes:
            yield f"no {name}"
    for name, text in element.attributes.items():
        if name in kind.attributes:
            try:
                value_of(str(text), kind.attributes[name])
            except ValueError as error:
                yield f"{name}={_short(str(text))!r} {error}"
        elif not is_foreign(name, dialect):
            yield f"unknown attribute {_short(local_name(name))}{_hint(local_name(name), kind.attributes)}"


def _hint(name: str, known: Mapping[str, object]) -> str:
    if name in _HINTS:
        return f"; {_HINTS[name]}"
    near = nearest_names(name, known)
    return f"; did you mean {near[0]}?" if near else ""


def _blocks(root: Element, kind: ElementKind) -> Iterator[tuple[Element, ElementKind]]:
    if kind.name == "bml":
        yield root, kind
    else:
        yield from ((part, kind.parts["bml"]) for part in root.children if part.name == kind.parts["bml"].qualified)


def _behaviors(block: Element, kind: ElementKind) -> Iterator[_Behavior]:
    """The behaviours of a block, including those in `required`, and extension elements with an id."""
    for part in block.children:
        inside = kind_of(part, kind)
        if inside and inside.name == "required":
            yield from _behaviors(part, inside)
        elif inside:
            yield _Behavior(part, inside, typed_attributes(part, inside))
        elif "id" in part.attributes:
            yield _Behavior(part, None, {"id": part.attributes["id"]})


def _ids(block: Element, behaviors: list[_Behavior]) -> Found:
    """Block and behaviours share one name space; each speech has a separate one for its marks."""
    yield from _doubles([block, *(behavior.element for behavior in behaviors)])
    for behavior in behaviors:
        if behavior.kind and behavior.kind.name == "speech":
            yield from _doubles([mark for text in behavior.element.children for mark in text.children])


def _doubles(elements: list[Element]) -> Found:
    first: dict[Value, Element] = {}
    for element in elements:
        name = element.attributes.get("id")
        if name is not None and first.setdefault(name, element) is not element:
            line = (first[name].place or _NOWHERE).line
            yield element.place or _NOWHERE, f"{_shown(element)}: duplicate id, first used in line {line}"


def _references(block: Element, kind: ElementKind, behaviors: list[_Behavior]) -> Found:
    targets = {str(each.values.get("id")): each for each in behaviors}
    points = {name: each.points for name, each in targets.items()}
    own = str(block.attributes.get("id"))
    for element, reference in _referring(block, kind):
        target = targets.get(reference.behavior)
        if reference.block not in (None, own) or (reference.behavior == own and reference.point in ("start", "end")):
            continue
        if target is None:
            message = f"no behaviour has the id {_short(reference.behavior)!r}{_hint(reference.behavior, targets)}"
            yield element.place or _NOWHERE, f"{_shown(element)}: {message}"
        elif target.kind and reference.point not in points[reference.behavior]:
            known = dict.fromkeys(points[reference.behavior])
            message = (
                f"{_shown(target.element)} has no point {_short(reference.point)!r}{_hint(reference.point, known)}"
            )
            yield element.place or _NOWHERE, f"{_shown(element)}: {message}"


def _referring(element: Element, kind: ElementKind) -> Iterator[tuple[Element, Reference]]:
    for value in typed_attributes(element, kind).values():
        if isinstance(value, Reference):
            yield element, value
    for part in element.children:
        inside = kind_of(part, kind)
        if inside:
            yield from _referring(part, inside)


def _order(behaviors: list[_Behavior]) -> Found:
    """Only times relative to the same point can be compared."""
    for behavior in behaviors:
        place, name = behavior.element.place or _NOWHERE, _shown(behavior.element)
        at_points: dict[tuple[str | None, str, str] | None, list[tuple[str, float]]] = {}
        for sync in behavior.kind.syncs if behavior.kind else ():
            value = behavior.values.get(sync)
            if isinstance(value, Reference):
                at_points.setdefault((value.block, value.behavior, value.point), []).append((sync, value.offset_s))
            elif isinstance(value, float):
                at_points.setdefault(None, []).append((sync, value))
        for points in at_points.values():
            for (sync, time_s), (later, later_s) in pairwise(points):
                if later_s < time_s:
                    yield place, f"{name}: {later} comes before {sync}"
        if at_points.get(None) and at_points[None][0][1] < 0:
            yield place, f"{name}: {at_points[None][0][0]} is before 0"


def _gazes(behaviors: list[_Behavior]) -> Found:
    """Overlapping gazes of the same joints at different targets, where times are in seconds."""
    spans: dict[Value | None, list[tuple[float, float, int, Element]]] = {}
    for number, each in enumerate(behaviors):
        start_s, end_s = each.values.get("start"), each.values.get("end")
        if each.element.name == f"{{{CORE}}}gaze" and isinstance(start_s, float) and isinstance(end_s, float):
            spans.setdefault(each.values.get("influence"), []).append((start_s, end_s, number, each.element))
    for gazes in spans.values():
        longest = None
        for start_s, end_s, _, element in sorted(gazes):
            if longest and start_s < longest[0]:
                message = f"it overlaps on the same joints with {_shown(longest[1])}; end one before the other"
                yield element.place or _NOWHERE, f"{_shown(element)}: {message}"
            longest = max(longest or (end_s, element), (end_s, element), key=itemgetter(0))


def _shown(element: Element) -> str:
    """The element as messages show it."""
    name = _short(local_name(element.name))
    return f"<{name} {_short(str(element.attributes['id']))}>" if "id" in element.attributes else f"<{name}>"


def _short(text: str) -> str:
    return text if len(text) <= _LONGEST_SHOWN else f"{text[:_LONGEST_SHOWN]}…"
