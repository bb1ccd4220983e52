"""Accuracy of the speech parser: the pipeline alone on treebanks, then what the rules get from it, then its cost.

    python -m benchmarks.syntax.parser [--parser FOLDER_OR_NAME] [--treebanks FOLDER] [--split test|dev]

Pipeline: spaCy's scores in percent on the raw text, which the tokenizer cuts; UAS and LAS leave punctuation out. Test
documents hold ten sentences; "plain" is lower case without punctuation, one sentence a document or ten.
Program: `Parser.parse` on the same lines, ten sentences each, against the treebank's trees put through the same rules.
LAS here counts a gold word right when a token stands exactly there with the same head and label. Noun phrases and verb
groups are compared by span, clauses by head: F1. Cost: one core (set OMP_NUM_THREADS=1), 15-word utterances.
"""

import argparse
import statistics
import time
from collections import Counter
from collections.abc import Callable, Hashable, Sequence
from functools import partial
from pathlib import Path

import spacy
from spacy.tokens import Doc
from spacy.training import Example

from training.parser.augmentation import as_transcribed, to_documents
from training.parser.treebank import Sentence, read_treebank
from understudy.model import Parse, Token, Word
from understudy.syntax.parser import Parser
from understudy.syntax.phrases import Tree, find_clauses, find_phrases
from understudy.syntax.tokens import Scheme, read_tokens

ROOT = Path(__file__).resolve().parents[2]
SCORES = {"UPOS": "pos_acc", "XPOS": "tag_acc", "lemma": "lemma_acc", "UAS": "dep_uas", "LAS": "dep_las"}
UTTERANCE_WORDS = 15
UTTERANCES = 300
Sets = dict[str, tuple[Sequence[Sentence], int]]
Tallies = dict[str, Counter[str]]


def main() -> None:
    """Prints the three tables."""
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--parser", default=str(ROOT / "models" / "parser"))
    arguments.add_argument("--treebanks", type=Path, default=ROOT.parent / "shared" / "data" / "treebanks")
    arguments.add_argument("--split", choices=("test", "dev"), default="test")
    options = arguments.parse_args()
    names = ("ewt", "gum", "spoken")
    treebanks = {name: read_treebank(options.treebanks / f"{name}-{options.split}.conllu") for name in names}
    plain = as_transcribed(treebanks["spoken"])
    sets: Sets = {name: (bank, 10) for name, bank in treebanks.items()}
    sets |= {"spoken plain, by one": (plain, 1), "spoken plain, by ten": (plain, 10)}
    nlp = spacy.load(options.parser)
    parser = Parser.load(options.parser)
    print_pipeline(nlp, sets)
    print_program(parser, sets)
    print_cost(options.parser, parser, treebanks["spoken"])


def print_pipeline(nlp: spacy.language.Language, sets: Sets) -> None:
    """spaCy's scores on each set."""
    print(f"{'pipeline':22}" + "".join(f"{name:>8}" for name in SCORES))
    for name, (sentences, size) in sets.items():
        references = to_documents(sentences, size)
        scores = nlp.evaluate([Example(nlp.make_doc(reference.text), reference) for reference in references])
        print(f"{name:22}" + "".join(f"{100 * scores[key]:8.1f}" for key in SCORES.values()))


def print_program(parser: Parser, sets: Sets) -> None:
    """What the rules get, on each set."""
    print(f"\n{'program':22}" + "".join(f"{name:>8}" for name in ("LAS", "sent.", "noun", "verb", "clause")))
    for name, (sentences, size) in sets.items():
        tallies: Tallies = {}
        for reference in to_documents(sentences, size):
            compare(parser, reference, tallies)
        recall = 100 * tallies["LAS"]["hits"] / tallies["LAS"]["gold"]
        values = [recall, *(100 * f1(tallies[kind]) for kind in ("sentence", "noun", "verb", "clause"))]
        print(f"{name:22}" + "".join(f"{value:8.1f}" for value in values))


