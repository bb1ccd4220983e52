"""Words and phrases: loading with every mistake, matching with conditions, and the examples of the lexicon we ship."""

from pathlib import Path

import pytest

from tests.support.shipped_rules import shipped_parser
from tests.support.words.utterances import utterance, words_of
from understudy.errors import AuthoringError
from understudy.model import Utterance
from understudy.rules.lexicon import GAP, SLOT, LexicalEntry, Lexicon

SHIPPED = Path(__file__).resolve().parents[2] / "lexicon" / "en"

NEGATION = """
class: negation
groups:
  - example: "{}, they go."
    words: [no, no way, not at all]
  - match: lemma
    example: "They do {} go."
    words: [not]
exceptions:
  - words: [no wonder]
"""

PLACES = """
class: spatial
groups:
  - subtype: up
    part_of_speech: [ADP, ADV]
    example: "They went {} it."
    words: [up]
  - subtype: right
    after: [turn]
    not_before: [away]
    example: "They turn {}."
    words: [right]
exceptions:
  - match: lemma
    words: [give ... up]
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    (tmp_path / "negation.yaml").write_text(NEGATION)
    (tmp_path / "spatial.yaml").write_text(PLACES)
    (tmp_path / "abbreviations.yaml").write_text("Dr.: doctor\n")
    return tmp_path


def found(folder: Path, spoken: Utterance) -> list[tuple[str, str, int, int]]:
    return [
        (match.class_name, match.subtype, match.first, match.last) for match in Lexicon.load(folder).matches(spoken)
    ]


def test_the_longest_of_one_class_counts(folder: Path) -> None:
    spoken = utterance("No way, not at all!", "0:No/no/DET 1:way/way/NOUN 2:not/not/PART 3:at/at/ADP 4:all/all/PRON")
    assert found(folder, spoken) == [("negation", "plain", 0, 1), ("negation", "plain", 2, 4)]


def test_an_exception_silences_the_words_in_it(folder: Path) -> None:
    assert found(folder, utterance("no wonder", "0:no/no/DET 1:wonder/wonder/NOUN")) == []


def test_a_part_of_a_word_is_found_by_its_lemma(folder: Path) -> None:
    assert found(folder, utterance("don't", "0:do/do/AUX 0:n't/not/PART")) == [("negation", "plain", 0, 0)]


def test_a_gap_takes_up_to_three_words_and_leaves_them_to_others(folder: Path) -> None:
    near = utterance("gave no up", "0:gave/give/VERB 1:no/no/DET 2:up/up/ADP")
    far = utterance("gave it a b c up", "0:gave/give/VERB 1:it/it/PRON 2:a/a/DET 3:b/b/NOUN 4:c/c/NOUN 5:up/up/ADP")
    assert found(folder, near) == [("negation", "plain", 1, 1)]
    assert found(folder, far) == [("spatial", "up", 5, 5)]


@pytest.mark.parametrize(
    ("text", "tokens", "expected"),
    [
        ("up there", "0:up/up/ADV 1:there/there/ADV", True),
        ("up there", "0:up/up/NOUN 1:there/there/ADV", False),
        ("turn right", "0:turn/turn/VERB 1:right/right/ADV", True),
        ("turn right away", "0:turn/turn/VERB 1:right/right/ADV 2:away/away/ADV", False),
        ("be right", "0:be/be/AUX 1:right/right/ADJ", False),
    ],
)
def test_conditions_ask_for_neighbours_and_parts_of_speech(
    folder: Path, text: str, tokens: str, expected: bool
) -> None:
    assert bool(found(folder, utterance(text, tokens))) is expected


def test_every_mistake_of_every_file_is_reported_at_its_place(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text(
        'class: a\ngroups:\n  - example: "no place for it"\n    words: [x]\n'
        '  - example: "{}"\n    match: sound\n    part_of_speech: [NOUNS]\n    words: []\n'
    )
    (tmp_path / "b.yaml").write_text('class: b\ngroups:\n  - example: "{}"\n    words:\n      - so\n      - so\n')
    with pytest.raises(AuthoringError) as error:
        Lexicon.load(tmp_path)
    places = [(mistake.path.name, mistake.line) for mistake in error.value.mistakes]
    assert places == [("a.yaml", 3), ("a.yaml", 8), ("a.yaml", 6), ("a.yaml", 7), ("b.yaml", 6)]
    messages = str(error.value)
    for part in ("needs {}", "'form' or 'lemma'", "unknown part of speech NOUNS", "'so' is already in line 5"):
        assert part in messages


def test_the_same_word_under_other_conditions_is_no_duplicate(tmp_path: Path) -> None:
    (tmp_path / "a.yaml").write_text(
        'class: a\ngroups:\n  - {example: "{}", words: [so], after: [is]}\n  - {example: "{}", words: [so]}\n'
    )
    assert len(Lexicon.load(tmp_path).entries) == 2


def example_of(entry: LexicalEntry) -> tuple[str, int, int]:
    """The example with the entry in its place, and the words it takes there."""
    assert entry.example is not None
    phrase = entry.phrase.replace(GAP, "this")
    first = len(entry.example.split(SLOT)[0].split())
    return entry.example.replace(SLOT, phrase), first, first + len(phrase.split()) - 1


def test_every_word_of_the_lexicon_is_found_in_its_example() -> None:
    lexicon = Lexicon.load(SHIPPED)
    examples = [(entry, *example_of(entry)) for entry in lexicon.entries if entry.example is not None]
    lines = [words_of(text) for _, text, _, _ in examples]
    missed = []
    for (entry, text, first, last), words, parse in zip(
        examples, lines, shipped_parser().parse_all(lines), strict=True
    ):
        matches = lexicon.matches(Utterance(words, parse))
        if not any(
            (match.class_name, match.subtype, match.first, match.last) == (entry.class_name, entry.subtype, first, last)
            for match in matches
        ):
            missed.append(f"{entry.path.name}:{entry.line}: {text}")
    assert missed == []


def test_the_shipped_lexicon_has_two_thousand_entries_and_an_example_for_each_that_means_something() -> None:
    entries = Lexicon.load(SHIPPED).entries
    assert len(entries) >= 2000
    assert all(entry.example for entry in entries if entry.subtype is not None)
