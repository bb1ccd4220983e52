"""Lists authored items for people, one a line, counted by class and file, or explained; summarizes gesture profiles;
and shows which rules fired on a text, and what a corpus never uses.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence

from ...authoring.catalogue import Catalogue, Item, ItemKind, shown_path
from ...authoring.inspection import NearMiss, Rule, RuleFiring, RuleTrace, ShownStatement, Trace, UnusedEntries
from ...model import Behavior, Hand, Moment, Word
from ...profiles.profile import Profile

_MEANING = {
    ItemKind.FUNCTION: "a rule that finds a function",
    ItemKind.BEHAVIOR: "a rule that chooses movements for a function",
    ItemKind.BML: "a movement of the behaviour table",
    ItemKind.WORD: "a word or phrase of the lexicon",
}
_PLURAL = {
    ItemKind.FUNCTION: "function rules",
    ItemKind.BEHAVIOR: "mapping rules",
    ItemKind.BML: "movements",
    ItemKind.WORD: "words",
}
_WITHOUT_CLASS = "(no one class)"
MOST_NAMED = 12


def headline(item: Item) -> str:
    function = " ".join(part for part in (item.class_name, item.subtype) if part)
    return f"{item.kind:8s} {item.name:36s} {function:32s} {item.file}:{item.line}"


def counts(items: Sequence[Item]) -> Iterator[str]:
    """How many of each kind there are in each class, and how many items in each file."""
    tally = Counter((name, item.kind) for item in items for name in _classes(item))
    yield f"{'class':24s}" + "".join(f"{title:>16s}" for title in _PLURAL.values())
    for name in sorted({name for name, _ in tally}):
        yield f"{name:24s}" + "".join(f"{tally[name, kind] or '':>16}" for kind in ItemKind)
    total = Counter(item.kind for item in items)
    yield f"{'all':24s}" + "".join(f"{total[kind]:16d}" for kind in ItemKind)
    yield ""
    for file, count in Counter(item.file for item in items).items():
        yield f"{count:6d}  {file}"


def explanation(catalogue: Catalogue, item: Item) -> Iterator[str]:
    """What an item is, its source, and what it is related to."""
    function = f", {item.class_name} ({item.subtype})" if item.class_name else ""
    yield f"{item.name}: {_MEANING[item.kind]}{function}"
    yield f"  {item.file}:{item.line}"
    for part in (item.comment, item.source):
        yield from (f"    {line}" for line in part.splitlines())
    yield from _related("comes from", catalogue.that_lead_to(item))
    yield from _related("leads to", catalogue.that_follow(item))


def _classes(item: Item) -> Sequence[str]:
    named = item.class_name is not None and not item.class_name.startswith(("$", "_"))
    return item.class_name.split("|") if named and item.class_name else (_WITHOUT_CLASS,)


def _related(relation: str, items: Iterable[Item]) -> Iterator[str]:
    """The related names by kind, cut after the first `MOST_NAMED`."""
    for kind in ItemKind:
        names = list(dict.fromkeys(item.name for item in items if item.kind is kind))
        more = f" and {len(names) - MOST_NAMED} more" if len(names) > MOST_NAMED else ""
        if names:
            yield f"  {relation} {_PLURAL[kind]}: {', '.join(names[:MOST_NAMED])}{more}"


MOST_LEXEMES = 12
MOST_TAGS = 12
MOST_OF_A_TAG = 4


def profile_lines(profile: Profile) -> Iterator[str]:
    """The most prominent habits of a profile; the file has all."""
    yield f"{profile.name}: {profile.description}"
    rate, sizes = profile.gestures_per_minute, profile.units.sizes
    yield f"{rate:.1f} gestures a minute, units of {_mean_size(sizes):.1f} gestures on average"
    if sizes:
        yield f"units of 1, 2, … 6 and more: {' '.join(f'{share:.0%}' for share in sizes)}"
    hands = {hand.value: _share(profile, hand) for hand in Hand}
    yield f"hands: {_shares(hands)}"
    lexemes = {name: habit.share for name, habit in profile.lexemes.items()}
    yield f"gestures: {_shares(lexemes, MOST_LEXEMES)}"
    if profile.head.eye_contact is not None:
        yield f"eyes on the listener {profile.head.eye_contact:.0%} of the time"
    yield "gestures by what is said:"
    by_likelihood = sorted(profile.tags.items(), key=lambda item: -sum(item[1].lexemes.values()))
    for tag, habit in by_likelihood[:MOST_TAGS]:
        yield f"  {tag:24s} {sum(habit.lexemes.values()):4.0%}  {_shares(habit.lexemes, MOST_OF_A_TAG)}"


def _share(profile: Profile, hand: Hand) -> float:
    return sum(habit.share * habit.hands.get(hand, 0.0) for habit in profile.lexemes.values())


def _mean_size(sizes: tuple[float, ...]) -> float:
    return sum(size * share for size, share in enumerate(sizes, start=1)) or 1.0


def _shares(shares: Mapping[str, float], most: int = 99) -> str:
    named = sorted(shares.items(), key=lambda item: (-item[1], item[0]))
    more = f" … {len(named) - most} more" if len(named) > most else ""
    return ", ".join(f"{name} {share:.0%}" for name, share in named[:most]) + more


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
    moment_column = f"  {moment.channel} {moment.families[0]} on {words[moment.stroke].text!r} (word {moment.stroke})"
    yield f"{moment_column:<{WORDS_COLUMN}} {spoken}"
    if moment.set_against is not None:
        yield f"    placed {moment.families[1]}, against {words[moment.set_against].text!r} (word {moment.set_against})"
    for term in moment.terms:
        yield f"    {term.weight:+.2f}  {term.name}"
    for rejected in moment.rejected:
        yield f"    not {', '.join(rejected.families)}, worth {rejected.worth:.2f}: {rejected.reason}"


def _behavior(behavior: Behavior, words: Sequence[Word]) -> str:
    """A movement on its words, with what spoke most for it; or why it is not shown."""
    spoken = " ".join(word.text for word in words[behavior.first : behavior.last + 1])
    described = f"{'' if behavior.kept else 'not '}{behavior.kind} {behavior.lexeme.lower()}"
    part = max(behavior.decided_by, key=lambda each: each.weight, default=None)
    why = f"{part.name} {part.weight:+.2f}" if part else behavior.rule or ""
    return f"  {described:30s} {spoken:30s} {why if behavior.kept else behavior.reason or ''}".rstrip()


def _firing(firing: RuleFiring, words: Sequence[Word]) -> Iterator[str]:
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
