"""What authors edit: every rule, word, mapping and table entry, listed with its place, and checked.

Files are named relative to the folder that holds the package, `app/rules/…` and `lexicon/…` in a checkout.
"""

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from enum import StrEnum
from functools import partial
from pathlib import Path

from app.acoustic.normalisation import Normaliser
from app.authored import Source
from app.bml.characters import Character, Characters
from app.bml.table import load_table
from app.errors import AuthoringError, InputError, Mistake
from app.resources import resource_folder
from app.rules.derivation import Conflicts, FunctionRules
from app.rules.lexicon import SLOT, LexicalEntry, Lexicon
from app.rules.mapping import MappingRules
from app.rules.program import Mention, Rule, load_program

RULES = Path(__file__).resolve().parent / "rules"
VOCABULARY = RULES / "vocabulary.rules"
NAMED_FILES = frozenset({"conflicts.yaml", "abbreviations.yaml", "behaviors.yaml"})
"""YAML files that are told by their names; the others hold words, or a character in a folder `characters`."""

__all__ = ["Catalogue", "Character", "Item", "Kind", "check_files", "check_files_in_use", "load_characters"]

Check = Callable[[], object]
"""Loads something; raises AuthoringError when it cannot be loaded."""


class Kind(StrEnum):
    """What an item is."""

    FUNCTION = "function"
    BEHAVIOR = "behavior"
    BML = "bml"
    WORD = "word"


@dataclass(frozen=True, slots=True)
class Item:
    """One thing that an author can change. `class_name` and `subtype` are those of the function it speaks of, if any;
    `comment` is what its author says of it, `source` what it is."""

    kind: Kind
    name: str
    class_name: str | None
    subtype: str | None
    file: str
    line: int
    comment: str
    source: str


@dataclass(frozen=True, slots=True)
class Catalogue:
    """All items in the order function rules, mapping rules, table entries, words; and the characters."""

    items: tuple[Item, ...]
    characters: Characters

    @classmethod
    def load(cls) -> "Catalogue":
        """Raises AuthoringError for the first kind of file that has mistakes, with all of that kind."""
        lexicon = resource_folder("lexicon")
        functions = FunctionRules.load(RULES, lexicon / "en")
        characters = load_characters()
        return cls.of(functions, characters, MappingRules.load(RULES, characters.behavior_names))

    @classmethod
    def of(cls, functions: FunctionRules, characters: Characters, mappings: MappingRules) -> "Catalogue":
        """The catalogue of what is loaded already."""
        items = (
            *(_rule_item(Kind.FUNCTION, rule, rule.asserts) for rule in functions.program.rules),
            *(_rule_item(Kind.BEHAVIOR, rule, rule.joins) for rule in mappings.program.rules),
            *_table_items(resource_folder("lexicon") / "behaviors.yaml", characters.behavior_names),
            *(_word_item(entry, entry.subtype) for entry in functions.lexicon.entries if entry.subtype is not None),
        )
        return cls(items, characters)

    def named(self, name: str) -> tuple[Item, ...]:
        """The items of that name, capital letters aside; raises InputError `unknown_name`."""
        found = tuple(item for item in self.items if item.name.lower() == name.lower())
        if not found:
            close = get_close_matches(name, sorted({item.name for item in self.items}), n=3)
            hint = f"; did you mean {' or '.join(close)}?" if close else "; see rules list"
            raise InputError("unknown_name", f"no rule, behaviour or word is called {name!r}{hint}", field="name")
        return found


def load_characters() -> Characters:
    """Raises AuthoringError with every mistake in the behaviour table and the characters."""
    return Characters.load(resource_folder("lexicon"))


def check_files_in_use() -> None:
    """Checks all that the program uses; raises AuthoringError with every mistake.

    Mapping rules are checked against the behaviour table, so mistakes in the table hide theirs.
    """
    lexicon = resource_folder("lexicon")
    mistakes = _mistakes_of(
        partial(FunctionRules.load, RULES, lexicon / "en"),
        partial(Normaliser.load, lexicon / "en" / "abbreviations.yaml", ()),
        lambda: MappingRules.load(RULES, load_characters().behavior_names),
    )
    if mistakes:
        raise AuthoringError(tuple(mistakes))


def check_files(paths: Iterable[Path]) -> int:
    """Checks these files, and all `.rules` and `.yaml` files in these folders, instead of those in use; their number.

    Rule files are read as one program, after the vocabulary in use unless a file of that name is among them.
    Raises AuthoringError with every mistake, InputError `no_authored_file` for a path that holds none.
    """
    files = [file for path in paths for file in _authored_files(path)]
    rules = [file for file in files if file.suffix == ".rules"]
    checks = dict(_check_of(file) for file in files if file.suffix != ".rules")
    found = [
        mistake for mistake in _mistakes_of(partial(_load_rules, rules), *checks.values()) if mistake.path in files
    ]
    if found:
        raise AuthoringError(tuple(found))
    return len(files)


