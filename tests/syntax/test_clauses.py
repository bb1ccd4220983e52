"""Clauses of trees written by hand."""

from tests.support.words.syntax_trees import read_tree
from tests.syntax.test_phrases import FIGURE_8
from understudy.syntax.phrases import Tree, find_clauses


def _clauses(table: str) -> list[tuple[str, int, int, int]]:
    return [(c.label, c.first, c.last, c.head) for c in find_clauses(Tree.of(read_tree(table)))]


def test_the_paper_s_figure_8() -> None:
    assert _clauses(FIGURE_8) == [("root", 0, 2, 1), ("parataxis", 3, 4, 4), ("ccomp", 5, 11, 7)]


def test_a_clause_spans_what_lies_in_it() -> None:
    table = """
        The    DET  DT  det       1
        man    NOUN NN  nsubj     4
        who    PRON WP  nsubj     3
        called VERB VBD acl:relcl 1
        left   VERB VBD root      4
    """
    assert _clauses(table) == [("root", 0, 4, 4), ("acl:relcl", 2, 3, 3)]


def test_only_predicates_head_clauses() -> None:
    joined_nouns = """
        cats  NOUN  NNS root 0
        and   CCONJ CC  cc   2
        dogs  NOUN  NNS conj 0
    """
    assert _clauses(joined_nouns) == [("root", 0, 2, 0)]
    joined_predicates = """
        good  ADJ   JJ  root  0
        but   CCONJ CC  cc    4
        it    PRON  PRP nsubj 4
        +'s   AUX   VBZ cop   4
        over  ADJ   JJ  conj  0
    """
    assert _clauses(joined_predicates) == [("root", 0, 0, 0), ("conj", 1, 3, 3)]


def test_every_sentence_has_its_root_clause_and_punctuation_none() -> None:
    table = """
        Yes  INTJ  UH root  0
        +.   PUNCT .  punct 0
        Go   VERB  VB root  2
        -    PUNCT :  root  3
    """
    assert _clauses(table) == [("root", 0, 0, 0), ("root", 1, 1, 1)]


def test_punctuation_alone_has_no_clause() -> None:
    assert _clauses("... PUNCT . root 0") == []
