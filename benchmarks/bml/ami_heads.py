"""When people's heads move while they talk and listen, and when ours do: AMI's meetings and lines performed from them.

    python -m benchmarks.bml.ami_heads [--ami FOLDER] [--lines N]

FOLDER has the AMI annotations as gzipped tables (`words`, `head`: meeting, speaker, start_s, end_s, what it is;
default: ../shared/data/ami). The people of one series of meetings are the same, so whole series are held out; the
figures are of those, the rates that listeners use are fitted on the others (`training.head_rates`). Ours are of N
turns of the held-out meetings: their words in their time, one word in eight emphasised (the recordings are not
there), at medium agitation, with a listener; `attentive` are the listeners of the held-out meetings who nod most. A
movement goes with a word that it overlaps, `NEAR_S` to either side; off camera, nothing is counted.
"""

import argparse
import csv
import gzip
import random
import statistics
from bisect import bisect_right
from collections import Counter, defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice, pairwise
from pathlib import Path

from benchmarks.bml.schedule import DATA, Stages
from understudy.behavior.choice.scheduling import schedule
from understudy.behavior.listeners.listening import Listener, listen
from understudy.model import Agitation, Analysis, Behavior, Channel, Interval, Utterance, Word
from understudy.rules.derivation import understand

AMI = DATA / "ami"
HELD_OUT = ("ES2008", "IS1003", "IS1009")
"""Every fourth of the twelve series."""

NEAR_S = 0.2
BEFORE_S = 0.3
SHORTEST_PAUSE_S = 0.2
BETWEEN_TURNS_S = 1.0
AFFIRMATIONS = frozenset(["yeah", "yes", "yep", "okay", "right", "sure", "exactly", "absolutely", "mm-hmm", "uh-huh"])
NEGATIONS = frozenset(["no", "not", "never", "nothing", "none", "nobody", "cannot", "nope"])
PUNCTUATION = (".", ",", "?", "!", ";", ":")
ECHO_S = 1.5
"""A listener's nod within this time of a talker's answers it, or seems to."""

ATTENTIVE = 0.25
"""The share of listeners who nod most. They are the measure: ours is the only one there, and is spoken to."""

SOONEST_S, LATEST_S = -0.5, 2.0
"""How long before and after the end of a talker's phrase a listener's nod may begin to belong to it."""


@dataclass(frozen=True, slots=True)
class Movement:
    """A movement of the head: its form (nod, shake, other) and whether it stresses."""

    interval: Interval
    form: str
    stresses: bool = False


@dataclass(frozen=True, slots=True)
class Person:
    """What one person says and how the head moves in a meeting, in order of time."""

    words: list[Word] = field(default_factory=list)
    heads: list[Movement] = field(default_factory=list)
    hidden: list[Interval] = field(default_factory=list)

    def turns(self) -> Iterator[list[Word]]:
        """The words between pauses of a turn's length."""
        turn: list[Word] = []
        for word in self.words:
            if turn and interval(word).start_s - interval(turn[-1]).end_s > BETWEEN_TURNS_S:
                yield turn
                turn = []
            turn.append(word)
        if turn:
            yield turn

    def sees(self, at_s: float) -> bool:
        return not any(hidden.start_s <= at_s < hidden.end_s for hidden in self.hidden)


@dataclass(slots=True)
class Figures:
    """Counts that make the rates; times in seconds."""

    talking_s: float = 0.0
    listening_s: float = 0.0
    talking: Counter[str] = field(default_factory=Counter)
    listening: Counter[str] = field(default_factory=Counter)
    words: int = 0
    stressed: int = 0
    affirmations: int = 0
    nodded: int = 0
    negations: int = 0
    shaken: int = 0
    after: dict[str, list[float | None]] = field(default_factory=lambda: {"pause": [], "phrase": []})
    durations_s: list[float] = field(default_factory=list)
    echoed: list[bool] = field(default_factory=list)


def interval(word: Word) -> Interval:
    assert word.interval is not None, "every word of the corpus has a time"
    return word.interval


