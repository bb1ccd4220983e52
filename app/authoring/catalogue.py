"""The catalogue of everything authored: rules, words, mappings and table entries with their places in the files.

Files are named relative to the folder that contains the package, `app/rules/…` and `lexicon/…` in a checkout.
"""

from collections.abc import Collection, Iterator, Sequence
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path

from ..authored_folders import lexicon_folder, origin, tables_of
from ..behavior.characters.overlays import Character, Characters
from ..behavior.reading.families import Families, FamilyBehavior, family_rule
from ..errors import InputError, did_you_mean
from ..files import RULES
from ..model import Level
from ..models import (
    load_characters,
    load_families,
    load_function_rules,
    load_gestures,
    load_mapping_rules,
)
from ..rules.derivation import FunctionRules
from ..rules.lexicon import SLOT, LexicalEntry
from ..rules.mapping import MappingRules
from ..rules.program.loading import FactMention, Rule
from ..yaml_files import Source, entry_source

__all__ = ["Catalogue", "Character", "Item", "ItemKind", "load_characters", "load_families", "load_gestures"]


class ItemKind(StrEnum):
    """The kind of an item."""

    FUNCTION = "function"
    BEHAVIOR = "behavior"
    BML = "bml"
    WORD = "word"


@dataclass(frozen=True, slots=True)
class Item:
    """One authored item. `class_name` and `subtype` are those of the function it concerns, if any; `comment` is the
    author's comment, `source` its text. `needs` and `gives` are its conditions and conclusions as facts in rule
    notation; a behaviour is a fact with its name."""

    kind: ItemKind
    name: str
    class_name: str | None
    subtype: str | None
    file: str
    line: int
    comment: str
    source: str
    needs: tuple[FactMention, ...]
    gives: tuple[FactMention, ...]


@dataclass(frozen=True, slots=True)
class Catalogue:
    """All items in the order function rules, mapping rules, families, table entries, words; and the characters."""

    items: tuple[Item, ...]
    characters: Characters

    @classmethod
    def load(cls) -> "Catalogue":
        """Load all files. Raises AuthoringError with all mistakes of the first kind of file that has any."""
        characters = load_characters()
        mappings = load_mapping_rules(characters.callable_names)
        return cls.of(load_function_rules(), characters, mappings, load_families(characters))

    @classmethod
    def of(
        cls, functions: FunctionRules, characters: Characters, mappings: MappingRules, families: Families
    ) -> "Catalogue":
        """The catalogue of resources already loaded."""
        items = (
            *(_rule_item(ItemKind.FUNCTION, rule, rule.asserts) for rule in functions.program.rules),
            *(_rule_item(ItemKind.BEHAVIOR, rule, rule.joins) for rule in mappings.program.rules),
            *_family_items(lexicon_folder() / "acting" / "families.yaml", families),
            *_table_items(lexicon_folder() / "behaviors.yaml", characters.behavior_names),
            *(_word_item(entry, entry.subtype) for entry in functions.lexicon.entries if entry.subtype is not None),
        )
        return cls(items, characters)

    def named(self, name: str) -> tuple[Item, ...]:
        """The items with this name, ignoring case. Raises InputError `unknown_name`."""
        found = tuple(item for item in self.items if item.name.lower() == name.lower())
        if not found:
            names = {item.name for item in self.items}
            hint = did_you_mean(name, names, most=3, otherwise="; see rules list")
            raise InputError("unknown_name", f"no rule, behaviour or word is called {name!r}{hint}", field="name")
        return found

    def that_lead_to(self, item: Item) -> tuple[Item, ...]:
        """The items whose conclusions can satisfy a condition of `item`, except those for functions of any class."""
        return tuple(other for other in self.items if _feeds(other, item))

    def that_follow(self, item: Item) -> tuple[Item, ...]:
        """The items with a condition that `item` can satisfy, except those for functions of any class."""
        return tuple(other for other in self.items if _feeds(item, other))


EDITED = "understudy-edits-"
"""How the names of temporary folders with edited files begin."""


def shown_path(path: Path) -> str:
    """The path as shown to authors; of edited files, without the temporary folder."""
    parts = path.parts
    edited = next((place for place, part in enumerate(parts) if part.startswith(EDITED)), None)
    if edited is not None:
        return str(Path(*parts[edited + 1 :]))
    root, path = RULES.parents[1], origin(path)
    return str(path.relative_to(root)) if path.is_relative_to(root) else str(path)


