"""Noun phrases and verb groups of trees written by hand."""

from tests.support.words.syntax_trees import read_tree
from understudy.syntax.phrases import Tree, find_phrases

FIGURE_8 = """
    I        PRON  PRP  nsubj     1
    guess    VERB  VBP  root      1
    not      PART  RB   advmod    1
    +,       PUNCT ,    punct     1
    I        PRON  PRP  nsubj     5
    think    VERB  VBP  parataxis 1
    I        PRON  PRP  nsubj     9
    must     AUX   MD   aux       9
    +'ve     AUX   VB   aux       9
    misread  VERB  VBN  ccomp     5
    all      DET   DT   obj       9
    of       ADP   IN   case      13
    those    DET   DT   det       13
    signals  NOUN  NNS  nmod      10
    +.       PUNCT .    punct     1
"""


def _phrases(table: str, kind: str) -> list[tuple[int, int, int]]:
    return [(p.first, p.last, p.head) for p in find_phrases(Tree.of(read_tree(table))) if p.kind == kind]


def test_the_paper_s_figure_8() -> None:
    assert _phrases(FIGURE_8, "noun") == [(0, 0, 0), (3, 3, 3), (5, 5, 5), (8, 8, 8), (10, 11, 11)]
    assert _phrases(FIGURE_8, "verb") == [(1, 1, 1), (4, 4, 4), (6, 7, 7)]


def test_phrases_come_in_the_order_of_their_first_words() -> None:
    firsts = [phrase.first for phrase in find_phrases(Tree.of(read_tree(FIGURE_8)))]
    assert firsts == sorted(firsts)


def test_a_noun_takes_the_modifiers_before_it_and_its_possessor_whole() -> None:
    table = """
        My     PRON PRP$ nmod:poss 1
        friend NOUN NN   nmod:poss 7
        +'s    PART POS  case      1
        big    ADJ  JJ   amod      7
        +,     PUNCT ,   punct     7
        red    ADJ  JJ   amod      7
        fire   NOUN NN   compound  7
        truck  NOUN NN   root      7
    """
    assert _phrases(table, "noun") == [(0, 5, 5)]


def test_preposition_copula_and_subject_end_a_noun_phrase() -> None:
    table = """
        She    PRON PRP  nsubj 4
        is     AUX  VBZ  cop   4
        just   ADV  RB   advmod 4
        a      DET  DT   det   4
        friend NOUN NN   root  4
        of     ADP  IN   case  7
        the    DET  DT   det   7
        house  NOUN NN   nmod  4
    """
    assert _phrases(table, "noun") == [(0, 0, 0), (3, 4, 4), (6, 7, 7)]
    assert _phrases(table, "verb") == [(1, 1, 1)]


def test_a_name_goes_on_after_its_head() -> None:
    table = """
        John  PROPN NNP nsubj 2
        Smith PROPN NNP flat  0
        left  VERB  VBD root  2
    """
    assert _phrases(table, "noun") == [(0, 1, 0)]


def test_each_of_two_joined_nouns_has_its_phrase() -> None:
    table = """
        the  DET   DT  det  1
        cat  NOUN  NN  root 1
        and  CCONJ CC  cc   4
        a    DET   DT  det  4
        dog  NOUN  NN  conj 1
    """
    assert _phrases(table, "noun") == [(0, 1, 1), (3, 4, 4)]


def test_a_verb_takes_auxiliaries_negation_inner_adverbs_and_particle() -> None:
    table = """
        He       PRON PRP nsubj        5
        would    AUX  MD  aux          5
        +n't     PART RB  advmod       5
        really   ADV  RB  advmod       5
        have     AUX  VB  aux          5
        given    VERB VBN root         5
        up       ADP  RP  compound:prt 5
    """
    assert _phrases(table, "verb") == [(1, 5, 4)]


def test_an_adverb_before_the_auxiliaries_stays_outside() -> None:
    table = """
        really ADV  RB  advmod 2
        is     AUX  VBZ aux    2
        going  VERB VBG root   2
    """
    assert _phrases(table, "verb") == [(1, 2, 2)]


def test_an_infinitive_keeps_its_to_and_is_a_group_of_its_own() -> None:
    table = """
        I     PRON PRP nsubj  1
        want  VERB VBP root   1
        not   PART RB  advmod 4
        to    PART TO  mark   4
        go    VERB VB  xcomp  1
    """
    assert _phrases(table, "verb") == [(1, 1, 1), (2, 4, 4)]


def test_an_inverted_auxiliary_joins_its_verb_over_the_subject() -> None:
    table = """
        Do    AUX  VBP aux   2
        you   PRON PRP nsubj 2
        think VERB VB  root  2
        +?    PUNCT .  punct 2
    """
    assert _phrases(table, "verb") == [(0, 2, 2)]
    assert _phrases(table, "noun") == [(1, 1, 1)]


def test_a_copula_s_group_is_its_chain_of_auxiliaries() -> None:
    table = """
        It    PRON PRP nsubj  5
        has   AUX  VBZ aux    5
        never ADV  RB  advmod 5
        been  AUX  VBN cop    5
        so    ADV  RB  advmod 5
        easy  ADJ  JJ  root   5
    """
    assert _phrases(table, "verb") == [(1, 3, 3)]


def test_not_belongs_to_the_auxiliary_it_follows() -> None:
    table = """
        It   PRON PRP nsubj  3
        is   AUX  VBZ cop    3
        not  PART RB  advmod 3
        fair ADJ  JJ  root   3
    """
    assert _phrases(table, "verb") == [(1, 2, 1)]


def test_a_not_across_a_comma_stays_outside() -> None:
    table = """
        not    PART  RB  advmod 3
        +,     PUNCT ,   punct  3
        I      PRON  PRP nsubj  3
        think  VERB  VBP root   3
    """
    assert _phrases(table, "verb") == [(2, 2, 2)]


def test_a_stranded_auxiliary_is_a_group() -> None:
    table = """
        I    PRON PRP nsubj  1
        do   AUX  VBP root   1
        +n't PART RB  advmod 1
    """
    assert _phrases(table, "verb") == [(1, 1, 1)]


def test_a_participle_before_a_noun_is_no_verb_group() -> None:
    table = """
        running VERB VBG amod 1
        water   NOUN NN  root 1
    """
    assert _phrases(table, "verb") == []
    assert _phrases(table, "noun") == [(0, 1, 1)]


def test_a_determiner_or_number_can_stand_for_a_noun() -> None:
    table = """
        Two   NUM  CD  nsubj 1
        saw   VERB VBD root  1
        all   DET  DT  obj   1
    """
    assert _phrases(table, "noun") == [(0, 0, 0), (2, 2, 2)]
