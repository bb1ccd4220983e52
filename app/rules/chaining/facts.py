"""Converts an analysed utterance to the facts of `vocabulary.rules`, the input of the rules.

Conventions: a span is a pair of boundaries; word 3 is from 3 to 4. Words are in lower case without surrounding
punctuation, which has facts of its own, at boundaries. Tokens that the parser splits from a word ("do" and "n't") have
their facts on the word's span. Nothing is derived here except sentences, which end at the line's own punctuation.
"""

import re
from bisect import bisect_right
from collections.abc import Iterator

from ...model import Fact, LineAffect, Token, Tone, Utterance, Word

LONGEST_SENTENCE = 150
"""Words; longer sentences are cut there."""

LEAST_FOCUS = 0.01
"""Smaller shares of the focus are no facts."""

SHORTEST_PAUSE_S = 0.2
"""Shorter gaps between words are stop closures, not pauses."""

_KEPT = "_&$%"
"""Characters that belong to a word besides letters and digits; at its beginning an apostrophe does too."""

_MARKS = re.compile(r"\.{2,}|…|[-–—]+|[^\w\s]")
_SAME_MARK = {"…": "...", "’": "'", "“": '"', "”": '"'}
_ABBREVIATIONS = frozenset(("mr", "mrs", "ms", "dr", "st", "prof", "sr", "jr", "vs", "u.s", "a.m", "p.m", "i.e", "e.g"))


def normalized_word(text: str) -> str:
    """The word as spelled in lexicon and rules: lower case, straight apostrophes, no surrounding punctuation."""
    plain = text.replace("’", "'").replace("‘", "'").lower()
    begin = next((at for at, each in enumerate(plain) if each.isalnum() or each in _KEPT + "'"), len(plain))
    past = next((at for at in range(len(plain), begin, -1) if plain[at - 1].isalnum() or plain[at - 1] in _KEPT), begin)
    return plain[begin:past]


def utterance_facts(utterance: Utterance) -> tuple[Fact, ...]:
    """The given facts of an utterance, in the order of `vocabulary.rules`, without duplicates."""
    facts = (
        *_word_facts(utterance.words),
        *_quotation_facts(utterance.words),
        *_bracket_facts(utterance.words),
        *_token_facts(utterance.parse.tokens),
        *_phrase_facts(utterance),
        *_sentence_facts(utterance.words),
        *_heard_facts(utterance),
    )
    return tuple(dict.fromkeys(facts))


def _word_facts(words: tuple[Word, ...]) -> Iterator[Fact]:
    for word in words:
        start, end, text = word.index, word.index + 1, normalized_word(word.text)
        leading, trailing = _around(word.text, text)
        if text:
            yield Fact("word", (text, start, end))
        whole = _stutter(text)
        if whole:
            yield Fact("stutter", (whole, start, end))
        for mark in leading if text else leading + trailing:
            yield Fact("punctuation", (mark, start))
        for mark in trailing if text else leading + trailing:
            yield Fact("punctuation", (mark, end))


def _quotation_facts(words: tuple[Word, ...]) -> Iterator[Fact]:
    """The words between an opening quotation mark and the next closing one; an unclosed quotation goes on to the
    end."""
    start: int | None = None
    for word in words:
        text = normalized_word(word.text)
        leading, trailing = _around(word.text, text)
        if '"' in leading and start is None:
            start = word.index
        if '"' in (trailing if text else leading[1:]) and start is not None:
            yield Fact("quotation", (start, word.index + 1))
            start = None
    if start is not None:
        yield Fact("quotation", (start, len(words)))


def _bracket_facts(words: tuple[Word, ...]) -> Iterator[Fact]:
    """The words between matching round brackets."""
    opened: list[int] = []
    for word in words:
        leading, trailing = _around(word.text, normalized_word(word.text))
        for mark in leading + trailing:
            if mark == "(":
                opened.append(word.index)
            elif mark == ")" and opened:
                yield Fact("bracketed", (opened.pop(), word.index + 1))


def _stutter(text: str) -> str | None:
    """The word that is stuttered in "i-i-i" or "th-they"; None for any other word."""
    *begun, whole = text.split("-")
    return whole if begun and all(part and whole.startswith(part) for part in begun) else None


def _around(text: str, inner: str) -> tuple[list[str], list[str]]:
    """The punctuation before and after the word itself; if there is nothing else, all of it is before."""
    if not inner:
        return _marks(text), []
    begin = text.replace("’", "'").replace("‘", "'").lower().find(inner)
    return _marks(text[:begin]), _marks(text[begin + len(inner) :])


