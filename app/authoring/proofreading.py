"""Checks authored files: all those in use, or others before they are put to use."""

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping, Sequence
from functools import partial
from pathlib import Path
from types import MappingProxyType

from pydantic import RootModel

from ..acoustic.pacing.pacing import FILE as PACING
from ..acoustic.pacing.pacing import PauseTable
from ..acoustic.pacing.phone_durations import FILE as PHONE_DURATIONS
from ..acoustic.pacing.phone_durations import PhoneDurations
from ..acoustic.pronunciation.normalisation import Normaliser
from ..authored_folders import AUTHORED, lexicon_folder, rules_folder, tables_of
from ..behavior.candidates.attitudes import load_attitudes
from ..behavior.candidates.vocabulary import BANNABLE
from ..behavior.characters.overlays import Characters
from ..behavior.listeners.listening import HeadRates
from ..behavior.reading.authored_weights import TermNames, load_weights
from ..behavior.reading.choice_model import ChoiceModel
from ..behavior.reading.families import load_families
from ..behavior.reading.mimes import MimeTable
from ..behavior.reading.terms import TermTable
from ..behavior.slots.table import SlotTable
from ..behavior.table.behavior_table import BehaviorEntry, load_table
from ..bml.reading.element_behaviors import FILE as BML_ALIASES
from ..bml.reading.element_behaviors import LexemeAliases
from ..bml.writing.smartbody_tables import FILE as SMARTBODY
from ..bml.writing.smartbody_tables import SmartBodyTables
from ..errors import AuthoringError, InputError, Mistake, collected
from ..live.table import FILE as LIVE
from ..live.table import LiveTable
from ..marked_text.tag_table import FILE as TAGS
from ..marked_text.tag_table import TagTable
from ..model import Channel, Hand, Level
from ..models import (
    load_characters,
    load_function_classes,
    load_function_rules,
    load_gestures,
    load_mapping_rules,
    load_profile_file,
)
from ..realizer.body.movement_style import MovementStyle
from ..realizer.body.skeleton import Skeleton
from ..realizer.exporting.retargeting import load_rigs
from ..realizer.face.face_tables import FaceTables
from ..realizer.gestures.gesture import Definition
from ..realizer.gestures.library import ALIASES, SUFFIX, Library, gesture_files, read_aliases, read_definitions
from ..realizer.mpeg4.fap import TABLE as FAPS
from ..realizer.mpeg4.fap import FapTable
from ..resources import resource_folder
from ..rules.lexicon import Lexicon
from ..rules.priorities import Conflicts, Priorities
from ..rules.program.program import PRINTED, load_program
from ..yaml_files import Source, entry_source

VOCABULARY = "vocabulary.rules"
_CHOOSES = re.compile(r"^\s*(choose|never|always)\b", re.MULTILINE)
Check = Callable[[], object]
"""Loads something, and raises AuthoringError if it has mistakes."""


def _check_attitudes(file: Path) -> None:
    lexicon = lexicon_folder()
    lines = load_table(lexicon / "behaviors.yaml").lines
    load_attitudes(file, lines, load_families(lexicon / "acting" / "families.yaml", lines).face)


def _check_slots(file: Path) -> None:
    lexicon = lexicon_folder()
    families = load_families(lexicon / "acting" / "families.yaml", load_table(lexicon / "behaviors.yaml").lines)
    SlotTable.load(file, families.shows)


def _check_mimes(file: Path) -> None:
    lexicon = resource_folder("lexicon")
    families = load_families(lexicon / "acting" / "families.yaml", load_table(lexicon / "behaviors.yaml").lines)
    MimeTable.load(file, families.gesture_names)


def _check_weights(file: Path) -> None:
    choice = ChoiceModel.load(resource_folder("models") / "acting" / "weights.json")
    table = TermTable.load(lexicon_folder() / "acting" / "terms.yaml", load_function_rules().program.argument_counts)
    names = TermNames.of(choice.terms, table.names.values(), load_function_classes())
    load_weights(file, choice.families, names, (*choice.head, *choice.face))


def _check_column_names(file: Path) -> None:
    """Checks its shape alone: the field names are known only to `batch`, which imports this package."""
    Source(file).validated(RootModel[dict[str, list[str]]])


def _check_terms(file: Path) -> None:
    TermTable.load(file, load_function_rules().program.argument_counts)


