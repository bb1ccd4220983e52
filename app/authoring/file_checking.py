"""Checks files of authors before they are put to use, as if they were in an author's folder: laid over those in use, in
the place of those of the same name (docs/authoring.md)."""

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from tempfile import TemporaryDirectory

from ..authored_folders import AUTHORED, lexicon_folder, name_in_checkout, origin, rules_folder
from ..behavior.characters.overlays import Characters
from ..behavior.reading.families import load_families
from ..behavior.table.behavior_table import load_table
from ..errors import AuthoringError, InputError, Mistake, collected
from ..model import CallableNames
from ..models import load_characters, load_gestures
from ..realizer.body.skeleton import Skeleton
from ..realizer.exporting.retargeting import load_rigs
from ..realizer.gestures.library import SUFFIX, Library
from ..rules.derivation import FunctionRules
from ..rules.mapping import MappingRules
from ..rules.program.loading import PRINTED, load_program
from .catalogue import EDITED
from .proofreading import (
    NAMED_FILES,
    Check,
    check_coverage,
    check_profile,
    check_weights,
    mistakes_of,
    refuse_unread_words,
)

VOCABULARY = "vocabulary.rules"
_CHOOSES = re.compile(r"^\s*(choose|never|always)\b", re.MULTILINE)

_ADDED_TO = {"behaviors.yaml": "behaviors", "families.yaml": "acting/families"}
"""Tables that authors add to, and the folder in the lexicon for what is added; `LAST` is read after all others."""
LAST = "last.yaml"
FAMILIES, WEIGHTS = "acting/families.yaml", "acting/weights.yaml"

_IN_MEMORY = Path("/dev/shm")
"""A folder that is writable even where the file system is read-only."""


@dataclass(frozen=True, slots=True, eq=False)
class CompiledRules:
    """Function rules with their words, and mapping rules."""

    functions: FunctionRules
    mappings: MappingRules


def temporary_folder() -> TemporaryDirectory[str]:
    """A folder in memory, where that is possible, for files that are only to be read once."""
    return TemporaryDirectory(prefix=EDITED, dir=_IN_MEMORY if _IN_MEMORY.is_dir() else None)


def compile_rules(root: Path, names: CallableNames) -> CompiledRules:
    """Loads the rules and words under `root`, which are named as in a checkout; raises AuthoringError with every
    mistake in them."""
    rules, words = root / name_in_checkout(rules_folder()), root / name_in_checkout(lexicon_folder() / "en")
    found: list[Mistake] = []
    collected(lambda: refuse_unread_words(words), found)
    functions = collected(lambda: FunctionRules.load(rules, words), found)
    mappings = collected(lambda: MappingRules.load(rules, names), found)
    if functions is None or mappings is None or found:
        raise AuthoringError(tuple(dict.fromkeys(found)))
    return CompiledRules(functions, mappings)


def check_files(paths: Iterable[Path]) -> int:
    """Check these files, and all authored files in these folders, as if they were in use; returns their number.

    Rules with a vocabulary among them are a program by themselves. Raises AuthoringError with all mistakes in them (or,
    if they have none, in the files they are read with), InputError `no_authored_file` for a path without any.
    """
    files = [file for path in paths for file in _authored_files(path)]
    rules = [file for file in files if file.suffix == ".rules"]
    alone = rules if any(file.name == VOCABULARY for file in rules) else []
    placed = dict(_placed([file for file in files if file not in alone]))
    others = [file for file in files if file not in {*alone, *placed.values()}]
    mistakes = mistakes_of(
        lambda: alone and load_program(alone, behaviors=load_characters().callable_names, printed=PRINTED),
        *(partial(NAMED_FILES[file.name], file) for file in others if file.name in NAMED_FILES),
        *(
            partial(load_rigs, folder, Skeleton.standing())
            for folder in {file.parent for file in others if file.parent.name == "retarget"}
        ),
    )
    mistakes += mistakes_in_files(placed)
    if mistakes:
        raise AuthoringError(tuple(mistake for mistake in mistakes if mistake.path in files) or tuple(mistakes))
    return len(files)


def mistakes_in_files(files: Mapping[str, Path]) -> tuple[Mistake, ...]:
    """Every mistake in these files of rules, words, gestures, characters, profiles and weights, by their names in a
    checkout, and in those in use that do not go with them."""
    if not files:
        return ()
    with temporary_folder() as folder:
        root = Path(folder)
        _link(root, files)
        found = mistakes_of(*_checks(root, files))
        return tuple(
            dict.fromkeys(
                replace(each, path=origin(each.path), message=each.message.replace(f"{root}/", "")) for each in found
            )
        )


