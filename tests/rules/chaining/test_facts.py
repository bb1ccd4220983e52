"""The given facts of an utterance."""

from dataclasses import replace

import pytest

from tests.support.words.utterances import utterance, words_of
from understudy.model import (
    Affect,
    Agitation,
    Clause,
    Fact,
    Filler,
    Interval,
    LineAffect,
    Phrase,
    PhraseAffect,
    Utterance,
)
from understudy.rules.chaining.facts import normalized_word, utterance_facts


def arguments(spoken: Utterance, predicate: str) -> set[tuple[object, ...]]:
    return {fact.arguments for fact in utterance_facts(spoken) if fact.predicate == predicate}


@pytest.mark.parametrize(
    ("written", "spelt"),
    [
        ("Don’t!", "don't"),
        ('"No,"', "no"),
        ("-n't", "n't"),
        ("'cause", "'cause"),
        ("uh-huh...", "uh-huh"),
        ("--", ""),
        ("((", ""),
        ("$5.", "$5"),
    ],
)
def test_words_are_spelt_without_the_punctuation_around_them(written: str, spelt: str) -> None:
    assert normalized_word(written) == spelt


def test_a_contraction_has_the_facts_of_its_parts_on_its_own_span() -> None:
    spoken = utterance(
        "I don't know.",
        "0:I/I/PRON/PRP/nsubj/3 1:do/do/AUX/VBP/aux/3 1:n't/not/PART/RB/advmod/3 "
        "2:know/know/VERB/VB/root/3 2:././PUNCT",
    )
    assert arguments(spoken, "word") == {("i", 0, 1), ("don't", 1, 2), ("know", 2, 3)}
    assert {("do", 1, 2), ("not", 1, 2)} <= arguments(spoken, "lemma")
    assert {("AUX", 1, 2), ("PART", 1, 2)} <= arguments(spoken, "part_of_speech")
    assert arguments(spoken, "dependency") == {("nsubj", 2, 0), ("aux", 2, 1), ("advmod", 2, 1)}
    assert ("PUNCT", 2, 3) not in arguments(spoken, "part_of_speech")


def test_punctuation_stands_at_boundaries() -> None:
    spoken = Utterance(words_of('Well, "you -- said?!" So...'), utterance("", "").parse)
    assert arguments(spoken, "punctuation") == {
        (",", 1),
        ('"', 1),
        ("-", 2),
        ("-", 3),
        ("?", 4),
        ("!", 4),
        ('"', 4),
        ("...", 5),
    }


def test_sentences_end_at_their_marks_but_not_at_abbreviations() -> None:
    spoken = Utterance(words_of("Ask Dr. Green. No. Why? Well... I mean so... what now"), utterance("", "").parse)
    assert sorted(arguments(spoken, "sentence")) == [(0, 3), (3, 4), (4, 5), (5, 6), (6, 11)]
    assert arguments(spoken, "utterance") == {(0, 11)}
    assert {(position, 6, 11) for position in range(6, 11)} <= arguments(spoken, "in_sentence")


def test_brackets_are_closed_by_the_bracket_that_is_theirs() -> None:
    spoken = Utterance(words_of("They (all (or most) of them) came) to (us"), utterance("", "").parse)
    assert arguments(spoken, "bracketed") == {(1, 6), (2, 4)}


def test_phrases_and_clauses_run_between_boundaries_and_the_first_of_each_kind_is_told() -> None:
    spoken = utterance(
        "my dog has seen you",
        "",
        phrases=(Phrase("noun", 0, 1, 1), Phrase("verb", 2, 3, 3), Phrase("noun", 4, 4, 4)),
        clauses=(Clause("root", 0, 4, 3),),
    )
    assert arguments(spoken, "noun_phrase") == {(0, 2, 1), (4, 5, 4)}
    assert arguments(spoken, "first_noun_phrase") == {(0, 2)}
    assert arguments(spoken, "first_verb_phrase") == {(2, 4)}
    assert arguments(spoken, "clause") == {("root", 0, 5, 3)}


def test_what_is_heard_becomes_facts_and_short_gaps_are_no_pauses() -> None:
    first, second, third = words_of("so it goes")
    spoken = Utterance(
        (
            replace(first, interval=Interval(0.0, 0.4), stressed_ratio=0.25, prominence=0.75, focus=0.9912),
            replace(second, interval=Interval(0.5, 0.7), stressed_ratio=0.0, focus=0.0088),
            replace(third, interval=Interval(1.0, 1.2), stressed_ratio=0.0),
        ),
        utterance("", "").parse,
        agitation=Agitation(0.1, 0.2, 0.7),
    )
    assert arguments(spoken, "stressed_ratio") == {(0.25, 0, 1), (0.0, 1, 2), (0.0, 2, 3)}
    assert arguments(spoken, "prominence") == {(0.75, 0, 1)}
    assert arguments(spoken, "heard_focus") == {(0.991, 0, 1)}
    assert arguments(spoken, "pause") == {(0.3, 2)}
    assert arguments(spoken, "agitation") == {("high",)}


def test_how_a_line_and_its_phrases_sound_becomes_facts() -> None:
    sad = Affect(-0.4, -0.5, 0.1, (0.25, 0.0, 0.75, 0.0, 0.0, 0.0, 0.0))
    spoken = replace(utterance("so it", ""), affect=LineAffect(sad, (PhraseAffect(0, 1, sad),)))
    assert {("sad", 0.75), ("neutral", 0.25), ("angry", 0.0)} <= arguments(spoken, "tone")
    assert arguments(spoken, "activation") == {(-0.4,)}
    assert arguments(spoken, "phrase_tone") == {("sad", 0, 2, 0.75)}


def test_a_filler_stands_at_the_boundary_before_the_word_that_follows_it() -> None:
    first, dash, second = words_of("so — it")
    words = (replace(first, interval=Interval(0.5, 0.9)), dash, replace(second, interval=Interval(1.4, 1.5)))
    fillers = (Filler("um", Interval(0.1, 0.4)), Filler("uh", Interval(1.0, 1.3)), Filler("um", Interval(1.5, 1.9)))
    spoken = replace(utterance("so — it", ""), words=words, fillers=fillers)
    assert arguments(spoken, "heard_filler") == {("um", 0), ("uh", 2), ("um", 3)}


def test_nothing_heard_and_nothing_said_leave_no_facts() -> None:
    assert utterance_facts(utterance("", "")) == ()
    assert not any(fact.predicate in ("agitation", "pause") for fact in utterance_facts(utterance("Yes", "")))


def test_facts_are_not_repeated() -> None:
    facts = utterance_facts(utterance("no no", "0:no/no/INTJ 1:no/no/INTJ"))
    assert len(facts) == len(set(facts))
    assert Fact("word", ("no", 1, 2)) in facts