NAMED_FILES: Mapping[str, Callable[[Path], object]] = MappingProxyType(
    {
        "conflicts.yaml": lambda file: Source(file).validated(Conflicts),
        "priorities.yaml": Priorities.load,
        "abbreviations.yaml": lambda file: Normaliser.load(file, ()),
        "behaviors.yaml": load_table,
        "face.yaml": FaceTables.load,
        "movement.yaml": MovementStyle.load,
        "families.yaml": lambda file: load_families(file, load_table(lexicon_folder() / "behaviors.yaml").lines),
        "attitudes.yaml": _check_attitudes,
        "slots.yaml": _check_slots,
        "mimes.yaml": _check_mimes,
        "weights.yaml": _check_weights,
        "terms.yaml": _check_terms,
        "head_rates.yaml": HeadRates.load,
        "columns.yaml": _check_column_names,
        SMARTBODY: SmartBodyTables.load,
        BML_ALIASES: LexemeAliases.load,
        FAPS: FapTable.load,
        LIVE: lambda file: LiveTable.load(file, load_characters().behavior_names),
        PHONE_DURATIONS: PhoneDurations.load,
        PACING: PauseTable.load,
        TAGS: lambda file: TagTable.load(file, load_function_classes()),
        ALIASES: lambda file: read_aliases(file, Library.of(_definitions_beside(file)).categories),
    }
)
"""The loaders of YAML files with fixed names; others hold words or, in folders `characters`, `profiles` and
`retarget`, a character, a gesture profile or the joint names of a rig."""


def check_files_in_use() -> None:
    """Check all files in use. Raises AuthoringError with all mistakes.

    Mapping rules are checked against the behaviour table, so mistakes in the table hide theirs; missing gestures for
    the table, and terms of no predicate, are reported only if there are no other mistakes.
    """
    lexicon = lexicon_folder()
    mistakes = _mistakes_of(
        load_function_rules,
        partial(Normaliser.load, lexicon / "en" / "abbreviations.yaml", ()),
        lambda: load_mapping_rules(load_characters().behavior_names),
        load_gestures,
        partial(FaceTables.load, lexicon / "face.yaml"),
        partial(MovementStyle.load, lexicon / "movement.yaml"),
        lambda: load_families(lexicon / "acting" / "families.yaml", load_table(lexicon / "behaviors.yaml").lines),
        lambda: _check_attitudes(lexicon / "acting" / "attitudes.yaml"),
        lambda: _check_slots(lexicon / "acting" / "slots.yaml"),
        lambda: _check_mimes(lexicon / "acting" / "mimes.yaml"),
        lambda: _check_weights(lexicon / "acting" / "weights.yaml"),
        partial(HeadRates.load, lexicon / "acting" / "head_rates.yaml"),
        partial(SmartBodyTables.load, lexicon / SMARTBODY),
        partial(FapTable.load, lexicon / FAPS),
        partial(LexemeAliases.load, lexicon / BML_ALIASES),
        lambda: LiveTable.load(lexicon / LIVE, load_characters().behavior_names),
        partial(PhoneDurations.load, lexicon / PHONE_DURATIONS),
        partial(PauseTable.load, lexicon / PACING),
        lambda: TagTable.load(lexicon / TAGS, load_function_classes()),
        partial(load_rigs, lexicon / "retarget", Skeleton.standing()),
    ) or _mistakes_of(
        lambda: check_coverage(lexicon, load_gestures()),
        lambda: _check_terms(lexicon / "acting" / "terms.yaml"),
        *(partial(_check_profile, file) for file in sorted((lexicon / "profiles").glob("*.yaml"))),
    )
    if mistakes:
        raise AuthoringError(tuple(mistakes))


def check_coverage(lexicon: Path, library: Library) -> None:
    """Raises AuthoringError for every entry of the table or of a character for which the library has no gesture, at
    each level of agitation and with the entry's hand, or either."""
    table = load_table(lexicon / "behaviors.yaml")
    sources = [Source(each) for each in tables_of(lexicon / "behaviors.yaml")]
    mistakes = [
        found
        for name in table.lines
        for found in _unshown(entry_source(sources, "behaviors", name), table.entry(name), library)
    ]
    for character in Characters.load(lexicon).by_name.values():
        source = Source(lexicon / "characters" / f"{character.name}.yaml")
        for entry in character.entries.values():
            usual = table.entry(entry.name)
            if (entry.lexeme, entry.hand) != (usual.lexeme, usual.hand):
                mistakes += _unshown(source, entry, library)
    if mistakes:
        raise AuthoringError(tuple(mistakes))


