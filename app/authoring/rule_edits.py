"""Compiles edited rules, words and priorities beside those in use, which stay as they are.

Files are named by their place in a checkout: `app/rules/functions/lists.rules`, `lexicon/en/spatial.yaml`. A name that
does not exist yet is a new file, in the folders where an author may write one (docs/authoring.md). Edited texts are
compiled in a temporary folder.
"""

import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import lru_cache
from pathlib import Path
from tempfile import TemporaryDirectory

from ..authored_folders import AUTHORED, lexicon_folder, rules_folder
from ..behavior.candidates.vocabulary import BANNABLE
from ..errors import AuthoringError, InputError, Mistake, collected, did_you_mean, shown
from ..models import Understudy
from ..rules.derivation import FunctionRules
from ..rules.mapping import MappingRules
from .proofreading import refuse_unread_words

Edits = Mapping[str, str]
"""The whole text of each edited file, by its name."""

FIELD = "rules"
_OWN_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9_-]*")

_IN_MEMORY = Path("/dev/shm")
"""A folder that is writable even where the file system is read-only."""

_HEARD = "abbreviations.yaml"
"""Not editable here, because the aligner reads it when it starts."""


@dataclass(frozen=True, slots=True, eq=False)
class CompiledRules:
    """Function rules with their words, and mapping rules."""

    functions: FunctionRules
    mappings: MappingRules


def editable_files() -> Mapping[str, Path]:
    """The files that may be edited: rules, priorities, conflicts and words, by their names."""
    inside = (*rules_folder().rglob("*.*"), *(lexicon_folder() / "en").glob("*.*"))
    files = sorted(path for path in inside if path.suffix in AUTHORED and path.name != _HEARD and path.is_file())
    return {_name(path): path for path in files}


def _name(path: Path) -> str:
    return path.relative_to(rules_folder().parents[1]).as_posix()


def is_new_file(name: str) -> bool:
    """Whether a file of that name does not exist yet, and would be read."""
    rules, words = _name(rules_folder()), _name(lexicon_folder() / "en")
    folder, _, own = name.rpartition("/")
    suffixes = {f"{rules}/functions": ".rules", f"{rules}/behaviors": ".rules", words: ".yaml"}
    is_named = _OWN_NAME.fullmatch(own.removesuffix(suffixes.get(folder, "/"))) is not None
    return own.endswith(suffixes.get(folder, "/")) and is_named and name not in editable_files()


def require_file(name: str) -> None:
    """Raises InputError `unknown_file` for a name that is neither that of a file nor one that a new file may have."""
    files = editable_files()
    if name not in files and not is_new_file(name):
        hint = did_you_mean(name, files) or "; GET /rules/files lists those that are"
        rules, words = _name(rules_folder()), _name(lexicon_folder() / "en")
        where = f"a new one is in {rules}/functions/, {rules}/behaviors/ (NAME.rules) or {words}/ (NAME.yaml)"
        raise InputError("unknown_file", f"{shown(name)} is no file of rules or words{hint}; {where}", field=FIELD)


def mistakes_in(edits: Edits, behavior_names: frozenset[str]) -> tuple[Mistake, ...]:
    """Every mistake in the rules and words with these edits, with the names of their files. Raises InputError
    `unknown_file`."""
    try:
        compile_edits(edits, behavior_names)
    except AuthoringError as error:
        return error.mistakes
    return ()


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
    return InputError("rules_wrong", message, field=FIELD)


def compile_edits(edits: Edits, behavior_names: frozenset[str]) -> CompiledRules:
    """Compiles the edited rules; the last two results are cached, since a line is tried more often than a rule is
    changed.

    Raises AuthoringError with every mistake, InputError `unknown_file`.
    """
    for name in edits:
        require_file(name)
    return _compiled(tuple(sorted(edits.items())), behavior_names)


@lru_cache(maxsize=2)
def _compiled(edits: tuple[tuple[str, str], ...], behavior_names: frozenset[str]) -> CompiledRules:
    texts = dict(edits)
    with TemporaryDirectory(prefix="understudy-rules-", dir=_IN_MEMORY if _IN_MEMORY.is_dir() else None) as folder:
        for name, text in ({name: path.read_text("utf-8") for name, path in editable_files().items()} | texts).items():
            copy = Path(folder, name)
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(text, encoding="utf-8")
        words = Path(folder, _name(lexicon_folder() / "en"))
        rules = Path(folder, _name(rules_folder()))
        found: list[Mistake] = []
        collected(lambda: refuse_unread_words(words), found)
        functions = collected(lambda: FunctionRules.load(rules, words), found)
        mappings = collected(lambda: MappingRules.load(rules, behavior_names, BANNABLE), found)
        if functions is None or mappings is None or found:
            raise AuthoringError(tuple(dict.fromkeys(_renamed(mistake, Path(folder)) for mistake in found)))
    return CompiledRules(functions, mappings)


def _renamed(mistake: Mistake, folder: Path) -> Mistake:
    """The mistake with paths as the author knows them, without the temporary folder."""
    return replace(mistake, path=mistake.path.relative_to(folder), message=mistake.message.replace(f"{folder}/", ""))


def _named(path: Path) -> str:
    """The name of a file that rules were compiled from, even in a temporary folder that no longer exists."""
    return next((name for name in editable_files() if str(path).endswith(f"/{name}")), str(path))
