"""Time of rules: loading a program, and the derivation for one line. `python -m benchmarks.rules.chainer`

The program is of the size DESIGN.md speaks of, 100 rules over some 500 facts: lexical rules, rules that join
neighbours, rules with `unless`, a rule that raises priorities, mapping rules. Times are the median of many runs, in
milliseconds of processor time on one core.
"""

import random
import statistics
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

from understudy.model import Fact
from understudy.rules.chaining.chainer import derive
from understudy.rules.program.loading import Program, load_program

Result = TypeVar("Result")

VOCABULARY = """
predicate word(text, start, end)
predicate part_of_speech(universal, start, end)
predicate dependency(label, head, dependent)
predicate lexical(class, subtype, start, end)
predicate stressed_ratio(ratio, start, end)
predicate agitation(level)
predicate fcn(class, subtype, start, end, priority max)

rule stress
foreach
  fcn($class, $subtype, $start, $end, $priority)
  stressed_ratio($ratio, $start, _)
  $ratio >= 0.5
assert
  fcn($class, $subtype, $start, $end, increase_priority($priority))
"""

LEXICAL = """
rule lexical_{number}
foreach
  lexical(class_{number}, $subtype, $start, $end)
  part_of_speech(NOUN|VERB, $start, _)
  unless word(word_{number}, $start, _)
assert
  fcn(class_{number}, $subtype, $start, $end, {number})
"""

NEIGHBOURS = """
rule neighbours_{number}
foreach
  fcn(class_{number}, _, $start, $middle, $priority)
  fcn(class_{other}, _, $middle, $end, $other)
  $new = increase_priority($priority, $other)
assert
  fcn(class_{other}, joined_{number}, $start, $end, $new)
"""

GOVERNED = """
rule governed_{number}
foreach
  lexical(class_{number}, plain, $start, $end)
  dependency(nsubj|dobj, $head, $start)
  word($text, $head, $after)
  $start < $head
  unless lexical(class_{other}, _, $start, $end)
assert
  fcn(class_{other}, governed, $start, $after, 3)
"""

MAPPING = """
rule show_{number}
foreach
  fcn(class_{number}, _, $start, $end, _)
  agitation($level)
choose
  weight 3
    nod($start, $end)
  weight 2 when $level == high
    beat($start, $end)
"""

RULES_OF_EACH_KIND = 25
WORDS = 60


def main() -> None:
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "benchmark.rules"
        path.write_text(_text(), encoding="utf-8")
        program, loading_ms = _timed(lambda: load_program([path]), runs=5)
    facts = _facts(program)
    derivation, deriving_ms = _timed(lambda: derive(program, facts), runs=200)
    print(f"rules                       {len(program.rules)}")
    print(f"given facts                 {len(facts)}")
    print(f"derived facts               {len(derivation.facts) - len(facts)}")
    print(f"choices                     {len(derivation.choices)}")
    print(f"loading the program         {loading_ms:.1f} ms")
    print(f"deriving, median of 200     {deriving_ms:.2f} ms")


def _text() -> str:
    kinds = (LEXICAL, NEIGHBOURS, GOVERNED, MAPPING)
    numbers = range(1, RULES_OF_EACH_KIND + 1)
    return VOCABULARY + "".join(
        kind.format(number=number, other=number % RULES_OF_EACH_KIND + 1) for kind in kinds for number in numbers
    )


def _facts(program: Program) -> list[Fact]:
    """A line of `WORDS` words, with the facts a real one has, about eight a word."""
    draw = random.Random(7)
    facts = [Fact("agitation", ("high",))]
    for start in range(WORDS):
        end = start + 1
        facts.append(Fact("word", (f"word_{draw.randint(1, 200)}", start, end)))
        facts.append(Fact("part_of_speech", (draw.choice(["NOUN", "VERB", "DET", "PRON"]), start, end)))
        facts.append(Fact("dependency", (draw.choice(["nsubj", "dobj", "det"]), draw.randrange(WORDS), start)))
        facts.append(Fact("stressed_ratio", (draw.random(), start, end)))
        facts += [
            Fact("lexical", (f"class_{draw.randint(1, 25)}", draw.choice(["plain", "a", "b"]), start, end))
            for _ in range(4)
        ]
    assert all(fact.predicate in program.predicates for fact in facts)
    return list(dict.fromkeys(facts))


def _timed(work: Callable[[], Result], *, runs: int) -> tuple[Result, float]:
    """The result, and the median time in ms."""
    times_s = []
    for _ in range(runs):
        start_s = time.process_time()
        result = work()
        times_s.append(time.process_time() - start_s)
    return result, statistics.median(times_s) * 1000


if __name__ == "__main__":
    main()