def compare(parser: Parser, reference: Doc, tallies: Tallies) -> None:
    """Adds what the parse of a document's text shares with its gold parse."""
    texts = reference.text.split()
    found = parser.parse(tuple(Word(number, text) for number, text in enumerate(texts)))
    numbers = word_numbers(reference)
    tokens = read_tokens(reference, numbers, Scheme.UNIVERSAL)
    tree = Tree.of(tokens)
    gold = Parse(tokens, find_phrases(tree), find_clauses(tree))
    gold_items, found_items = items(gold), items(found)
    for kind, wanted in gold_items.items():
        tally = tallies.setdefault(kind, Counter())
        tally["hits"] += (wanted & found_items[kind]).total()
        tally["gold"] += wanted.total()
        tally["found"] += found_items[kind].total()


def word_numbers(document: Doc) -> list[int]:
    """The white-space word of each token of a gold document."""
    numbers, number = [], 0
    for token in document:
        numbers.append(number)
        number += bool(token.whitespace_)
    return numbers


def items(parse: Parse) -> dict[str, Counter[Hashable]]:
    """What is compared, each countable by equality."""
    places = token_places(parse.tokens)
    counted = [token for token in parse.tokens if token.part_of_speech != "PUNCT"]
    return {
        "LAS": Counter((places[t.index], t.dependency, places[t.head]) for t in counted),
        "sentence": Counter(tree_begins(parse.tokens)[1:]),
        "noun": Counter((phrase.first, phrase.last) for phrase in parse.phrases if phrase.kind == "noun"),
        "verb": Counter((phrase.first, phrase.last) for phrase in parse.phrases if phrase.kind == "verb"),
        "clause": Counter(clause.head for clause in parse.clauses),
    }


def token_places(tokens: tuple[Token, ...]) -> list[tuple[int, int, str]]:
    """Where each token stands: its word, the characters of that word before it, its text."""
    places, word, before = [], -1, 0
    for token in tokens:
        before = 0 if token.word != word else before
        word = token.word
        places.append((word, before, token.text))
        before += len(token.text)
    return places


def tree_begins(tokens: tuple[Token, ...]) -> list[int]:
    """The first word of each tree."""
    begins: dict[int, int] = {}
    for token in tokens:
        begins.setdefault(root_of(tokens, token), token.word)
    return list(begins.values())


def root_of(tokens: tuple[Token, ...], token: Token) -> int:
    while token.head != token.index:
        token = tokens[token.head]
    return token.index


def f1(tally: Counter[str]) -> float:
    """The harmonic mean of precision and recall."""
    return 2 * tally["hits"] / max(1, tally["gold"] + tally["found"])


def print_cost(where: str, parser: Parser, sentences: Sequence[Sentence]) -> None:
    """Size, load time and time per utterance of fifteen words."""
    words = [text for reference in to_documents(sentences, 10) for text in reference.text.split()]
    chunks = [words[start : start + UTTERANCE_WORDS] for start in range(0, len(words), UTTERANCE_WORDS)][:UTTERANCES]
    lines = [tuple(Word(number, text) for number, text in enumerate(chunk)) for chunk in chunks]
    durations_ms = [1000 * seconds(partial(parser.parse, line)) for line in lines]
    load_s = statistics.median(seconds(partial(Parser.load, where)) for _ in range(3))
    print(f"\nload {load_s:.2f} s; 15 words: median {statistics.median(durations_ms):.1f} ms, ", end="")
    print(f"95 % under {statistics.quantiles(durations_ms, n=20)[-1]:.1f} ms")
    if Path(where).is_dir():
        size = sum(path.stat().st_size for path in Path(where).rglob("*") if path.is_file())
        print(f"on disk {size / 1e6:.1f} MB")


def seconds(task: Callable[[], object]) -> float:
    """Wall time of a call."""
    start = time.perf_counter()
    task()
    return time.perf_counter() - start


if __name__ == "__main__":
    main()
