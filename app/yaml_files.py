"""Reads the YAML files that authors write, and finds every mistake in them with its line and column.

Scalars stay strings as the author typed them ("no" and "yes" are words, not booleans); the pydantic schema of the file
turns them into numbers where it wants numbers. Tags, anchors and aliases are refused, so that the value is what the
file shows. Files also come from strangers, by the service: depth and size are checked before anything is built.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Protocol, TypeAlias, TypeVar, get_args

import yaml
from pydantic import BaseModel, ConfigDict, RootModel, ValidationError

from .errors import AuthoringError, Mistake, shown

if TYPE_CHECKING:
    from pydantic_core import ErrorDetails

Plain: TypeAlias = "str | list[Plain] | dict[str, Plain]"
DEEPEST = 32
"""How deep lists and mappings may be nested; ours are five deep."""

MOST_NODES = 50_000
"""Keys, values, lists and mappings of one file; the largest of ours has 5,000."""

MOST_MISTAKES = 100
"""The most mistakes reported of one file; with more, something else is wrong with it."""

_LONGEST_LINE = 500
"""Characters of a line that is quoted with a mistake in it."""

Schema = TypeVar("Schema", bound=BaseModel)
Value = TypeVar("Value")


class _Place(Protocol):
    """The position YAML gives for an error or a node; counts from 0."""

    line: int
    column: int


class Entry(BaseModel):
    """Base of every schema of authored files: frozen, unknown keys are refused."""

    model_config = ConfigDict(defer_build=True, frozen=True, extra="forbid")


class Source:
    """One YAML file: its node tree for positions, its plain value for the schema. If `text` is given it is used as the
    file's content.

    Raises AuthoringError when the file is not YAML, or uses what we do not allow.
    """

    def __init__(self, path: Path, text: str | None = None) -> None:
        self.path = path
        self._text = _read(path) if text is None else text
        self.lines = self._text.splitlines()
        self._root = self._compose()
        self._refuse_wrong_keys()
        self.value = _plain(self._root)

    def validated(self, schema: type[Schema]) -> Schema:
        """The file as `schema`; raises AuthoringError with every mistake and its position."""
        try:
            return schema.model_validate(self.value)
        except ValidationError as error:
            found = ((tuple(each["loc"]), _readable(each, schema)) for each in error.errors())
            raise _wrong(self.mistake(*each) for each in found) from None

    def mistake(self, location: Sequence[str | int], message: str) -> Mistake:
        """A mistake at `location`, a path of keys and list positions; the deepest part that exists gives line and
        column."""
        node = self._root
        for step in location:
            node = _child(node, step) or node
        return self._at(node.start_mark, message)

    def has(self, location: Sequence[str]) -> bool:
        """Whether there is anything at a path of keys."""
        value: Plain | None = self.value
        for step in location:
            value = value.get(step) if isinstance(value, dict) else None
        return value is not None

    def _compose(self) -> yaml.Node:
        try:
            self._check_events()
            node = yaml.compose(self._text, Loader=yaml.CSafeLoader)
        except yaml.MarkedYAMLError as error:
            raise AuthoringError((self._at(error.problem_mark, f"not YAML: {error.problem}"),)) from None
        except yaml.YAMLError as error:
            raise AuthoringError((Mistake(self.path, 1, 1, f"not YAML: {error}".splitlines()[0]),)) from None
        if node is None:
            raise AuthoringError((Mistake(self.path, 1, 1, "the file is empty"),))
        return node

    def _check_events(self) -> None:
        """Refuses anchors, aliases and tags, and stops at once when nesting or size pass their limits, because building
        such a tree may exhaust memory."""
        depth, nodes, hidden = 0, 0, list[Mistake]()
        for event in yaml.parse(self._text, Loader=yaml.CSafeLoader):
            depth += isinstance(event, yaml.CollectionStartEvent) - isinstance(event, yaml.CollectionEndEvent)
            nodes += isinstance(event, yaml.NodeEvent)
            if depth > DEEPEST:
                raise AuthoringError((self._at(event.start_mark, f"nested more than {DEEPEST} levels deep"),))
            if nodes > MOST_NODES:
                raise AuthoringError((self._at(event.start_mark, f"more than {MOST_NODES} keys and values"),))
            if isinstance(event, yaml.AliasEvent) or getattr(event, "anchor", None) or getattr(event, "tag", None):
                hidden.append(self._at(event.start_mark, "anchors, aliases and tags are not allowed"))
                if len(hidden) > MOST_MISTAKES:
                    break
        if hidden:
            raise _wrong(hidden)

    def _refuse_wrong_keys(self) -> None:
        """Refuses duplicate keys, and keys that are lists or mappings."""
        found = islice(_wrong_keys(self._root), MOST_MISTAKES + 1)
        mistakes = [self._at(key.start_mark, message) for key, message in found]
        if mistakes:
            raise _wrong(mistakes)

    def _at(self, place: _Place | None, message: str) -> Mistake:
        line, column = (place.line, place.column) if place else (0, 0)
        quoted = self.lines[line] if line < len(self.lines) else ""
        return Mistake(self.path, line + 1, column + 1, message, quoted if len(quoted) <= _LONGEST_LINE else "")


def entry_source(sources: Sequence[Source], *place: str) -> Source:
    """The last of several files of a table that has the entry at this place of keys, the first if none has."""
    return next((each for each in reversed(sources) if each.has(place)), sources[0])


def has_key(path: Path, key: str) -> bool:
    """Whether a file has this key, found without building it: usually it is the first. Raises AuthoringError as
    `Source` does for a file that is read to its end."""
    depth, steps = 0, 0
    try:
        for event in yaml.parse(_read(path), Loader=yaml.CSafeLoader):
            depth -= isinstance(event, yaml.CollectionEndEvent)
            steps += depth == 1 and isinstance(event, yaml.NodeEvent)
            if steps % 2 and depth == 1 and isinstance(event, yaml.ScalarEvent) and event.value == key:
                return True
            is_list = depth == 0 and isinstance(event, yaml.SequenceStartEvent)
            depth += isinstance(event, yaml.CollectionStartEvent)
            if is_list or depth > DEEPEST or steps > MOST_NODES:
                break
    except yaml.YAMLError:
        pass
    Source(path)  # raises, if that is why it was not found
    return False


def _wrong(mistakes: Iterable[Mistake]) -> AuthoringError:
    """With all mistakes, or with the first and how many more there are."""
    first = list(islice(mistakes, MOST_MISTAKES + 1))
    if len(first) > MOST_MISTAKES:
        first[-1] = replace(first[-1], message="there are more mistakes; correct these first")
    return AuthoringError(tuple(first))


def _read(path: Path) -> str:
    try:
        return path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise AuthoringError((Mistake(path, 1, 1, f"cannot be read as UTF-8 text: {error}"),)) from None


def _wrong_keys(node: yaml.Node) -> Iterator[tuple[yaml.Node, str]]:
    if isinstance(node, yaml.SequenceNode):
        for item in node.value:
            yield from _wrong_keys(item)
    elif isinstance(node, yaml.MappingNode):
        seen: set[str] = set()
        for key, value in node.value:
            if not isinstance(key, yaml.ScalarNode):
                yield key, "a key is a word, not a list or a mapping"
                continue
            if key.value in seen:
                yield key, f"duplicate key {shown(key.value)}"
            seen.add(key.value)
            yield from _wrong_keys(value)


def _plain(node: yaml.Node) -> Plain:
    if isinstance(node, yaml.MappingNode):
        return {key.value: _plain(value) for key, value in node.value}
    if isinstance(node, yaml.SequenceNode):
        return [_plain(item) for item in node.value]
    return str(node.value)


def _child(node: yaml.Node, step: str | int) -> yaml.Node | None:
    if isinstance(node, yaml.MappingNode):
        return next((value for key, value in node.value if key.value == step), None)
    if isinstance(node, yaml.SequenceNode) and isinstance(step, int) and step < len(node.value):
        item: yaml.Node = node.value[step]
        return item
    return None


def _readable(found: "ErrorDetails", schema: type[BaseModel]) -> str:
    """Pydantic's message about a file of this schema, in words for somebody who edits it."""
    match found["type"]:
        case "missing":
            return f"the key {found['loc'][-1]!r} is missing"
        case "extra_forbidden":
            return "unknown key"
        case "model_type" | "dict_type":
            return f"expected keys with values{_keys_of(found, schema)}; found {_described(found['input'])}"
        case "tuple_type" | "list_type" | "set_type" | "frozen_set_type":
            return f"expected a list, such as [one, two]; found {_described(found['input'])}"
        case _:
            return found["msg"]


def _described(value: object) -> str:
    """A value of the wrong type."""
    if isinstance(value, dict):
        return "keys with values"
    return "a list" if isinstance(value, list) else shown(value)


def _keys_of(found: "ErrorDetails", schema: type[BaseModel]) -> str:
    """The keys of the entry that was meant, the required ones first."""
    name = found.get("ctx", {}).get("class_name")
    model = next((each for each in _models_in(schema, set()) if each.__name__ == name), None)
    if model is None or issubclass(model, RootModel):
        return ""
    fields = sorted(model.model_fields.items(), key=lambda field: not field[1].is_required())
    keys = [f"{field.alias or key}{' required' if field.is_required() else ''}" for key, field in fields]
    return f" ({', '.join(keys)})"


def _models_in(annotation: object, seen: set[object]) -> Iterator[type[BaseModel]]:
    """The schemas that an annotation names, and those in them."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel) and annotation not in seen:
        seen.add(annotation)
        yield annotation
        for field in annotation.model_fields.values():
            yield from _models_in(field.annotation, seen)
    for part in get_args(annotation):
        yield from _models_in(part, seen)
