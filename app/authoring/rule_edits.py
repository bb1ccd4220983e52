"""Compiles edited rules, words and priorities beside those in use, which stay as they are; finds the mistakes in edited
files of any kind; and compares the functions and offered behaviours of lines before and after an edit.

Files are named as in `saved_files`; a name that does not exist yet is a new file. Edited texts are read in a temporary
folder. Lines are compared without audio, because that is quick enough to try every edit: conditions on stress, pauses
or agitation do not hold. What is compared is what the mapping rules offer, not what is scheduled.
"""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from typing import TypeVar

from ..errors import AuthoringError, InputError, Mistake, collected
from ..files import resource_folder
from ..model import CallableNames, Function, Utterance, Word
from ..models import Understudy
from ..rules.derivation import understand
from ..rules.lexicon import SLOT, Lexicon
from ..rules.mapping import offer_movements
from ..text.transcript import read_transcript
from .file_checking import CompiledRules, compile_rules, mistakes_in_files, temporary_folder
from .saved_files import LEXICON_FILES, RULE_FILES

Edits = Mapping[str, str]
"""The whole text of each edited file, by its name."""


def mistakes_in(edits: Edits, names: CallableNames) -> tuple[Mistake, ...]:
    """Every mistake in the rules and words with these edits, and in edited gestures, characters, profiles and weights,
    with the names of their files. Raises InputError `unknown_file`."""
    lexicon = {full: text for name, text in edits.items() if (full := LEXICON_FILES.known(name))}
    rules = {name: text for name, text in edits.items() if not LEXICON_FILES.known(name)}
    found = list(_lexicon_mistakes(lexicon))
    if rules or not lexicon:
        collected(lambda: compile_edits(rules, names), found)
    return tuple(found)


def _lexicon_mistakes(edits: Edits) -> tuple[Mistake, ...]:
    with temporary_folder() as folder:
        paths = {name: Path(folder, name) for name in edits}
        for name, path in paths.items():
            _write(path, edits[name])
        return tuple(_renamed(mistake, Path(folder)) for mistake in mistakes_in_files(paths))


def with_edits(understudy: Understudy, edits: Edits) -> Understudy:
    """The same models with these texts instead of their files. Raises InputError `rules_wrong` for texts with mistakes,
    `unknown_file`."""
    if not edits:
        return understudy
    try:
        compiled = compile_edits(edits, understudy.behavior.characters.callable_names)
    except AuthoringError as error:
        raise rules_wrong(error) from None
    return replace(
        understudy,
        language=replace(understudy.language, rules=compiled.functions),
        behavior=replace(understudy.behavior, rules=compiled.mappings),
    )


def rules_wrong(error: AuthoringError) -> InputError:
    """The first mistake in edited rules, as an error of the request."""
    first, *others = error.mistakes
    more = f"; and {len(others)} more mistakes" if others else ""
    message = f"{_named(first.path)}:{first.line}:{first.column}: {first.message}{more}"
    return InputError("rules_wrong", message, field=RULE_FILES.field)


def compile_edits(edits: Edits, names: CallableNames) -> CompiledRules:
    """Compiles the edited rules; the last two results are cached, since a line is tried more often than a rule is
    changed.

    Raises AuthoringError with every mistake, InputError `unknown_file`.
    """
    full = {RULE_FILES.required(name): text for name, text in edits.items()}
    return _compiled(tuple(sorted(full.items())), names)


@lru_cache(maxsize=2)
def _compiled(edits: tuple[tuple[str, str], ...], names: CallableNames) -> CompiledRules:
    in_use = {name: path.read_text("utf-8") for name, path in RULE_FILES.files().items()}
    with temporary_folder() as folder:
        for name, text in (in_use | dict(edits)).items():
            _write(Path(folder, name), text)
        try:
            return compile_rules(Path(folder), names)
        except AuthoringError as error:
            raise AuthoringError(tuple(_renamed(mistake, Path(folder)) for mistake in error.mistakes)) from None