def _link(root: Path, files: Mapping[str, Path]) -> None:
    """Puts links to the files in use, and to these in their places, under `root`."""
    for folder in (rules_folder(), lexicon_folder()):
        inside = (path for path in folder.rglob("*.*") if path.suffix in AUTHORED and path.is_file())
        for name, path in ({name_in_checkout(path): origin(path) for path in inside}).items():
            _link_one(root / name, files.get(name, path))
    for name, path in files.items():
        _link_one(root / name, path)


def _link_one(link: Path, target: Path) -> None:
    if not link.is_symlink():
        link.parent.mkdir(parents=True, exist_ok=True)
        link.symlink_to(target)


def _checks(root: Path, files: Mapping[str, Path]) -> Iterator[Check]:
    """What reads the files that are under `root`, for each kind among them once."""
    lexicon = root / name_in_checkout(lexicon_folder())
    kinds = {_kind(name) for name in files}
    if kinds & {"rules", "en"}:
        yield partial(compile_rules, root, load_characters().callable_names)
    if kinds & {"gestures", "characters", "behaviors"}:
        yield partial(_check_bodies, lexicon, has_gestures="gestures" in kinds)
    if kinds & {"acting", "behaviors"}:
        yield partial(_check_families, lexicon)
    if any(name.endswith(WEIGHTS) for name in files):
        yield partial(check_weights, lexicon / WEIGHTS)
    yield from (partial(check_profile, root / name) for name in files if _kind(name) == "profiles")


def _kind(name: str) -> str:
    """What a file is, by its name in a checkout: the folder in the lexicon, or rules."""
    lexicon = f"{name_in_checkout(lexicon_folder())}/"
    return name.removeprefix(lexicon).partition("/")[0] if name.startswith(lexicon) else "rules"


def _check_bodies(lexicon: Path, *, has_gestures: bool) -> None:
    """Raises AuthoringError for every mistake in gestures and characters, else for gestures that are shown by none."""
    found: list[Mistake] = []
    library = collected(lambda: Library.load(lexicon / "gestures"), found) if has_gestures else load_gestures()
    collected(lambda: Characters.load(lexicon), found)
    if library is not None and not found:
        check_coverage(lexicon, library)
    if found:
        raise AuthoringError(tuple(found))


def _check_families(lexicon: Path) -> None:
    """Raises AuthoringError for families with mistakes; where the table beside them has some, that in use stands for
    it."""
    table = collected(lambda: load_table(lexicon / "behaviors.yaml"), []) or load_table(
        lexicon_folder() / "behaviors.yaml"
    )
    load_families(lexicon / FAMILIES, table.lines)


def _placed(files: Sequence[Path]) -> Iterator[tuple[str, Path]]:
    """Those of the files that have a place in an author's folder, by their names in a checkout: the one that they are
    in says which, else their suffix and text. Words are read with those beside them."""
    lexicon, rules = name_in_checkout(lexicon_folder()), name_in_checkout(rules_folder())
    for kind, own in _by_kind([file for file in files if file.suffix == ".rules"]).items():
        yield from ((f"{rules}/{kind}/{file.name}", file) for file in own)
    for file in files:
        folder = file.parent.name
        if file.suffix == SUFFIX:
            yield f"{lexicon}/gestures/{file.name}", file
        elif folder in {"characters", "profiles"}:
            yield f"{lexicon}/{folder}/{file.name}", file
        elif file.name in _ADDED_TO:
            yield f"{lexicon}/{_ADDED_TO[file.name]}/{LAST}", file
        elif file.suffix == ".yaml" and file.name not in NAMED_FILES and folder != "retarget":
            words = (each for each in file.parent.glob("*.yaml") if each.name not in NAMED_FILES)
            yield from ((f"{lexicon}/en/{each.name}", each) for each in words)


def _authored_files(path: Path) -> list[Path]:
    """The authored files in `path`, or the file itself."""
    inside = sorted(path.resolve().rglob("*")) if path.is_dir() else [path.resolve()]
    files = [file for file in inside if file.suffix in AUTHORED and file.is_file()]
    if not files:
        raise InputError(
            "no_authored_file", f"{path}: no .rules, .yaml or .gesture file is there; give a file or folder of them"
        )
    for file in files:
        _require_text(file)
    return files


def _require_text(file: Path) -> None:
    try:
        file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError("file_unreadable", f"{file}: cannot be read as UTF-8 text: {error}") from None


def _by_kind(files: Sequence[Path]) -> Mapping[str, Sequence[Path]]:
    """The rules by the folder in which they would be: their own, else as their text chooses movements or does not."""
    kinds: dict[str, list[Path]] = {}
    for file in files:
        chooses = _CHOOSES.search(file.read_text(encoding="utf-8")) is not None
        default_kind = "behaviors" if chooses else "functions"
        kinds.setdefault(
            file.parent.name if file.parent.name in ("functions", "behaviors") else default_kind, []
        ).append(file)
    return kinds