def _rule_item(kind: ItemKind, rule: Rule, mentions: Sequence[FactMention]) -> Item:
    """A rule, listed by the first function that it asserts or maps."""
    function = next((mention for mention in mentions if mention.predicate == "fcn"), None)
    return Item(
        kind=kind,
        name=rule.name,
        class_name=function.arguments[0] if function else None,
        subtype=function.arguments[1] if function else None,
        file=shown_path(rule.path),
        line=rule.line,
        comment=rule.comment,
        source=rule.source,
        needs=rule.joins,
        gives=(*rule.asserts, *(FactMention(call, ()) for call in rule.calls)),
    )


def _feeds(giver: Item, taker: Item) -> bool:
    """Whether one item can satisfy a condition of the other, judged by their constants."""
    return any(_is_one(given, needed) for given in giver.gives for needed in taker.needs)


def _is_one(given: FactMention, needed: FactMention) -> bool:
    """Whether one fact can match the other; a function of any class matches none."""
    pairs = list(zip(given.arguments, needed.arguments, strict=False))
    if given.predicate != needed.predicate or (given.predicate == "fcn" and "$" in (pairs[0][0][0], pairs[0][1][0])):
        return False
    return all(
        one[0] in "$_" or other[0] in "$_" or set(one.split("|")) & set(other.split("|")) for one, other in pairs
    )


def _family_items(path: Path, families: Families) -> Iterator[Item]:
    """What planned moments are shown by (docs/families.md), named as in the reasons for behaviours."""
    sources = [Source(each) for each in tables_of(path)]
    parts = {"gesture": families.gesture, "head": families.head, "face": families.face, "gaze": families.gaze}
    for part, named in parts.items():
        for family, behaviors in named.items():
            source = entry_source(sources, part, family)
            yield Item(
                kind=ItemKind.BEHAVIOR,
                name=family_rule(part, family),
                class_name=None,
                subtype=None,
                file=shown_path(source.path),
                line=_key_line(source, (part, family)),
                comment=f"the {part} of a moment planned as {family}; rules that know its words go first",
                source="\n".join(map(_family_line, behaviors)),
                needs=(FactMention("moment", (family,)),),
                gives=tuple(FactMention(behavior.name, ()) for behavior in behaviors),
            )


def _key_line(source: Source, place: tuple[str, str]) -> int:
    """The line of a key whose value may begin below it."""
    value = source.mistake(place, "").line
    return next(line for line in range(value, 0, -1) if source.lines[line - 1].strip().startswith(f"{place[1]}:"))


def _family_line(behavior: FamilyBehavior) -> str:
    words = f" where the line says {', '.join(sorted(behavior.lemmas))}" if behavior.lemmas else ""
    levels = "" if behavior.levels == frozenset(Level) else f" at agitation {', '.join(sorted(behavior.levels))}"
    return f"{behavior.name}{words}{levels}"


def _table_items(path: Path, names: Collection[str]) -> Iterator[Item]:
    sources = [Source(each) for each in tables_of(path)]
    for name in sorted(names):
        source = entry_source(sources, "behaviors", name)
        line = source.mistake(("behaviors", name), "").line
        text = source.lines[line - 1].strip()
        yield Item(
            ItemKind.BML,
            name,
            None,
            None,
            shown_path(source.path),
            line,
            "",
            text,
            needs=(FactMention(name, ()),),
            gives=(),
        )


def _word_item(entry: LexicalEntry, subtype: str) -> Item:
    conditions = entry.conditions.model_dump(exclude_defaults=True, exclude={"words", "subtype", "example"})
    said = [
        f"{key}: {value if isinstance(value, str) else ', '.join(sorted(value))}" for key, value in conditions.items()
    ]
    example = [f"example: {entry.example.replace(SLOT, entry.phrase)}"] if entry.example else []
    return Item(
        kind=ItemKind.WORD,
        name=entry.phrase,
        class_name=entry.class_name,
        subtype=subtype,
        file=shown_path(entry.path),
        line=entry.line,
        comment="",
        source="\n".join([*said, *example]),
        needs=(),
        gives=(FactMention("lexical", (entry.class_name, subtype)),),
    )
