"""What the parser is trained on: treebank sentences changed to look transcribed."""

from pathlib import Path

import pytest

from training.parser.augmentation import as_transcribed, to_documents
from training.parser.treebank import Row, Sentence, lower_cased, read_treebank, without_punctuation

CONLLU = """\
# text = Yes, I do.
1-2	Yes,	_	_	_	_	_	_	_	_
1	Yes	yes	INTJ	UH	_	4	discourse	_	SpaceAfter=No
2	,	,	PUNCT	,	_	1	punct	_	_
2.1	x	_	_	_	_	_	_	_	_
3	I	I	PRON	PRP	Case=Nom	4	nsubj	_	_
4	do	do	AUX	VBP	_	0	root	_	SpaceAfter=No
5	.	.	PUNCT	.	_	4	punct	_	_

1	!	!	PUNCT	.	_	0	root	_	_

"""


@pytest.fixture
def sentences(tmp_path: Path) -> list[Sentence]:
    path = tmp_path / "some.conllu"
    path.write_text(CONLLU, encoding="utf-8")
    return read_treebank(path)


def test_reading_leaves_out_ranges_and_empty_nodes(sentences: list[Sentence]) -> None:
    assert [[row.form for row in sentence] for sentence in sentences] == [["Yes", ",", "I", "do", "."], ["!"]]
    assert sentences[0][0] == Row("Yes", "yes", "INTJ", "UH", 4, "discourse", space_after=False)


def test_punctuation_goes_and_heads_are_numbered_anew(sentences: list[Sentence]) -> None:
    plain = without_punctuation(sentences[0])
    assert [(row.form, row.head, row.space_after) for row in plain] == [
        ("Yes", 3, True),
        ("I", 3, True),
        ("do", 0, True),
    ]
    assert without_punctuation(sentences[1]) == ()


def _row(form: str, head: int, relation: str, tag: str = "NOUN") -> Row:
    return Row(form, form, tag, "NN", head, relation, space_after=True)


def test_what_hung_on_punctuation_hangs_on_its_head() -> None:
    sentence = (_row("a", 0, "root"), _row("-", 1, "punct", "PUNCT"), _row("b", 2, "appos"))
    assert [(row.form, row.head, row.relation) for row in without_punctuation(sentence)] == [
        ("a", 0, "root"),
        ("b", 1, "appos"),
    ]


def test_a_root_of_punctuation_hands_over_to_the_first_orphan() -> None:
    sentence = (_row("*", 0, "root", "PUNCT"), _row("a", 1, "obj"), _row("b", 1, "obl"))
    assert [(row.head, row.relation) for row in without_punctuation(sentence)] == [(0, "root"), (1, "parataxis")]


def test_lower_case_takes_the_lemmas_along_but_for_i(sentences: list[Sentence]) -> None:
    assert [(row.form, row.lemma) for row in lower_cased(sentences[0])][2:4] == [("i", "I"), ("do", "do")]
    assert lower_cased((_row("Boston", 0, "root"),))[0].lemma == "boston"


def test_documents_hold_the_trees(sentences: list[Sentence]) -> None:
    (document,) = to_documents(sentences, 2)
    assert document.text.rstrip() == "Yes, I do. !"
    assert [token.head.i for token in document] == [3, 0, 3, 3, 3, 5]
    assert [sentence.start for sentence in document.sents] == [0, 5]
    assert [len(one) for one in to_documents(as_transcribed(sentences), 1)] == [3]
