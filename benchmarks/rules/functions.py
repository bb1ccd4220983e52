"""Accuracy and speed of deriving functions, on dialogue that was not written for us.

    python -m benchmarks.rules.functions [--sample FILE] [--half even|odd] [--errors CLASS]

FILE holds annotated lines (default: ../shared/data/functions/dev.jsonl). A function is right where the class is the
same and the spans share a word (or the mark's second span does), each mark used once; optional marks count neither way.
The score is the F1 of each class and the mean over the fifteen classes of text (macro F1). `exact` is the share of the
marks found whose span is the same. Everything is scored a second time in lower case without punctuation.

The rules were first written with only the even lines in view; `--half odd` scores the others.
"""

import argparse
import json
import re
import time
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from understudy.files import resource_folder
from understudy.model import Function, Utterance, Word
from understudy.rules import derivation
from understudy.rules.derivation import FunctionRules, derive_functions
from understudy.syntax.parser import Parser

SAMPLE = Path(__file__).resolve().parents[3] / "shared" / "data" / "functions" / "dev.jsonl"
CLASSES = (
    "affirmation",
    "negation",
    "interrogative",
    "contrast",
    "process",
    "quantification",
    "comparison",
    "spatial",
    "physical",
    "mental",
    "performance",
    "deixis",
    "modal",
    "intensifier",
    "valence",
)


@dataclass(frozen=True, slots=True)
class Mark:
    """What a reader marked: a class on words `first` to `last`, or on the second acceptable span."""

    class_name: str
    first: int
    last: int
    second: tuple[int, int] | None

    def shares_a_word(self, first: int, last: int) -> bool:
        spans = [(self.first, self.last), *([self.second] if self.second else [])]
        return any(first <= end and start <= last for start, end in spans)

    def is_exactly(self, first: int, last: int) -> bool:
        return (first, last) in ((self.first, self.last), self.second)


@dataclass(frozen=True, slots=True)
class Line:
    """An annotated line; its words are what white space separates."""

    text: str
    marks: tuple[Mark, ...]
    optional: tuple[Mark, ...]


@dataclass(slots=True)
class Tally:
    """Counts of one class over the lines."""

    right: int = 0
    exact: int = 0
    wrong: int = 0
    missed: int = 0
    errors: list[str] = field(default_factory=list)

    @property
    def f1(self) -> float:
        """F1; 1 when there was nothing to find and nothing was found."""
        everything = 2 * self.right + self.wrong + self.missed
        return 2 * self.right / everything if everything else 1.0


def score(line: Line, functions: Iterable[Function], tallies: dict[str, Tally]) -> None:
    """Add a line's hits and misses. Exact spans take their marks first, so that no neighbour takes them away."""
    for class_name in CLASSES:
        tally = tallies[class_name]
        found = [(function.first, function.last) for function in functions if function.class_name == class_name]
        open_marks = [mark for mark in line.marks if mark.class_name == class_name]
        found, open_marks, exact = _paired(found, open_marks, Mark.is_exactly)
        found, open_marks, near = _paired(found, open_marks, Mark.shares_a_word)
        optional = [mark for mark in line.optional if mark.class_name == class_name]
        found, _, _ = _paired(found, optional, Mark.shares_a_word)
        tally.exact += exact
        tally.right += exact + near
        tally.wrong += len(found)
        tally.missed += len(open_marks)
        for sign, spans in (("+", found), ("-", [(mark.first, mark.last) for mark in open_marks])):
            tally.errors += [f"{sign} {' '.join(line.text.split()[a : b + 1])!r} in {line.text!r}" for a, b in spans]


def _paired(
    found: list[tuple[int, int]], marks: list[Mark], fits: Callable[[Mark, int, int], bool]
) -> tuple[list[tuple[int, int]], list[Mark], int]:
    """What is left of both after each found span has taken the first mark it fits, and how many did."""
    left_over, marks = [], list(marks)
    for first, last in found:
        taken = next((mark for mark in marks if fits(mark, first, last)), None)
        if taken is None:
            left_over.append((first, last))
        else:
            marks.remove(taken)
    return left_over, marks, len(found) - len(left_over)