def check_files(paths: Iterable[Path]) -> int:
    """Check these files, and all authored files in these folders, instead of those in use; returns their number.

    Rule files are read with those in use, unless there is a vocabulary among them; gesture files as one library. Raises
    AuthoringError with all mistakes in them (or, if they have none, in the files they are read with), InputError
    `no_authored_file` for a path without any.
    """
    files = [file for path in paths for file in _authored_files(path)]
    rules = [file for file in files if file.suffix == ".rules"]
    gestures = [file for file in files if file.suffix == SUFFIX]
    checks = dict(_check_of(file) for file in files if file.suffix == ".yaml")
    mistakes = _mistakes_of(partial(_load_rules, rules), partial(read_definitions, gestures), *checks.values())
    if mistakes:
        raise AuthoringError(tuple(mistake for mistake in mistakes if mistake.path in files) or tuple(mistakes))
    return len(files)


def _unshown(source: Source, entry: BehaviorEntry, library: Library) -> Iterator[Mistake]:
    if entry.channel is not Channel.GESTURE:
        return
    for hand in (entry.hand,) if entry.hand else (Hand.LEFT, Hand.RIGHT):
        missing = [level for level in Level if not library.clips(entry.lexeme, level, hand)]
        if missing:
            told = f"no gesture shows {entry.lexeme} at {', '.join(missing)} agitation with hand {hand}"
            yield source.mistake(("behaviors", entry.name), told)


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


def _load_rules(files: Sequence[Path]) -> None:
    """Reads rules as they would be read if they were in use: function rules and mapping rules apart, each with those in
    use, of which one with the same name gives way. A folder with a vocabulary of its own is a program by itself."""
    behaviors = load_characters().behavior_names
    read = partial(load_program, behaviors=behaviors, bannable=BANNABLE, printed=PRINTED)
    if any(file.name == VOCABULARY for file in files):
        read(files)
        return
    rules = rules_folder()
    for kind, own in _by_kind(files).items():
        names = {file.name for file in own}
        used = [file for file in sorted((rules / kind).glob("*.rules")) if file.name not in names]
        read([rules / VOCABULARY, *used, *own])


def _by_kind(files: Sequence[Path]) -> Mapping[str, Sequence[Path]]:
    """The rules by the folder in which they would be: their own, else as their text chooses movements or does not."""
    kinds: dict[str, list[Path]] = {}
    for file in files:
        chooses = _CHOOSES.search(file.read_text(encoding="utf-8")) is not None
        told = "behaviors" if chooses else "functions"
        kinds.setdefault(file.parent.name if file.parent.name in ("functions", "behaviors") else told, []).append(file)
    return kinds


def _check_of(file: Path) -> tuple[tuple[str, Path], Check]:
    """The loader of a YAML file, with a key so that files that are read together are read once."""
    folder = file.parent
    if file.name in NAMED_FILES:
        return (file.name, file), partial(NAMED_FILES[file.name], file)
    if folder.name == "characters":
        return ("characters", folder), partial(_load_characters, folder.parent)
    if folder.name == "profiles":
        return ("profile", file), partial(_check_profile, file)
    if folder.name == "retarget":
        return ("rigs", folder), partial(load_rigs, folder, Skeleton.standing())
    return ("words", folder), partial(_load_words, folder)


def _load_characters(lexicon: Path) -> None:
    """Raises InputError `no_behavior_table` if there is no table for the characters to override."""
    if not (lexicon / "behaviors.yaml").is_file():
        raise InputError("no_behavior_table", f"{lexicon}: characters need the behaviors.yaml that they change here")
    Characters.load(lexicon)


def _check_profile(file: Path) -> None:
    load_profile_file(file, load_characters().gesture_lexemes)


def _definitions_beside(aliases: Path) -> tuple[Definition, ...]:
    return read_definitions(gesture_files([aliases.parent]))


def _load_words(folder: Path) -> None:
    refuse_unread_words(folder)
    Lexicon.load(folder)


def refuse_unread_words(folder: Path) -> None:
    """Raises AuthoringError for files in a folder of words that nothing would read."""
    files = sorted(folder.glob("*.yaml"))
    unread = [file for file in files if file.name not in NAMED_FILES and "class" not in _keys(file)]
    if unread:
        raise AuthoringError(tuple(Mistake(file, 1, 1, "a file of words begins with its `class`") for file in unread))


def _keys(file: Path) -> Collection[str]:
    value = Source(file).value
    return value if isinstance(value, dict) else ()


def _mistakes_of(*checks: Check) -> list[Mistake]:
    """The mistakes that the checks raise, without duplicates: gestures are also read for their aliases."""
    mistakes: list[Mistake] = []
    for check in checks:
        collected(check, mistakes)
    return list(dict.fromkeys(mistakes))
