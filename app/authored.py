"""Reads the YAML files that authors write, and finds every mistake in them with its line and column.

Scalars stay the strings the author typed ("no" and "yes" are words, not booleans); the pydantic schema of the file
turns them into numbers where it wants numbers. No tags, no anchors, no aliases: a file says what it shows.
"""

from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TypeAlias, TypeVar

import yaml
from pydantic import BaseModel, ConfigDict, ValidationError

from app.errors import AuthoringError, Mistake

Plain: TypeAlias = "str | list[Plain] | dict[str, Plain]"
Schema = TypeVar("Schema", bound=BaseModel)
Value = TypeVar("Value")


class Entry(BaseModel):
    """Base of every schema of authored files: frozen, and nothing unknown passes."""

    model_config = ConfigDict(frozen=True, extra="forbid")


class Source:
    """One YAML file: its node tree for places, its plain value for the schema.

    Raises AuthoringError when the file is no YAML, or uses what we do not allow.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._text = path.read_text(encoding="utf-8")
        self.lines = self._text.splitlines()
        self._root = self._compose()
        self._refuse_aliases()
        self.value = _plain(self._root)

    def validated(self, schema: type[Schema]) -> Schema:
        """The file as `schema`; raises AuthoringError with every mistake at its place."""
        try:
            return schema.model_validate(self.value)
        except ValidationError as error:
            raise AuthoringError(
                tuple(self.mistake(tuple(found["loc"]), _readable(found["msg"])) for found in error.errors())
            ) from None

    def mistake(self, location: Sequence[str | int], message: str) -> Mistake:
        """A mistake at `location`, a path of keys and list positions; its deepest part that exists gives the place."""
        node = self._root
        for step in location:
            node = _child(node, step) or node
        return self._at(node.start_mark, message)

    def _compose(self) -> yaml.Node:
        try:
            node = yaml.compose(self._text, Loader=yaml.SafeLoader)
        except yaml.MarkedYAMLError as error:
            mark = error.problem_mark or yaml.Mark(str(self.path), 0, 0, 0, None, 0)
            raise AuthoringError((self._at(mark, f"not YAML: {error.problem}"),)) from None
        if node is None:
            raise AuthoringError((Mistake(self.path, 1, 1, "the file is empty"),))
        return node

    def _refuse_aliases(self) -> None:
        for token in yaml.scan(self._text, Loader=yaml.SafeLoader):
            if isinstance(token, (yaml.AnchorToken, yaml.AliasToken, yaml.TagToken)):
                raise AuthoringError((self._at(token.start_mark, "anchors, aliases and tags are not allowed"),))

    def _at(self, mark: yaml.Mark, message: str) -> Mistake:
        line = self.lines[mark.line] if mark.line < len(self.lines) else ""
        return Mistake(self.path, mark.line + 1, mark.column + 1, message, line)


def all_or_every_mistake(results: Iterable[Value | AuthoringError]) -> tuple[Value, ...]:
    """The values, when none is an error; else one AuthoringError with the mistakes of all of them."""
    values: list[Value] = []
    mistakes: list[Mistake] = []
    for result in results:
        if isinstance(result, AuthoringError):
            mistakes.extend(result.mistakes)
        else:
            values.append(result)
    if mistakes:
        raise AuthoringError(tuple(mistakes))
    return tuple(values)


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


def _readable(message: str) -> str:
    """Pydantic's message in the words of somebody who edits a file."""
    return message.replace("Extra inputs are not permitted", "unknown key").replace("Field required", "key is missing")
