"""The training and development corpora: the treebanks as written, and about as many words again as if transcribed.

Off-the-shelf parsers expect capitals and full stops; transcripts often have neither. So copies of the training
sentences are given in lower case and without punctuation, half of them alone in their document, half by fives, and
smaller shares only in lower case or only without punctuation. GUM, where the speech is, is copied whole, EWT by half.
"""

import random
from collections.abc import Iterable, Iterator, Sequence
from itertools import accumulate
from pathlib import Path

from spacy.tokens import Doc, DocBin
from spacy.vocab import Vocab

from training.parser.treebank import Sentence, lower_cased, read_treebank, without_punctuation

SENTENCES_AS_WRITTEN = 10
SENTENCES_IN_PART = 3
SENTENCES_TOGETHER = 5
SHARE_OF_WRITTEN = 0.5
SHARE_IN_PART = 0.15
SEED = 0


def write_corpora(treebanks: Path, folder: Path) -> None:
    """Writes `train.spacy` and `dev.spacy` into `folder`, from the train and dev files of EWT and GUM alone."""
    written, spoken = (read_treebank(treebanks / f"{name}-train.conllu") for name in ("ewt", "gum"))
    _write(_training_documents(written, spoken), folder / "train.spacy")
    development = [read_treebank(treebanks / f"{name}-dev.conllu") for name in ("ewt", "gum", "spoken")]
    _write(_development_documents(*development), folder / "dev.spacy")


def as_transcribed(sentences: Iterable[Sentence]) -> list[Sentence]:
    """The sentences in lower case and without punctuation; those of punctuation alone are left out."""
    return [plain for sentence in sentences if (plain := lower_cased(without_punctuation(sentence)))]


def to_documents(sentences: Sequence[Sentence], size: int) -> Iterator[Doc]:
    """The sentences as spaCy documents of `size` sentences each."""
    vocabulary = Vocab()
    for start in range(0, len(sentences), size):
        yield _to_document(sentences[start : start + size], vocabulary)


def _to_document(sentences: Sequence[Sentence], vocabulary: Vocab) -> Doc:
    rows = [row for sentence in sentences for row in sentence]
    begins = accumulate((len(sentence) for sentence in sentences[:-1]), initial=0)
    heads = [
        begin + (row.head - 1 if row.head else place)
        for begin, sentence in zip(begins, sentences, strict=True)
        for place, row in enumerate(sentence)
    ]
    return Doc(
        vocabulary,
        words=[row.form for row in rows],
        spaces=[row.space_after or row is sentence[-1] for sentence in sentences for row in sentence],
        pos=[row.universal_tag for row in rows],
        tags=[row.penn_tag for row in rows],
        morphs=[""] * len(rows),
        lemmas=[row.lemma for row in rows],
        heads=heads,
        deps=["ROOT" if row.relation == "root" else row.relation for row in rows],
        sent_starts=[place == 0 for sentence in sentences for place in range(len(sentence))],
    )


def _training_documents(written: list[Sentence], spoken: list[Sentence]) -> Iterator[Doc]:
    chance = random.Random(SEED)
    for treebank in (written, spoken):
        yield from to_documents(treebank, SENTENCES_AS_WRITTEN)
    transcribed = as_transcribed(spoken + _share(written, SHARE_OF_WRITTEN, chance))
    alone = [chance.random() < 0.5 for _ in transcribed]
    yield from to_documents([s for s, is_alone in zip(transcribed, alone, strict=True) if is_alone], 1)
    together = [s for s, is_alone in zip(transcribed, alone, strict=True) if not is_alone]
    yield from to_documents(together, SENTENCES_TOGETHER)
    lower = [lower_cased(sentence) for sentence in _share(written + spoken, SHARE_IN_PART, chance)]
    yield from to_documents(lower, SENTENCES_IN_PART)
    unpunctuated = [without_punctuation(sentence) for sentence in _share(written + spoken, SHARE_IN_PART, chance)]
    yield from to_documents([sentence for sentence in unpunctuated if sentence], SENTENCES_IN_PART)


def _development_documents(written: list[Sentence], gum: list[Sentence], spoken: list[Sentence]) -> Iterator[Doc]:
    for treebank in (written, gum):
        yield from to_documents(treebank, SENTENCES_AS_WRITTEN)
    yield from to_documents(as_transcribed(spoken), 1)


def _share(sentences: list[Sentence], share: float, chance: random.Random) -> list[Sentence]:
    return [sentence for sentence in sentences if chance.random() < share]


def _write(documents: Iterable[Doc], path: Path) -> None:
    DocBin(docs=documents, store_user_data=False).to_disk(path)