def _marks(text: str) -> list[str]:
    marks = (_SAME_MARK.get(mark, mark) for mark in _MARKS.findall(text))
    return ["..." if mark.startswith("..") else "-" if mark[0] in "-–—" else mark for mark in marks]


def _token_facts(tokens: tuple[Token, ...]) -> Iterator[Fact]:
    for token in tokens:
        if token.part_of_speech == "PUNCT":
            continue
        start, end = token.word, token.word + 1
        yield Fact("lemma", (token.lemma.lower(), start, end))
        yield Fact("part_of_speech", (token.part_of_speech, start, end))
        yield Fact("tag", (token.tag, start, end))
        head = tokens[token.head].word
        if head != start:
            yield Fact("dependency", (token.dependency, head, start))


def _phrase_facts(utterance: Utterance) -> Iterator[Fact]:
    predicates = {"noun": "noun_phrase", "verb": "verb_phrase"}
    seen: set[str] = set()
    for phrase in utterance.parse.phrases:
        predicate, start, end = predicates[phrase.kind], phrase.first, phrase.last + 1
        yield Fact(predicate, (start, end, phrase.head))
        if predicate not in seen:
            seen.add(predicate)
            yield Fact(f"first_{predicate}", (start, end))
    for clause in utterance.parse.clauses:
        yield Fact("clause", (clause.label, clause.first, clause.last + 1, clause.head))


def _sentence_facts(words: tuple[Word, ...]) -> Iterator[Fact]:
    start = 0
    for word in words:
        end = word.index + 1
        is_last = end == len(words) or end - start == LONGEST_SENTENCE
        if is_last or _ends_sentence(word.text, words[end].text):
            yield Fact("sentence", (start, end))
            yield from (Fact("in_sentence", (position, start, end)) for position in range(start, end))
            start = end
    if words:
        yield Fact("utterance", (0, len(words)))


def _ends_sentence(text: str, following: str) -> bool:
    """Whether the full stop, question mark, exclamation mark or ellipsis after a word ends a sentence."""
    marks = _around(text, normalized_word(text))[1]
    if "?" in marks or "!" in marks:
        return True
    if "..." in marks:
        return following[:1].isupper()
    return "." in marks and normalized_word(text) not in _ABBREVIATIONS


def _heard_facts(utterance: Utterance) -> Iterator[Fact]:
    before_s: float | None = None
    for word in utterance.words:
        yield from _stress_facts(word)
        if word.interval is None:
            continue
        if before_s is not None and word.interval.start_s - before_s >= SHORTEST_PAUSE_S:
            yield Fact("pause", (round(word.interval.start_s - before_s, 3), word.index))
        before_s = word.interval.end_s
    timed = [word for word in utterance.words if word.interval]
    for filler in utterance.fillers:
        later = bisect_right(timed, filler.interval.start_s, key=_start_s)
        yield Fact("heard_filler", (filler.text, timed[later].index if later < len(timed) else len(utterance.words)))
    if utterance.agitation is not None:
        yield Fact("agitation", (utterance.agitation.level.value,))
    if utterance.affect is not None:
        yield from _affect_facts(utterance.affect)


def _affect_facts(affect: LineAffect) -> Iterator[Fact]:
    """The line's tones and dimensions, and the likeliest tone of each phrase."""
    for tone in Tone:
        yield Fact("tone", (tone.value, round(affect.line.share(tone), 3)))
    for name in ("activation", "valence", "dominance"):
        yield Fact(name, (round(getattr(affect.line, name), 3),))
    for phrase in affect.phrases:
        tone = phrase.affect.tone
        yield Fact("phrase_tone", (tone.value, phrase.first, phrase.last + 1, round(phrase.affect.share(tone), 3)))


def _stress_facts(word: Word) -> Iterator[Fact]:
    focus = word.focus if word.focus is not None and word.focus >= LEAST_FOCUS else None
    measures = (
        ("stressed_ratio", word.stressed_ratio),
        ("prominence", None if word.prominence is None else round(word.prominence, 3)),
        ("emphasis", word.emphasis),
        ("heard_focus", None if focus is None else round(focus, 3)),
    )
    for predicate, measure in measures:
        if measure is not None:
            yield Fact(predicate, (measure, word.index, word.index + 1))


def _start_s(word: Word) -> float:
    return word.interval.start_s if word.interval else 0.0
