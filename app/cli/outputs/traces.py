"""Shows people which rules fired on a text, and what a corpus never uses."""

from collections.abc import Iterator, Sequence

from ...authoring.catalogue import shown_path
from ...authoring.inspection import Firing, NearMiss, Rule, RuleTrace, ShownStatement, Trace, UnusedEntries
from ...model import Behavior, Moment, Word

MOST_NEAR_MISSES = 12
WORDS_COLUMN = 64


def trace_lines(trace: Trace) -> Iterator[str]:
    """The rules that fired, with the facts and words joined; those that nearly fired, at most `MOST_NEAR_MISSES`; and
    the plan: for each phrase what was chosen, because of which terms, and what lost."""
    words = trace.utterance.words
    for title, part in (("function rules", trace.functions), ("mapping rules", trace.mappings)):
        yield from _rules(title, part, words)
    if trace.moments:
        yield "the plan, phrase by phrase"
    for moment in trace.moments:
        yield from _moment(moment, words)
    shown = [each for each in trace.behaviors if each.function is not None or each.moment is not None]
    if shown:
        yield "what is shown, and what is not"
    yield from (_behavior(each, words) for each in shown)


def _rules(title: str, part: RuleTrace, words: Sequence[Word]) -> Iterator[str]:
    if part.firings:
        yield f"{title} that fired"
    for firing in part.firings:
        yield from _firing(firing, words)
    if part.near_misses:
        yield f"{title} that nearly fired"
    for miss in part.near_misses[:MOST_NEAR_MISSES]:
        yield from _near_miss(miss, words)
    if len(part.near_misses) > MOST_NEAR_MISSES:
        yield f"  and {len(part.near_misses) - MOST_NEAR_MISSES} with fewer conditions met (see --rule NAME)"


def unused_lines(unused: UnusedEntries) -> Iterator[str]:
    """The rules, then the words that were never used, with their places."""
    yield f"{len(unused.rules)} rules never fire"
    yield from (f"  {_place(rule)}" for rule in unused.rules)
    yield f"{len(unused.words)} words and phrases are never found"
    for entry in unused.words:
        yield f"  {shown_path(entry.path)}:{entry.line}  {entry.class_name} {entry.subtype}  {entry.phrase}"


def _moment(moment: Moment, words: Sequence[Word]) -> Iterator[str]:
    spoken = " ".join(word.text for word in words[moment.first : moment.last + 1])
    told = f"  {moment.channel} {moment.families[0]} on {words[moment.stroke].text!r} (word {moment.stroke})"
    yield f"{told:<{WORDS_COLUMN}} {spoken}"
    if moment.set_against is not None:
        yield f"    placed {moment.families[1]}, against {words[moment.set_against].text!r} (word {moment.set_against})"
    for term in moment.terms:
        yield f"    {term.weight:+.2f}  {term.name}"
    for rejected in moment.rejected:
        yield f"    not {', '.join(rejected.families)}, worth {rejected.worth:.2f}: {rejected.reason}"


def _behavior(behavior: Behavior, words: Sequence[Word]) -> str:
    """A movement on its words, with what spoke most for it; or why it is not shown."""
    spoken = " ".join(word.text for word in words[behavior.first : behavior.last + 1])
    told = f"{'' if behavior.kept else 'not '}{behavior.kind} {behavior.lexeme.lower()}"
    part = max(behavior.decided_by, key=lambda each: each.weight, default=None)
    why = f"{part.name} {part.weight:+.2f}" if part else behavior.rule or ""
    return f"  {told:30s} {spoken:30s} {why if behavior.kept else behavior.reason or ''}".rstrip()


def _firing(firing: Firing, words: Sequence[Word]) -> Iterator[str]:
    yield f"  {_place(firing.rule)}"
    for said in firing.joined:
        yield _said("", said, words)
    for said in firing.concluded:
        yield _said("→ ", said, words)


def _near_miss(miss: NearMiss, words: Sequence[Word]) -> Iterator[str]:
    yield f"  {_place(miss.rule)}"
    for said in miss.joined:
        yield _said("", said, words)
    for obstacle in miss.obstacles:
        yield _said(f"{obstacle.lack}: ", obstacle.said, words)


def _place(rule: Rule) -> str:
    return f"{rule.name}  {shown_path(rule.path)}:{rule.line}"


def _said(mark: str, said: ShownStatement, words: Sequence[Word]) -> str:
    """A fact, and the words it is about."""
    line = f"    {mark}{said.text}"
    spoken = "" if said.span is None else " ".join(word.text for word in words[slice(*said.span)])
    return f"{line:{WORDS_COLUMN}s} {spoken}".rstrip()
