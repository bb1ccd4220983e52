"""Schedules of whole texts: how many functions are shown, how often hands move, whether every schedule is valid.

    python -m benchmarks.bml.schedule [--texts FILE.jsonl | --sentences N] [--character NAME] [--seed N] [--seeds N]

FILE has an object with "text" on each line (default: ../shared/data/functions/dev.jsonl); `--sentences` takes the first
N spoken sentences of GUM (../shared/data/treebanks/spoken-dev.conllu, then spoken-test.conllu) instead. The words get
made-up times (13 letters a second, pauses at punctuation, one word in eight emphasised); the stages from the parser on
are real. `--seeds` compares the schedules of each text under so many seeds. Each is also written relative to the marks
of its words, and no point may then resolve below `FIRST_MOMENT_S`, added up as a realizer does.
"""

import argparse
import json
import random
import statistics
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import combinations, islice, pairwise
from pathlib import Path

from benchmarks.figures import add_record_option, record
from tests.support.bml.bml_checker import check
from understudy.behavior.candidates.planned import candidates_of
from understudy.behavior.characters.overlays import Character
from understudy.behavior.choice.scheduling import schedule
from understudy.behavior.reading.planning import Understood, plan
from understudy.behavior.reading.player import Player
from understudy.behavior.speech import visemes
from understudy.bml.markup.documents import Reference
from understudy.bml.markup.speech import FIRST_MOMENT_S
from understudy.bml.writing.writer import to_document, write_bml
from understudy.files import RULES, resource_folder
from understudy.model import (
    Agitation,
    Analysis,
    Behavior,
    BehaviorCandidates,
    Channel,
    Function,
    Hand,
    Interval,
    Level,
    Mode,
    Performance,
    Phone,
    Utterance,
    Word,
)
from understudy.model.formats import BmlForm, TimeForm
from understudy.models import BehaviorModels
from understudy.rules.derivation import FunctionRules, understand
from understudy.rules.mapping import MappingRules, offer_movements
from understudy.settings import Settings
from understudy.syntax.parser import Parser
from understudy.text.transcript import read_transcript

DATA = Path(__file__).resolve().parents[3] / "shared" / "data"
TREEBANKS = DATA / "treebanks"
TEXTS = DATA / "functions" / "dev.jsonl"
ROUNDING_S = 0.0006
"""Marks are written as the times of words rounded to a millisecond."""


@dataclass(frozen=True, slots=True)
class Outcome:
    """A line's functions and behaviours, and what it took."""

    functions: tuple[Function, ...]
    behaviors: tuple[Behavior, ...]
    duration_s: float
    words: int
    mistakes: tuple[str, ...]
    early: int
    mapping_ms: float
    schedule_ms: float
    write_ms: float


def timed(words: tuple[Word, ...], generator: random.Random) -> Iterator[Word]:
    """The words with made-up times; the stressed vowel begins after a third of the word."""
    now_s = 0.2
    for word in words:
        end_s = now_s + 0.1 + len(word.text) / 13
        vowel = Phone("AH", Interval(now_s + (end_s - now_s) / 3, end_s), stress=1)
        emphasis = 0.6 if generator.random() < 1 / 8 else 0.0
        yield replace(word, interval=Interval(now_s, end_s), phones=(vowel,), emphasis=emphasis)
        now_s = end_s + (0.35 if word.text[-1] in ",.;:?!" else 0.0)


@dataclass(frozen=True, slots=True)
class Stages:
    """The loaded stages from the parser on."""

    parser: Parser
    functions: FunctionRules
    behavior: BehaviorModels
    character: Character

    @property
    def mapping(self) -> MappingRules:
        return self.behavior.rules

    @classmethod
    def load(cls, character: str) -> "Stages":
        lexicon = resource_folder("lexicon")
        behavior = BehaviorModels.load(Settings())
        return cls(
            Parser.load(resource_folder("models") / "parser"),
            FunctionRules.load(RULES, lexicon / "en"),
            behavior,
            behavior.performers.named(character, Level.MEDIUM),
        )

    def candidates(self, utterance: Utterance, known: Analysis, seed: int) -> tuple[BehaviorCandidates, ...]:
        """What could show the functions and the moments planned, as in `understudy.performance.perform_line`."""
        offers = offer_movements(self.mapping, utterance, known.functions, seed=seed, facts=known.facts)
        who = Player(self.behavior.families, self.character.entries, seed, self.character.liveliness)
        planned = plan(self.behavior.planner, Understood(utterance, known.functions, known.facts, offers), who)
        return candidates_of(who, utterance, planned, offers)