def read_meetings(folder: Path) -> dict[str, dict[str, Person]]:
    """The people of each meeting that has head movements; words that nobody timed are left out."""
    meetings: dict[str, dict[str, Person]] = defaultdict(lambda: defaultdict(Person))
    for meeting, speaker, start_s, end_s, kind, form in _rows(folder / "head.tsv.gz"):
        person, span = meetings[meeting][speaker], Interval(float(start_s), float(end_s))
        if kind == "off_camera":
            person.hidden.append(span)
        elif kind != "no_comm_head":
            shape = form if form in ("nod", "shake") else "other"
            person.heads.append(Movement(span, shape, kind == "emphasis_signal"))
    for meeting, speaker, start_s, end_s, kind, text in _rows(folder / "words.tsv.gz"):
        if meeting in meetings and "-" not in (start_s, end_s):
            _hear(meetings[meeting][speaker].words, kind, text, Interval(float(start_s), float(end_s)))
    return {meeting: dict(people) for meeting, people in meetings.items()}


def _rows(path: Path) -> Iterator[list[str]]:
    with gzip.open(path, "rt", encoding="utf-8", newline="") as file:
        yield from csv.reader(file, delimiter="\t", quoting=csv.QUOTE_NONE)


def _hear(words: list[Word], kind: str, text: str, span: Interval) -> None:
    """The next word of a person; punctuation joins the word before it."""
    if kind != "punct":
        words.append(Word(len(words), text, span))
    elif words and text in PUNCTUATION:
        words[-1] = Word(words[-1].index, words[-1].text + text, words[-1].interval)


def series(meeting: str) -> str:
    return meeting[:-1]


def plain(word: Word) -> str:
    return word.text.rstrip("".join(PUNCTUATION)).lower()


def is_negation(word: Word) -> bool:
    return plain(word) in NEGATIONS or plain(word).endswith("n't")


def boundaries(turn: Sequence[Word]) -> Iterator[tuple[float, str]]:
    """Where a talker ends a phrase: with a pause, or without ("phrase", at punctuation); the turn's end is a pause."""
    for word, following in pairwise(turn):
        if interval(following).start_s - interval(word).end_s >= SHORTEST_PAUSE_S:
            yield interval(word).end_s, "pause"
        elif word.text.endswith(PUNCTUATION):
            yield interval(word).end_s, "phrase"
    yield interval(turn[-1]).end_s, "pause"


def add_talk(figures: Figures, turn: Sequence[Word], heads: Sequence[Movement]) -> None:
    """What a head does during a turn of its owner's."""
    span = Interval(interval(turn[0]).start_s, interval(turn[-1]).end_s)
    figures.talking_s += span.duration_s
    within = [head for head in heads if span.start_s <= head.interval.start_s < span.end_s]
    figures.talking.update(head.form for head in within)
    near = [head for head in heads if _overlap(head.interval, span)]
    for word in turn:
        moves = [head for head in near if _overlap(head.interval, interval(word))]
        figures.words += 1
        figures.stressed += any(head.stresses and _during(head, interval(word)) for head in moves)
        if plain(word) in AFFIRMATIONS:
            figures.affirmations += 1
            figures.nodded += any(head.form == "nod" for head in moves)
        if is_negation(word):
            figures.negations += 1
            figures.shaken += any(head.form == "shake" for head in moves)


def add_listening(
    figures: Figures, turn: Sequence[Word], heads: Sequence[Movement], talkers: Sequence[Movement]
) -> None:
    """What a listener's head does during a turn of another's, who makes the movements `talkers`."""
    start_s, end_s = interval(turn[0]).start_s, interval(turn[-1]).end_s
    figures.listening_s += end_s - start_s
    figures.listening.update(head.form for head in heads if start_s <= head.interval.start_s < end_s)
    nods = sorted(head.interval.start_s for head in heads if head.form == "nod")
    figures.durations_s += [
        head.interval.duration_s for head in heads if head.form == "nod" and start_s <= head.interval.start_s < end_s
    ]
    for movement in talkers:
        if movement.form == "nod" and start_s <= movement.interval.start_s < end_s:
            begun = bisect_right(nods, movement.interval.start_s)
            figures.echoed.append(begun < len(nods) and nods[begun] < movement.interval.start_s + ECHO_S)
    ends = list(boundaries(turn))
    for place, (at_s, kind) in enumerate(ends):
        until_s = min(at_s + LATEST_S, ends[place + 1][0] + SOONEST_S) if place + 1 < len(ends) else at_s + LATEST_S
        begun = bisect_right(nods, at_s + SOONEST_S)
        found = begun < len(nods) and nods[begun] < until_s
        figures.after[kind].append(nods[begun] - at_s if found else None)


