"""Documents with either kind of labels give the same records."""

import pytest

from tests.support.words.syntax_trees import read_tree
from understudy.model import Token
from understudy.syntax.phrases import Tree, find_clauses, find_phrases
from understudy.syntax.tokens import Scheme, scheme_of

PAIRS = {
    "objects, negation and particle": (
        """
        I    PRON PRP nsubj 3
        do   AUX  VBP aux   3
        +n't PART RB  neg   3
        give VERB VB  ROOT  3
        up   ADP  RP  prt   3
        my   PRON PRP$ poss 6
        life NOUN NN  dobj  3
        """,
        """
        I    PRON PRP nsubj        3
        do   AUX  VBP aux          3
        +n't PART RB  advmod       3
        give VERB VB  root         3
        up   ADP  RP  compound:prt 3
        my   PRON PRP$ nmod:poss   6
        life NOUN NN  obj          3
        """,
    ),
    "preposition after a verb and after a noun": (
        """
        look    VERB VB  ROOT 0
        at      ADP  IN  prep 0
        all     DET  DT  pobj 1
        of      ADP  IN  prep 2
        those   DET  DT  det  5
        signals NOUN NNS pobj 3
        """,
        """
        look    VERB VB  root 0
        at      ADP  IN  case 2
        all     DET  DT  obl  0
        of      ADP  IN  case 5
        those   DET  DT  det  5
        signals NOUN NNS nmod 2
        """,
    ),
    "copula": (
        """
        She    PRON  PRP nsubj 1
        is     AUX   VBZ ccomp 5
        a      DET   DT  det   3
        friend NOUN  NN  attr  1
        I      PRON  PRP nsubj 5
        think  VERB  VBP ROOT  5
        +.     PUNCT .   punct 5
        """,
        """
        She    PRON  PRP nsubj 3
        is     AUX   VBZ cop   3
        a      DET   DT  det   3
        friend NOUN  NN  ccomp 5
        I      PRON  PRP nsubj 5
        think  VERB  VBP root  5
        +.     PUNCT .   punct 5
        """,
    ),
    "copula at the root, with negation": (
        """
        It   PRON PRP nsubj 1
        is   AUX  VBZ ROOT  1
        not  PART RB  neg   1
        fair ADJ  JJ  acomp 1
        """,
        """
        It   PRON PRP nsubj  3
        is   AUX  VBZ cop    3
        not  PART RB  advmod 3
        fair ADJ  JJ  root   3
        """,
    ),
    "passive with its agent": (
        """
        He     PRON PRP nsubjpass 2
        was    AUX  VBD auxpass   2
        seen   VERB VBN ROOT      2
        by     ADP  IN  agent     2
        nobody PRON NN  pobj      3
        """,
        """
        He     PRON PRP nsubj:pass 2
        was    AUX  VBD aux:pass   2
        seen   VERB VBN root       2
        by     ADP  IN  case       4
        nobody PRON NN  obl:agent  2
        """,
    ),
    "preposition before a clause, and one without object": (
        """
        before ADP  IN  prep  2
        going  VERB VBG pcomp 0
        come   VERB VB  ROOT  2
        in     ADP  IN  prep  2
        """,
        """
        before ADP  IN  mark   1
        going  VERB VBG advcl  2
        come   VERB VB  root   2
        in     ADP  IN  advmod 2
        """,
    ),
}


def _shape(tokens: tuple[Token, ...]) -> list[tuple[str, str, int]]:
    return [(token.text, token.dependency, token.head) for token in tokens]


@pytest.mark.parametrize("construction", PAIRS)
def test_clearnlp_labels_give_the_universal_tree(construction: str) -> None:
    clearnlp, universal = PAIRS[construction]
    translated = read_tree(clearnlp, Scheme.CLEARNLP)
    expected = read_tree(universal)
    assert _shape(translated) == _shape(expected)
    ours, theirs = Tree.of(expected), Tree.of(translated)
    assert find_phrases(theirs) == find_phrases(ours)
    assert find_clauses(theirs) == find_clauses(ours)


def test_a_prepositional_chain_stays_a_tree() -> None:
    table = """
        come   VERB VB ROOT  0
        from   ADP  IN prep  0
        behind ADP  IN pcomp 1
        the    DET  DT det   4
        wall   NOUN NN pobj  2
    """
    tokens = read_tree(table, Scheme.CLEARNLP)
    for token in tokens:
        steps = 0
        while token.head != token.index:
            token, steps = tokens[token.head], steps + 1  # noqa: PLW2901
            assert steps <= len(tokens)


@pytest.mark.parametrize(
    ("labels", "scheme"),
    [
        ({"nsubj", "obj", "obl", "ROOT"}, Scheme.UNIVERSAL),
        ({"nsubj", "dobj", "pobj", "ROOT"}, Scheme.CLEARNLP),
        ({"SB", "OA", "ROOT"}, None),
        (set(), None),
    ],
)
def test_the_labels_tell_the_scheme(labels: set[str], scheme: Scheme | None) -> None:
    assert scheme_of(labels) is scheme