def _write(path: Path, text: str) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def _renamed(mistake: Mistake, folder: Path) -> Mistake:
    """The mistake with paths as the author knows them, without the temporary folder."""
    inside = mistake.path.is_relative_to(folder)
    path = mistake.path.relative_to(folder) if inside else mistake.path
    return replace(mistake, path=path, message=mistake.message.replace(f"{folder}/", ""))


def _named(path: Path) -> str:
    """The name of a file that rules were compiled from, even in a temporary folder that no longer exists."""
    return next((name for name in RULE_FILES.files() if str(path).endswith(f"/{name}")), str(path))


@dataclass(frozen=True, slots=True)
class ComparedOffer:
    """A behaviour that a rule offers for a function, and the weight it has there."""

    name: str
    rule: str
    class_name: str
    first: int
    last: int
    weight: float


Said = TypeVar("Said", Function, ComparedOffer)


@dataclass(frozen=True, slots=True)
class LineChange:
    """A line for which something changed: the functions and offers that are gone, and the new ones."""

    id: str
    words: tuple[Word, ...]
    functions_before: tuple[Function, ...]
    functions_after: tuple[Function, ...]
    offers_before: tuple[ComparedOffer, ...]
    offers_after: tuple[ComparedOffer, ...]


@dataclass(frozen=True, slots=True)
class _LineReading:
    """The functions and offers for a line; the ids of functions, which depend on their count, are left out."""

    functions: tuple[Function, ...]
    offers: tuple[ComparedOffer, ...]


def example_lines(lexicon: Lexicon) -> Mapping[str, str]:
    """The example of every group of words, with the first of its words, and the bundled line, by file and example."""
    found: dict[str, str] = {}
    for entry in lexicon.entries:
        if entry.example:
            found.setdefault(f"{entry.path.name}: {entry.example}", entry.example.replace(SLOT, entry.phrase))
    bundled = (resource_folder("examples") / "example.txt").read_text(encoding="utf-8")
    return {"example.txt": bundled, **found}


def compare(understudy: Understudy, edits: Edits, lines: Mapping[str, str]) -> tuple[LineChange, ...]:
    """The lines (texts by id) that these edits change. Raises InputError `rules_wrong`, `unknown_file`, and for a text
    that cannot be used."""
    edited = with_edits(understudy, edits)
    spoken = [read_transcript(text) for text in lines.values()]
    parsed = understudy.language.parser.parse_all(spoken)
    utterances = [Utterance(words=words, parse=parse) for words, parse in zip(spoken, parsed, strict=True)]
    try:
        return tuple(
            change
            for line_id, utterance in zip(lines, utterances, strict=True)
            for change in _change(line_id, utterance, _read(understudy, utterance), _read(edited, utterance))
        )
    except AuthoringError as error:  # a rule that goes wrong where it runs
        raise rules_wrong(error) from None


def _change(line_id: str, utterance: Utterance, before: _LineReading, after: _LineReading) -> Iterator[LineChange]:
    if before != after:
        yield LineChange(
            line_id,
            utterance.words,
            functions_before=_without(before.functions, after.functions),
            functions_after=_without(after.functions, before.functions),
            offers_before=_without(before.offers, after.offers),
            offers_after=_without(after.offers, before.offers),
        )


def _read(understudy: Understudy, utterance: Utterance) -> _LineReading:
    known = understand(understudy.language.rules, utterance)
    offered = offer_movements(understudy.behavior.rules, utterance, known.functions, seed=0, facts=known.facts)
    offers = (
        ComparedOffer(
            movement.name, movement.rule, each.function.class_name, movement.first, movement.last, choice.weight
        )
        for each in offered
        for choice in each.alternatives
        for movement in choice.movements
        if each.function is not None
    )
    return _LineReading(tuple(map(_anonymous, known.functions)), tuple(offers))


def _anonymous(function: Function) -> Function:
    """The function without id and reasons, so that two are equal if they say the same of the same words."""
    return replace(function, id="", lost_to=None, because=())


def _without(these: Sequence[Said], those: Sequence[Said]) -> tuple[Said, ...]:
    return tuple(one for one in these if one not in those)
