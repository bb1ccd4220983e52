"""Checks authored files: all those in use, or others before they are put to use."""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from types import MappingProxyType

from pydantic import RootModel

from ..acoustic.pacing.phone_durations import FILE as PHONE_DURATIONS
from ..acoustic.pacing.phone_durations import PhoneDurations
from ..acoustic.pacing.word_times import FILE as PACING
from ..acoustic.pacing.word_times import PauseTable
from ..acoustic.pronunciation.normalisation import Normaliser
from ..authored_folders import lexicon_folder, tables_of
from ..behavior.candidates.attitudes import load_attitudes
from ..behavior.characters.overlays import Characters
from ..behavior.listeners.listening import HeadRates
from ..behavior.reading.choice_model import ChoiceModel
from ..behavior.reading.families import load_families
from ..behavior.reading.mimes import MimeTable
from ..behavior.reading.planner import TermNames, load_weights
from ..behavior.reading.terms import TermTable
from ..behavior.slots.table import SlotTable
from ..behavior.table.behavior_table import BehaviorEntry, load_table
from ..bml.reading.element_behaviors import FILE as BML_ALIASES
from ..bml.reading.element_behaviors import LexemeAliases
from ..bml.writing.smartbody_tables import FILE as SMARTBODY
from ..bml.writing.smartbody_tables import SmartBodyTables
from ..errors import AuthoringError, Mistake, collected
from ..files import resource_folder
from ..live.table import FILE as LIVE
from ..live.table import LiveTable
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
from ..realizer.gestures.library import ALIASES, Library, gesture_files, read_aliases, read_definitions
from ..realizer.mpeg4.fap import TABLE as FAPS
from ..realizer.mpeg4.fap import FapTable
from ..rules.priorities import Conflicts, Priorities
from ..text.tag_table import FILE as TAGS
from ..text.tag_table import TagTable
from ..yaml_files import Source, entry_source, has_key

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


def check_weights(file: Path) -> None:
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
        "weights.yaml": check_weights,
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
    mistakes = mistakes_of(
        load_function_rules,
        lambda: refuse_unread_words(lexicon / "en"),
        partial(Normaliser.load, lexicon / "en" / "abbreviations.yaml", ()),
        lambda: load_mapping_rules(load_characters().callable_names),
        load_gestures,
        partial(FaceTables.load, lexicon / "face.yaml"),
        partial(MovementStyle.load, lexicon / "movement.yaml"),
        lambda: load_families(lexicon / "acting" / "families.yaml", load_table(lexicon / "behaviors.yaml").lines),
        lambda: _check_attitudes(lexicon / "acting" / "attitudes.yaml"),
        lambda: _check_slots(lexicon / "acting" / "slots.yaml"),
        lambda: _check_mimes(lexicon / "acting" / "mimes.yaml"),
        lambda: check_weights(lexicon / "acting" / "weights.yaml"),
        partial(HeadRates.load, lexicon / "acting" / "head_rates.yaml"),
        partial(SmartBodyTables.load, lexicon / SMARTBODY),
        partial(FapTable.load, lexicon / FAPS),
        partial(LexemeAliases.load, lexicon / BML_ALIASES),
        lambda: LiveTable.load(lexicon / LIVE, load_characters().behavior_names),
        partial(PhoneDurations.load, lexicon / PHONE_DURATIONS),
        partial(PauseTable.load, lexicon / PACING),
        lambda: TagTable.load(lexicon / TAGS, load_function_classes()),
        partial(load_rigs, lexicon / "retarget", Skeleton.standing()),
    ) or mistakes_of(
        lambda: check_coverage(lexicon, load_gestures()),
        lambda: MovementStyle.load(lexicon / "movement.yaml", load_gestures().categories),
        lambda: _check_terms(lexicon / "acting" / "terms.yaml"),
        *(partial(check_profile, file) for file in sorted((lexicon / "profiles").glob("*.yaml"))),
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


def _unshown(source: Source, entry: BehaviorEntry, library: Library) -> Iterator[Mistake]:
    if entry.channel is not Channel.GESTURE:
        return
    for hand in (entry.hand,) if entry.hand else (Hand.LEFT, Hand.RIGHT):
        missing = [level for level in Level if not library.clips(entry.lexeme, level, hand)]
        if missing:
            message = f"no gesture shows {entry.lexeme} at {', '.join(missing)} agitation with hand {hand}"
            yield source.mistake(("behaviors", entry.name), message)


def check_profile(file: Path) -> None:
    """Raises AuthoringError for a gesture profile with mistakes."""
    load_profile_file(file, load_characters().gesture_lexemes)


def _definitions_beside(aliases: Path) -> tuple[Definition, ...]:
    return read_definitions(gesture_files([aliases.parent]))


def refuse_unread_words(folder: Path) -> None:
    """Raises AuthoringError for files in a folder of words that nothing would read."""
    files = sorted(folder.glob("*.yaml"))
    unread = [file for file in files if file.name not in NAMED_FILES and not has_key(file, "class")]
    if unread:
        raise AuthoringError(tuple(Mistake(file, 1, 1, "a file of words begins with its `class`") for file in unread))


def mistakes_of(*checks: Check) -> list[Mistake]:
    """The mistakes that the checks raise, without duplicates: gestures are also read for their aliases."""
    mistakes: list[Mistake] = []
    for check in checks:
        collected(check, mistakes)
    return list(dict.fromkeys(mistakes))