def read_sample(path: Path) -> Iterator[Line]:
    for row in map(json.loads, path.read_text(encoding="utf-8").splitlines()):
        yield Line(row["text"], tuple(map(_mark, row["functions"])), tuple(map(_mark, row["optional"])))


def _mark(row: dict[str, object]) -> Mark:
    second = row.get("or")
    assert isinstance(row["first"], int)
    assert isinstance(row["last"], int)
    return Mark(str(row["class"]), row["first"], row["last"], tuple(second) if isinstance(second, list) else None)


def written(text: str) -> tuple[Word, ...]:
    return tuple(Word(index, word) for index, word in enumerate(text.split()))


def plain(text: str) -> tuple[Word, ...]:
    """Lower case, without punctuation; a word that was nothing else stays as it is, so that the numbers stay."""
    bare = [re.sub(r"[^\w'\s-]|(?<!\w)-|-(?!\w)", "", word).lower() or word for word in text.split()]
    return tuple(Word(index, word) for index, word in enumerate(bare))


def measure(
    parser: Parser, rules: FunctionRules, lines: Sequence[Line], words: Callable[[str], tuple[Word, ...]]
) -> tuple[dict[str, Tally], float, float]:
    """Tallies by class, and the milliseconds a line of the parse and of lexicon and rules."""
    tallies: dict[str, Tally] = defaultdict(Tally)
    parse_s = rules_s = 0.0
    for line in lines:
        spoken = words(line.text)
        begun = time.perf_counter()
        utterance = Utterance(spoken, parser.parse(spoken))
        parsed = time.perf_counter()
        functions = derive_functions(rules, utterance)
        rules_s += time.perf_counter() - parsed
        parse_s += parsed - begun
        score(line, [function for function in functions if function.kept], tallies)
    return tallies, 1000 * parse_s / len(lines), 1000 * rules_s / len(lines)


def report(title: str, tallies: dict[str, Tally]) -> None:
    print(f"\n{title}\n{'class':16s} {'F1':>5s} {'right':>6s} {'wrong':>6s} {'missed':>6s} {'exact':>6s}")
    for name in CLASSES:
        tally = tallies[name]
        exact = tally.exact / tally.right if tally.right else 1.0
        print(f"{name:16s} {tally.f1:5.2f} {tally.right:6d} {tally.wrong:6d} {tally.missed:6d} {exact:6.2f}")
    right = sum(tallies[name].right for name in CLASSES)
    exact = sum(tallies[name].exact for name in CLASSES) / right if right else 1.0
    print(f"macro F1 {sum(tallies[name].f1 for name in CLASSES) / len(CLASSES):.3f}, exact spans {exact:.3f}")


def main() -> None:
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--sample", type=Path, default=SAMPLE)
    arguments.add_argument("--half", choices=["even", "odd"], help="only lines 0, 2, … or 1, 3, …")
    arguments.add_argument("--errors", metavar="CLASS", help="list what was missed (-) and wrongly found (+); or all")
    options = arguments.parse_args()
    lines = list(read_sample(options.sample))
    lines = lines[options.half == "odd" :: 2] if options.half else lines
    parser = Parser.load(resource_folder("models") / "parser")
    rules = FunctionRules.load(Path(derivation.__file__).parent, resource_folder("lexicon") / "en")
    print(f"{len(rules.program.rules)} rules, {len(rules.lexicon.entries)} words and phrases, {len(lines)} lines")
    for title, words in (("as written", written), ("lower case, no punctuation", plain)):
        tallies, parse_ms, rules_ms = measure(parser, rules, lines, words)
        report(title, tallies)
        print(f"parse {parse_ms:.2f} ms a line, lexicon and rules {rules_ms:.2f} ms a line")
        for name in CLASSES:
            if options.errors in (name, "all"):
                print(*(f"{name}: {error}" for error in tallies[name].errors), sep="\n")


if __name__ == "__main__":
    main()