def _overlap(one: Interval, other: Interval) -> bool:
    return one.start_s < other.end_s + NEAR_S and other.start_s - NEAR_S < one.end_s


def _during(head: Movement, word: Interval) -> bool:
    return head.interval.start_s < word.end_s and word.start_s < head.interval.end_s


def talking_of(meetings: Iterable[dict[str, Person]]) -> Figures:
    """What people do while they talk; whose head was not annotated is left out."""
    figures = Figures()
    for person in (person for people in meetings for person in people.values() if person.heads):
        for turn in person.turns():
            if person.sees(interval(turn[0]).start_s):
                add_talk(figures, turn, person.heads)
    return figures


def listeners_of(meetings: Iterable[dict[str, Person]]) -> Iterator[Figures]:
    """What each person does while listening: on camera, and silent during a turn of another's."""
    for people in meetings:
        for name, listener in people.items():
            if not listener.heads:
                continue
            figures = Figures()
            for talker in (other for key, other in people.items() if key != name):
                for turn in talker.turns():
                    if _listens(listener, turn):
                        add_listening(figures, turn, listener.heads, talker.heads)
            if figures.listening_s:
                yield figures


def attentive(listeners: Iterable[Figures]) -> list[Figures]:
    """The listeners who nod most."""
    ranked = sorted(listeners, key=lambda each: -each.listening["nod"] / each.listening_s)
    return ranked[: max(1, round(ATTENTIVE * len(ranked)))]


def pooled(talking: Figures, listeners: Iterable[Figures]) -> Figures:
    """The figures of talkers with those of listeners."""
    for each in listeners:
        talking.listening_s += each.listening_s
        talking.listening += each.listening
        talking.durations_s += each.durations_s
        talking.echoed += each.echoed
        for kind, delays in each.after.items():
            talking.after[kind] += delays
    return talking


def _listens(person: Person, turn: Sequence[Word]) -> bool:
    start_s, end_s = interval(turn[0]).start_s, interval(turn[-1]).end_s
    if len(turn) < 5 or not (person.sees(start_s) and person.sees(end_s)):
        return False
    begun = bisect_right(person.words, start_s, key=lambda word: interval(word).end_s)
    return begun == len(person.words) or interval(person.words[begun]).start_s >= end_s


def drawn_turns(meetings: Iterable[dict[str, Person]]) -> list[tuple[Person, list[Word]]]:
    """The turns of 6 to 60 words, with who took them, in an order drawn by chance."""
    turns = [(talker, turn) for people in meetings for talker in people.values() for turn in talker.turns()]
    turns = [(talker, turn) for talker, turn in turns if 6 <= len(turn) <= 60]
    random.Random(0).shuffle(turns)
    return turns


def performed_turn(stages: Stages, turn: Sequence[Word], seed: int) -> tuple[Utterance, Analysis, tuple[Behavior, ...]]:
    """What the rules understand of a turn and do with it; its time is from `BEFORE_S` before its first word."""
    words = tuple(_from_zero(turn, random.Random(seed)))
    utterance = Utterance(
        words,
        stages.parser.parse(words),
        Agitation(low=0.0, medium=1.0, high=0.0),
        duration_s=interval(words[-1]).end_s + LATEST_S,
    )
    known = understand(stages.functions, utterance)
    return utterance, known, schedule(stages.candidates(utterance, known, seed), utterance, stages.character, seed=seed)


def ours(stages: Stages, meetings: Iterable[dict[str, Person]], count: int) -> Figures:
    """Our figures of `count` of the meetings' turns of 6 to 60 words, drawn by chance."""
    figures = Figures()
    listener = Listener(stages.character, stages.behavior.head_rates, "talker")
    for seed, (_, turn) in enumerate(islice(drawn_turns(meetings), count)):
        utterance, known, behaviors = performed_turn(stages, turn, seed)
        emphases: set[str | None] = {
            function.id for function in known.functions if function.class_name in ("emphasis", "intensifier")
        }
        talkers = list(movements_of(behaviors, emphases))
        add_talk(figures, utterance.words, talkers)
        heard = listen(behaviors, utterance, listener, seed=seed)
        add_listening(figures, utterance.words, list(movements_of(heard, frozenset())), talkers)
    return figures