def _authored_files(path: Path) -> list[Path]:
    """The files that `path` is or holds, by their full names."""
    inside = sorted(path.resolve().rglob("*")) if path.is_dir() else [path.resolve()]
    files = [file for file in inside if file.suffix in {".rules", ".yaml"} and file.is_file()]
    if not files:
        raise InputError("no_authored_file", f"{path}: no .rules or .yaml file is there; give a file or folder of them")
    for file in files:
        _require_text(file)
    return files


def _require_text(file: Path) -> None:
    try:
        file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError("file_unreadable", f"{file}: cannot be read as UTF-8 text: {error}") from None


def _load_rules(files: Sequence[Path]) -> None:
    vocabulary = [] if any(file.name == VOCABULARY.name for file in files) else [VOCABULARY]
    load_program([*vocabulary, *files], behaviors=load_characters().behavior_names)


def _check_of(file: Path) -> tuple[tuple[str, Path], Check]:
    """What reads a YAML file, keyed so that files which are read together are read once."""
    folder = file.parent
    if file.name == "conflicts.yaml":
        return ("conflicts", file), lambda: Source(file).validated(Conflicts)
    if file.name == "abbreviations.yaml":
        return ("abbreviations", file), partial(Normaliser.load, file, ())
    if file.name == "behaviors.yaml":
        return ("table", file), partial(load_table, file)
    if folder.name == "characters":
        return ("characters", folder), partial(_load_characters, folder.parent)
    return ("words", folder), partial(_load_words, folder)


def _load_characters(lexicon: Path) -> None:
    """Raises InputError `no_behavior_table` when the characters have no table to change."""
    if not (lexicon / "behaviors.yaml").is_file():
        raise InputError("no_behavior_table", f"{lexicon}: characters need the behaviors.yaml that they change here")
    Characters.load(lexicon)


def _load_words(folder: Path) -> None:
    """Also refuses a file that nothing would read."""
    files = sorted(folder.glob("*.yaml"))
    unread = [file for file in files if file.name not in NAMED_FILES and "class" not in _keys(file)]
    if unread:
        raise AuthoringError(tuple(Mistake(file, 1, 1, "a file of words begins with its `class`") for file in unread))
    Lexicon.load(folder)


def _keys(file: Path) -> Collection[str]:
    value = Source(file).value
    return value if isinstance(value, dict) else ()


def _mistakes_of(*checks: Check) -> list[Mistake]:
    """The mistakes that each check raises."""
    mistakes: list[Mistake] = []
    for check in checks:
        try:
            check()
        except AuthoringError as error:
            mistakes += error.mistakes
    return mistakes


def _rule_item(kind: Kind, rule: Rule, mentions: Sequence[Mention]) -> Item:
    """A rule, by the first function it asserts or maps."""
    function = next((mention for mention in mentions if mention.predicate == "fcn"), None)
    return Item(
        kind=kind,
        name=rule.name,
        class_name=function.arguments[0] if function else None,
        subtype=function.arguments[1] if function else None,
        file=_shown(rule.path),
        line=rule.line,
        comment=rule.comment,
        source=rule.source,
    )


def _table_items(path: Path, names: Collection[str]) -> Iterator[Item]:
    source = Source(path)
    for name in sorted(names):
        line = source.mistake(("behaviors", name), "").line
        text = source.lines[line - 1].strip()
        yield Item(Kind.BML, name, None, None, _shown(path), line, "", text)


def _word_item(entry: LexicalEntry, subtype: str) -> Item:
    conditions = entry.conditions.model_dump(exclude_defaults=True, exclude={"words", "subtype", "example"})
    said = [
        f"{key}: {value if isinstance(value, str) else ', '.join(sorted(value))}" for key, value in conditions.items()
    ]
    example = [f"example: {entry.example.replace(SLOT, entry.phrase)}"] if entry.example else []
    return Item(
        kind=Kind.WORD,
        name=entry.phrase,
        class_name=entry.class_name,
        subtype=subtype,
        file=_shown(entry.path),
        line=entry.line,
        comment="",
        source="\n".join([*said, *example]),
    )


def _shown(path: Path) -> str:
    root = RULES.parents[1]
    return str(path.relative_to(root)) if path.is_relative_to(root) else str(path)