def outcome(stages: Stages, text: str, seed: int, mode: Mode = Mode.SEMANTIC) -> Outcome:
    """The text, as if read at medium agitation."""
    words = tuple(timed(read_transcript(text), random.Random(text)))
    duration_s = max(word.interval.end_s for word in words if word.interval) + 0.2
    agitation = Agitation(low=0.0, medium=1.0, high=0.0)
    utterance = Utterance(words, stages.parser.parse(words), agitation, duration_s=duration_s)
    known = understand(stages.functions, utterance)
    functions = known.functions
    clock = [time.perf_counter()]
    candidates = stages.candidates(utterance, known, seed)
    clock.append(time.perf_counter())
    behaviors = schedule(candidates, utterance, stages.character, seed=seed, mode=mode)
    clock.append(time.perf_counter())
    performance = Performance(utterance, functions, behaviors, stages.character.name, seed)
    bml = write_bml(performance)
    clock.append(time.perf_counter())
    times_ms = [1000 * (after - before) for before, after in pairwise(clock)]
    early = early_points(performance)
    return Outcome(functions, behaviors, duration_s, len(words), tuple(check(bml)), early, *times_ms)


def early_points(performance: Performance) -> int:
    """How many points relative to the marks of words come before the first moment, in sums of floating numbers."""
    document = to_document(performance, BmlForm(timing=TimeForm.SYNC))
    starts = {f"w{word.index}": word.interval.start_s for word in performance.utterance.words if word.interval}
    values = (value for part in document.root.children for value in part.attributes.values())
    times_s = [{"start": 0.0, **starts}[ref.point] + ref.offset_s for ref in values if isinstance(ref, Reference)]
    return sum(time_s < FIRST_MOMENT_S - ROUNDING_S for time_s in times_s)


def performed(stages: Stages, text: str, seed: int) -> Performance:
    """The text's performance, as if read at medium agitation."""
    words = tuple(timed(read_transcript(text), random.Random(text)))
    duration_s = max(word.interval.end_s for word in words if word.interval) + 0.2
    agitation = Agitation(low=0.0, medium=1.0, high=0.0)
    utterance = Utterance(words, stages.parser.parse(words), agitation, duration_s=duration_s)
    known = understand(stages.functions, utterance)
    functions = known.functions
    candidates = stages.candidates(utterance, known, seed)
    behaviors = schedule(candidates, utterance, stages.character, seed=seed)
    lips, _notices = visemes(words, duration_s)
    return Performance(utterance, functions, behaviors, stages.character.name, seed, visemes=lips)


def spoken_sentences() -> Iterator[str]:
    """The texts of GUM's spoken sentences."""
    for name in ("spoken-dev", "spoken-test"):
        for block in (TREEBANKS / f"{name}.conllu").read_text(encoding="utf-8").strip().split("\n\n"):
            rows = [line.split("\t") for line in block.splitlines() if line.split("\t")[0].isdigit()]
            yield "".join(row[1] + ("" if "SpaceAfter=No" in row[9] else " ") for row in rows).strip()


def strokes(outcomes: list[Outcome]) -> Iterator[Behavior]:
    for each in outcomes:
        yield from (behavior for behavior in each.behaviors if behavior.kept and behavior.kind is Channel.GESTURE)


FAULTS = ("overlaps on a channel", "sync points out of order", "events before 0", "duplicate ids")


def unsound(behaviors: tuple[Behavior, ...]) -> Counter[str]:
    """What may not be in a schedule, counted."""
    counts: Counter[str] = Counter()
    kept = [behavior for behavior in behaviors if behavior.kept]
    for one, other in combinations(kept, 2):
        same = one.kind is other.kind and (one.hand is other.hand or Hand.BOTH in (one.hand, other.hand))
        counts[FAULTS[0]] += same and one.sync.start < other.sync.end and other.sync.start < one.sync.end
    for behavior in kept:
        times = [time_s for _, time_s in behavior.sync.in_order()]
        counts[FAULTS[1]] += times != sorted(times)
        counts[FAULTS[2]] += times[0] < 0
    counts[FAULTS[3]] += len(behaviors) - len({behavior.id for behavior in behaviors})
    return counts