def _from_zero(turn: Sequence[Word], generator: random.Random) -> Iterator[Word]:
    start_s = interval(turn[0]).start_s - BEFORE_S
    for index, word in enumerate(turn):
        span = Interval(interval(word).start_s - start_s, interval(word).end_s - start_s)
        yield Word(index, word.text, span, emphasis=0.6 if generator.random() < 1 / 8 else 0.0)


def movements_of(behaviors: Iterable[Behavior], emphases: Collection[str | None]) -> Iterator[Movement]:
    """The head movements that an annotator would have marked: not the drifting."""
    for behavior in behaviors:
        if not behavior.kept or behavior.kind is not Channel.HEAD or "never quite still" in (behavior.reason or ""):
            continue
        form = "nod" if "NOD" in behavior.lexeme else "shake" if behavior.lexeme == "SHAKE" else "other"
        span = Interval(behavior.sync.start, behavior.sync.end)
        yield Movement(span, form, behavior.function in emphases)


def report(columns: dict[str, Figures]) -> None:
    print(f"{'':44s}" + "".join(f"{name:>16s}" for name in columns))
    for name, values in _rates(columns.values()):
        print(f"{name:44s}" + "".join(f"{value:>16s}" for value in values))


def _rates(columns: Iterable[Figures]) -> Iterator[tuple[str, list[str]]]:
    columns = list(columns)
    for form in ("nod", "shake", "other"):
        yield f"{form}s a minute talking", [f"{60 * each.talking[form] / each.talking_s:.2f}" for each in columns]
    for form in ("nod", "shake", "other"):
        yield f"{form}s a minute listening", [f"{60 * each.listening[form] / each.listening_s:.2f}" for each in columns]
    yield "affirmations nodded, %", [f"{100 * each.nodded / each.affirmations:.1f}" for each in columns]
    yield "negations shaken, %", [f"{100 * each.shaken / each.negations:.1f}" for each in columns]
    yield "words stressed by the head, %", [f"{100 * each.stressed / each.words:.1f}" for each in columns]
    for kind in ("pause", "phrase"):
        after = [each.after[kind] for each in columns]
        name = f"listener nods at a {'pause' if kind == 'pause' else 'phrase end without pause'}, %"
        yield name, [f"{100 * sum(delay is not None for delay in all_) / len(all_):.1f}" for all_ in after]
    yield (
        "talker's nods answered by a listener's, %",
        [f"{100 * sum(each.echoed) / max(1, len(each.echoed)):.1f}" for each in columns],
    )
    delays = [[delay for all_ in each.after.values() for delay in all_ if delay is not None] for each in columns]
    quarters = [statistics.quantiles(each, n=4) if len(each) > 1 else [0.0] * 3 for each in delays]
    yield "its delay, s: quartiles", [" ".join(f"{value:.2f}" for value in each) for each in quarters]
    yield "its duration, s: median", [f"{statistics.median(each.durations_s or [0.0]):.2f}" for each in columns]
    yield "minutes talking", [f"{each.talking_s / 60:.0f}" for each in columns]


def split(meetings: dict[str, dict[str, Person]]) -> tuple[list[dict[str, Person]], list[dict[str, Person]]]:
    """The meetings to fit on, and those held out."""
    fitted = [people for meeting, people in meetings.items() if series(meeting) not in HELD_OUT]
    return fitted, [people for meeting, people in meetings.items() if series(meeting) in HELD_OUT]


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--ami", type=Path, default=AMI)
    arguments.add_argument("--lines", type=int, default=200)
    options = arguments.parse_args()
    fitted, held_out = split(read_meetings(options.ami))
    stages = Stages.load("default")
    report(
        {
            "fitted on": pooled(talking_of(fitted), listeners_of(fitted)),
            "held out": pooled(talking_of(held_out), listeners_of(held_out)),
            "attentive": pooled(talking_of(held_out), attentive(listeners_of(held_out))),
            "ours": ours(stages, held_out, options.lines),
        }
    )


if __name__ == "__main__":
    main()
