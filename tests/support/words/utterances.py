"""Utterances for tests: parsed by hand, or by the parser we ship."""

from pathlib import Path

from understudy.model import Clause, Parse, Phrase, Token, Utterance, Word

PARSER = Path(__file__).resolve().parents[3] / "models" / "parser"


def words_of(text: str) -> tuple[Word, ...]:
    """The words of a transcript, without times."""
    return tuple(Word(index, word) for index, word in enumerate(text.split()))


def utterance(
    text: str, tokens: str, *, phrases: tuple[Phrase, ...] = (), clauses: tuple[Clause, ...] = ()
) -> Utterance:
    """An utterance with its tokens spelt `word:text/lemma/part of speech/tag/label/head`, the last three optional."""
    parse = Parse(tuple(_token(index, spelt) for index, spelt in enumerate(tokens.split())), phrases, clauses)
    return Utterance(words_of(text), parse)


def _token(index: int, spelt: str) -> Token:
    word, described = spelt.split(":", 1)
    text, lemma, part_of_speech, *rest = described.split("/")
    tag, label, head = (*rest, "", "", str(index))[:3] if len(rest) == 3 else ("", "dep", str(index))
    return Token(index, int(word), text, lemma, part_of_speech, tag, label, int(head))
