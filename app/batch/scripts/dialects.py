"""Sheets exported by game engines, recognized by their headings because the usual names would mislead: in Ren'Py's
`dialogue.tab` and Yarn Spinner's string tables the column "file" is the script, not the recording."""

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from types import MappingProxyType

from ..model import ScriptLine
from .columns import Columns, folded
from .speeches import with_name

_RENPY_TAG = re.compile(r"\{(?!\{)[^{}]*\}")
_RENPY_NAME = re.compile(r"\[(?!\[)([^\[\]]*)\]")
_YARN_MARK = re.compile(r"\[/?[^\]]*\]|\{[^}]*\}|\s#\S+")
_YARN_PREFIX = "line:"


@dataclass(frozen=True, slots=True)
class Dialect:
    """An export format: the headings by which it is recognized, the headings of its fields, and the conversion of its
    lines."""

    signature: frozenset[str]
    fields: Mapping[str, str]
    plain: Callable[[ScriptLine], ScriptLine]

    def columns(self, header: Sequence[str]) -> Columns:
        places = {folded(cell): place for place, cell in enumerate(header)}
        found = {field: places[folded(name)] for field, name in self.fields.items() if folded(name) in places}
        return Columns(tuple(header), MappingProxyType(found))


def _of_renpy(line: ScriptLine) -> ScriptLine:
    """The line without text tags; an interpolated name is taken for the word that is spoken."""
    plain = _RENPY_NAME.sub(r"\1", _RENPY_TAG.sub("", line.text)).replace('\\"', '"').replace("\\n", " ")
    return replace(line, text=" ".join(plain.replace("{{", "{").replace("[[", "[").split()))


def _of_yarn(line: ScriptLine) -> ScriptLine:
    """The line without markup; its id without "line:" is the name of its recordings."""
    name, words = with_name(_YARN_MARK.sub("", line.text))
    return replace(line, id=line.id.removeprefix(_YARN_PREFIX), character=name, text=" ".join(words.split()))


DIALECTS = (
    Dialect(
        frozenset({"identifier", "character", "dialogue", "filename"}),
        {"id": "Identifier", "character": "Character", "text": "Dialogue"},
        _of_renpy,
    ),
    Dialect(
        frozenset({"id", "text", "file", "node", "linenumber"}),
        {"id": "id", "text": "text", "scene": "node", "comment": "comment"},
        _of_yarn,
    ),
)


def dialect_of(header: Sequence[str]) -> Dialect | None:
    """The export format that a header belongs to; None for any other sheet."""
    names = {folded(cell) for cell in header}
    return next((dialect for dialect in DIALECTS if dialect.signature <= names), None)