def repeated_and_switched(outcomes: list[Outcome]) -> tuple[int, int]:
    """Gestures with the lexeme of one within the 5 s before, and one-handed ones that change hands within 2 s."""
    repeated = switched = 0
    for each in outcomes:
        for earlier, later in pairwise(strokes([each])):
            gap_s = (later.sync.stroke or 0) - (earlier.sync.stroke or 0)
            repeated += later.lexeme == earlier.lexeme and gap_s < 5
            switched += later.hand is not earlier.hand and Hand.BOTH not in (later.hand, earlier.hand) and gap_s < 2
    return repeated, switched


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--texts", type=Path, default=TEXTS)
    arguments.add_argument("--sentences", type=int, default=0)
    arguments.add_argument("--character", default="default")
    arguments.add_argument("--seed", type=int, default=0)
    arguments.add_argument("--seeds", type=int, default=1)
    add_record_option(arguments)
    options = arguments.parse_args()
    stages = Stages.load(options.character)
    if options.sentences:
        texts = list(islice(spoken_sentences(), options.sentences))
    else:
        texts = [json.loads(line)["text"] for line in options.texts.read_text(encoding="utf-8").splitlines()]
    if not texts:
        arguments.error(f"{options.texts} has no texts")
    outcomes = [outcome(stages, text, options.seed) for text in texts]
    report(outcomes, stages.character)
    if options.record:
        early = float(sum(each.early for each in outcomes))
        record("formats", "BML: points before the first moment, relative to marks", early, bar="= 0")
    if options.seeds > 1:
        others = [[outcome(stages, text, seed) for text in texts] for seed in range(1, options.seeds)]
        report_seeds([outcomes, *others])


def report(outcomes: list[Outcome], character: Character) -> None:
    minutes = sum(each.duration_s for each in outcomes) / 60
    kept = [(each, function) for each in outcomes for function in each.functions if function.kept]
    shown = [(each, function) for each, function in kept if shows(each, function)]
    channels = Counter(behavior.kind for each in outcomes for behavior in each.behaviors if behavior.kept)
    gestures = list(strokes(outcomes))
    repeated, switched = repeated_and_switched(outcomes)
    print(f"{len(outcomes)} texts, {minutes:.1f} minutes, character {character.name}")
    print(f"kept functions that show: {len(shown)} of {len(kept)} ({100 * len(shown) / len(kept):.0f} %)")
    print(f"gesture strokes a minute: {len(gestures) / minutes:.1f} (set: {character.gestures_per_minute:g})")
    print(f"same gesture within 5 s: {repeated}, hands switched within 2 s: {switched}, of {len(gestures)}")
    print("a minute: " + ", ".join(f"{kind} {count / minutes:.1f}" for kind, count in sorted(channels.items())))
    print(f"mistakes the checker finds: {sum(len(each.mistakes) for each in outcomes)}")
    print(f"points before the first moment, relative to marks: {sum(each.early for each in outcomes)}")
    faults = [unsound(each.behaviors) for each in outcomes]
    print(", ".join(f"{name}: {sum(each[name] for each in faults)}" for name in FAULTS))
    report_times(outcomes)


def report_times(outcomes: list[Outcome]) -> None:
    """Milliseconds of the three stages, of all lines and of those of 13 to 17 words."""
    middle = [each for each in outcomes if 13 <= each.words <= 17]
    for name in ("mapping_ms", "schedule_ms", "write_ms"):
        medians = [statistics.median(getattr(each, name) for each in some) for some in (outcomes, middle) if some]
        print(f"{name}: " + ", ".join(f"{median:.2f}" for median in medians) + " (median; of 13 to 17 words)")


def report_seeds(by_seed: list[list[Outcome]]) -> None:
    """How far the seeds' schedules of a text differ, and whether what matters most shows in all of them."""
    by_text = list(zip(*by_seed, strict=True))
    faults = sum((unsound(each.behaviors) for line in by_text for each in line), Counter[str]())
    different = sum(len({each.behaviors for each in line}) == len(line) for line in by_text)
    first = [max((f for f in line[0].functions if f.kept), key=lambda f: f.priority, default=None) for line in by_text]
    asked = [(line, function) for line, function in zip(by_text, first, strict=True) if function is not None]
    always = sum(all(shows(each, function) for each in line) for line, function in asked)
    print(
        f"{len(by_seed)} seeds: all schedules different on {different} of {len(by_text)} texts, faults {faults.total()}"
    )
    print(f"the function that matters most shows under every seed in {always} of {len(asked)} texts")


def shows(outcome: Outcome, function: Function) -> bool:
    return any(behavior.kept and behavior.function == function.id for behavior in outcome.behaviors)


if __name__ == "__main__":
    main()
