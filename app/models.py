"""What is loaded once and shared by all performances: the models of the stages, and the files that authors edit.

The compiled results are cached between processes (`understudy.cache`). Mistakes in files are not cached, so they are
reported every time. Each function imports what it loads, because no command needs all of it.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Self

from threadpoolctl import threadpool_limits

from .authored_folders import AUTHORED, laid_over, lexicon_folder, rules_folder, tables_of
from .cache import Cache
from .errors import InputError, did_you_mean, shown
from .files import RULES, resource_folder
from .loading import OnDemand

if TYPE_CHECKING:
    from .acoustic.models import AcousticModels
    from .behavior.candidates.attitudes import Attitude
    from .behavior.characters.gesture_forms import FormedCharacters
    from .behavior.characters.overlays import Characters
    from .behavior.listeners.listening import HeadRates
    from .behavior.reading.families import Families
    from .behavior.reading.planner import Planner
    from .behavior.slots.table import SlotTable
    from .model import CallableNames, Tone
    from .model.limits import GestureTable
    from .profiles.profile import Profile
    from .realizer.gestures.library import Library
    from .realizer.realizing import Realizer
    from .rules.derivation import FunctionRules
    from .rules.mapping import MappingRules
    from .settings import Settings
    from .syntax.parser import Parser
    from .text.tag_table import TagTable


@dataclass(frozen=True, slots=True)
class Understudy:
    """All models, loaded once and shared by threads. `close` (or a `with` block) ends the aligner's process.

    The realizer is loaded on first use: most performances are never realized. So are the acoustic models if it was
    loaded `for_words`.
    """

    when_hearing: OnDemand[AcousticModels]
    language: LanguageModels
    behavior: BehaviorModels
    when_realizing: OnDemand[Realizer]

    @classmethod
    def load(cls, settings: Settings) -> Self:
        """Loads all but the realizer, authored files first because they may have mistakes. Raises as the loading of
        each does.

        From then on BLAS uses a single thread in the whole process: a line is too short to gain from more.
        """
        threadpool_limits(limits=1, user_api="blas")
        understudy = cls.for_words(settings)
        understudy.when_hearing.get()
        return understudy

    @classmethod
    def for_words(cls, settings: Settings) -> Self:
        """The same without the acoustic models, which are loaded on first use."""

        def ears() -> AcousticModels:
            from .acoustic.models import AcousticModels

            return AcousticModels.load(settings)

        with laid_over(settings.lexicon_folders):
            return cls(
                behavior=BehaviorModels.load(settings),
                language=LanguageModels.load(settings),
                when_hearing=OnDemand(ears),
                when_realizing=OnDemand(load_realizer),
            )

    @property
    def acoustic(self) -> AcousticModels:
        """The acoustic models; on first use raises ServiceError when one of them is missing or broken."""
        return self.when_hearing.get()

    @property
    def realizer(self) -> Realizer:
        """The realizer; on first use raises AuthoringError with the mistakes of gestures, face and rigs."""
        return self.when_realizing.get()

    def with_settings(self, settings: Settings) -> Self:
        """The same models with other limits; settings of what is already loaded have no effect."""
        return replace(
            self,
            when_hearing=OnDemand.ready(replace(self.acoustic, settings=settings)),
            language=replace(self.language, settings=settings),
            behavior=replace(self.behavior, settings=settings),
        )

    def close(self) -> None:
        acoustic = self.when_hearing.made()
        if acoustic is not None:
            acoustic.close()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_exception: object) -> None:
        self.close()


@dataclass(frozen=True, slots=True)
class LanguageModels:
    """The models of the language stage (paper §3.2, §3.3)."""

    settings: Settings
    parser: Parser
    rules: FunctionRules

    @classmethod
    def load(cls, settings: Settings) -> LanguageModels:
        """Raises AuthoringError with every mistake in words and rules, ServiceError when the parser does not load."""
        from .syntax.parser import Parser

        return cls(
            settings=settings,
            parser=Parser.load(settings.parser or resource_folder("models") / "parser"),
            rules=load_function_rules(),
        )


@dataclass(frozen=True, slots=True)
class BehaviorModels:
    """The models that choose and schedule behaviours (paper §3.4, §3.5)."""

    settings: Settings
    characters: Characters
    rules: MappingRules
    families: Families
    attitudes: Mapping[Tone, Attitude]
    planner: Planner
    slots: SlotTable
    head_rates: HeadRates
    performers: FormedCharacters
    profiles: Mapping[str, OnDemand[Profile]]

    @classmethod
    def load(cls, settings: Settings) -> Self:
        """Raises AuthoringError with every mistake in characters, behaviour table, families and mapping rules,
        ServiceError when a model is missing or broken."""
        from .behavior.candidates.attitudes import load_attitudes
        from .behavior.characters.gesture_forms import FormedCharacters
        from .behavior.listeners.listening import HeadRates
        from .behavior.reading.planner import Planner

        lexicon = lexicon_folder()
        characters = load_characters()
        families = load_families(characters)
        rules, models = load_mapping_rules(characters.callable_names), resource_folder("models")
        return cls(
            settings=settings,
            characters=characters,
            rules=rules,
            families=families,
            attitudes=load_attitudes(lexicon / "acting" / "attitudes.yaml", characters.behavior_names, families.face),
            planner=Planner.load(
                (models / "acting", lexicon / "acting"),
                families,
                rules.program.argument_counts,
                load_function_classes(),
            ),
            slots=load_slots(families),
            head_rates=HeadRates.load(lexicon / "acting" / "head_rates.yaml"),
            performers=FormedCharacters.of(characters, load_gesture_table(characters.gesture_lexemes)),
            profiles={
                name: OnDemand(partial(load_profile, name, characters.gesture_lexemes)) for name in profile_names()
            },
        )

    def profile(self, profile: Profile | str | None) -> Profile | None:
        """The profile, loaded from the lexicon if given by name; raises InputError `unknown_profile`."""
        if not isinstance(profile, str):
            return profile
        if profile not in self.profiles:
            return load_profile(profile, self.characters.gesture_lexemes)
        return self.profiles[profile].get()


def load_function_rules() -> FunctionRules:
    """The current function rules and words; raises AuthoringError with every mistake in them."""
    from .rules.derivation import FunctionRules

    words = lexicon_folder() / "en"
    rules = rules_folder(RULES)
    files = [*_authored(rules), *_authored(words)]
    return Cache.of_environment().kept("function_rules", files, lambda: FunctionRules.load(rules, words))


def load_characters() -> Characters:
    """The current behaviour table and characters; raises AuthoringError with every mistake in them."""
    from .behavior.characters.overlays import Characters

    folder = lexicon_folder()
    return Cache.of_environment().kept("characters", _character_files(), lambda: Characters.load(folder))


def _character_files() -> list[Path]:
    lexicon = lexicon_folder()
    return [*tables_of(lexicon / "behaviors.yaml"), *_authored(lexicon / "characters")]


def load_families(characters: Characters) -> Families:
    """The behaviours that show planned moments, by family; raises AuthoringError with every mistake in them."""
    from .behavior.reading.families import load_families as load
    from .model import DEFAULT_CHARACTER

    path, entries = lexicon_folder() / "acting" / "families.yaml", characters.named(DEFAULT_CHARACTER).entries
    files = [*tables_of(path), *_character_files()]
    return Cache.of_environment().kept("families", files, lambda: load(path, entries))


def load_slots(families: Families) -> SlotTable:
    """What words say of size and place; raises AuthoringError with every mistake in the file."""
    from .behavior.slots.table import SlotTable

    path, shows = lexicon_folder() / "acting" / "slots.yaml", families.shows
    return Cache.of_environment().kept("slots", [path], lambda: SlotTable.load(path, shows), made_with=str(shows))


def load_mapping_rules(names: CallableNames) -> MappingRules:
    """The current mapping rules, which call these `names`; raises AuthoringError with all mistakes in them."""
    from .rules.mapping import MappingRules

    rules, cache = rules_folder(RULES), Cache.of_environment()
    told = " ".join(sorted(names.behaviors | names.demandable | names.bannable))
    return cache.kept("mapping_rules", _authored(rules), lambda: MappingRules.load(rules, names), made_with=told)


def load_gestures() -> Library:
    """The current gesture library; raises AuthoringError with every mistake in it."""
    from .realizer.gestures.library import Library

    folder = lexicon_folder() / "gestures"
    return Cache.of_environment().kept("gestures", _authored(folder), lambda: Library.load(folder))


def load_gesture_table(lexemes: Collection[str]) -> GestureTable:
    """What the scheduler needs to know of the gestures with these lexemes; raises as `load_gestures` does."""

    def made() -> GestureTable:
        from .realizer.scheduling.gesture_table import gesture_table

        return gesture_table(load_gestures(), lexemes)

    folder, names = lexicon_folder() / "gestures", " ".join(sorted(lexemes))
    return Cache.of_environment().kept("gesture_table", _authored(folder), made, made_with=names)


def profile_names() -> tuple[str, ...]:
    """The names of the gesture profiles in the lexicon."""
    return tuple(sorted(path.stem for path in (lexicon_folder() / "profiles").glob("*.yaml")))


def load_profile(name: str, lexemes: Collection[str]) -> Profile:
    """The gesture profile of that name; its gestures must be among `lexemes`.

    Raises InputError `unknown_profile`, and AuthoringError with every mistake in its file.
    """
    if name not in profile_names():
        raise _unknown_profile(name)
    return load_profile_file(lexicon_folder() / "profiles" / f"{name}.yaml", lexemes)


def usable_profile(name: str, folder: Path = Path()) -> Profile | str:
    """Resolves the name of a profile: one in the lexicon is returned as its name, a file in `folder` that ends in .yaml
    is loaded.

    Raises as `load_profile` does, before anything large is loaded.
    """
    if name.endswith(".yaml"):
        return load_profile_file(folder / name, load_characters().gesture_lexemes)
    if name not in profile_names():
        raise _unknown_profile(name)
    return name


def load_profile_file(path: Path, lexemes: Collection[str]) -> Profile:
    """The gesture profile in a file; raises AuthoringError with every mistake in it."""
    from .profiles.files.reading import read_profile

    return read_profile(path, lexemes, load_tags())


def load_function_classes() -> Mapping[str, Mapping[str, float]]:
    """The classes of functions, with their subtypes and base priorities; raises AuthoringError with every mistake in
    their table."""
    from .rules.priorities import Priorities

    return Priorities.load(rules_folder(RULES) / "functions" / "priorities.yaml").root


def load_tag_table() -> TagTable:
    """What tags of a text that is to be spoken mean; raises AuthoringError with every mistake in their table."""
    from .text.tag_table import FILE, TagTable

    return TagTable.load(lexicon_folder() / FILE, load_function_classes())


def load_tags() -> frozenset[str]:
    """The semantic tags that words can have: classes of functions, and `class.subtype`; raises AuthoringError with
    every mistake in their table."""
    from .profiles.profile import every_tag
    from .rules.priorities import Priorities

    return every_tag(Priorities.load(rules_folder(RULES) / "functions" / "priorities.yaml").root)


def load_realizer() -> Realizer:
    """The current bodies, gestures, face and rigs; raises AuthoringError with the mistakes of the first kind of file
    that has any."""
    from .realizer.realizing import Realizer

    figures = {character.name: character.figure for character in load_characters().by_name.values()}
    return Realizer.with_library(load_gestures(), lexicon_folder(), figures)


def _unknown_profile(name: str) -> InputError:
    known = profile_names()
    message = f"there is no profile {shown(name)}{did_you_mean(name, known)}; there are {', '.join(known)}"
    return InputError("unknown_profile", message, field="profile")


def _authored(folder: Path) -> list[Path]:
    """The files in a folder and its subfolders that authors edit, sorted."""
    return sorted(path for path in folder.rglob("*.*") if path.suffix in AUTHORED)
