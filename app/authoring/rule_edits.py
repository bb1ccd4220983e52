"""Compiles edited rules, words and priorities beside those in use, which stay as they are, and finds the mistakes in
edited files of any kind.

Files are named as in `editable_files`; a name that does not exist yet is a new file. Edited texts are read in a
temporary folder.
"""

from collections.abc import Mapping
from dataclasses import replace
from functools import lru_cache
from pathlib import Path

from ..errors import AuthoringError, InputError, Mistake, collected
from ..models import Understudy
from .editable_files import LEXICON_FILES, RULE_FILES
from .file_checking import CompiledRules, compile_rules, mistakes_in_files, temporary_folder

Edits = Mapping[str, str]
"""The whole text of each edited file, by its name."""


def mistakes_in(edits: Edits, behavior_names: frozenset[str]) -> tuple[Mistake, ...]:
    """Every mistake in the rules and words with these edits, and in edited gestures, characters, profiles and weights,
    with the names of their files. Raises InputError `unknown_file`."""
    lexicon = {full: text for name, text in edits.items() if (full := LEXICON_FILES.known(name))}
    rules = {name: text for name, text in edits.items() if not LEXICON_FILES.known(name)}
    found = list(_lexicon_mistakes(lexicon))
    if rules or not lexicon:
        collected(lambda: compile_edits(rules, behavior_names), found)
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
        compiled = compile_edits(edits, frozenset(understudy.behavior.characters.behavior_names))
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


def compile_edits(edits: Edits, behavior_names: frozenset[str]) -> CompiledRules:
    """Compiles the edited rules; the last two results are cached, since a line is tried more often than a rule is
    changed.

    Raises AuthoringError with every mistake, InputError `unknown_file`.
    """
    full = {RULE_FILES.required(name): text for name, text in edits.items()}
    return _compiled(tuple(sorted(full.items())), behavior_names)


@lru_cache(maxsize=2)
def _compiled(edits: tuple[tuple[str, str], ...], behavior_names: frozenset[str]) -> CompiledRules:
    in_use = {name: path.read_text("utf-8") for name, path in RULE_FILES.files().items()}
    with temporary_folder() as folder:
        for name, text in (in_use | dict(edits)).items():
            _write(Path(folder, name), text)
        try:
            return compile_rules(Path(folder), behavior_names)
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
