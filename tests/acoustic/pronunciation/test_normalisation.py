"""The spoken tokens of each word: tables of text and speech, and input that must not raise."""

import sys
from pathlib import Path

import pytest
import typeguard
from hypothesis import given
from hypothesis import strategies as st

from tests.support.examples import examples
from understudy.acoustic.pronunciation.normalisation import Normaliser, fold
from understudy.errors import AuthoringError, InputError
from understudy.text.transcript import read_transcript

ABBREVIATIONS = Path(__file__).resolve().parents[3] / "lexicon" / "en" / "abbreviations.yaml"
KNOWN = frozenset({"nasa", "uh-huh", "well-known", "it's", "us", "u.s.", "p.m.", "'em", "no", "hello"})


@pytest.fixture(scope="module")
def normaliser() -> Normaliser:
    return Normaliser.load(ABBREVIATIONS, KNOWN)


def _said(normaliser: Normaliser, text: str) -> str:
    """The tokens of the words, `|` between words."""
    words = read_transcript(text, max_characters=1000)
    return " | ".join(" ".join(tokens) for tokens in normaliser.spoken(words))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("It’s Well-known, uh-huh!", "it's | well-known | uh-huh"),
        ("Café — naïve … ", "cafe |  | naive | "),
        ("get 'em!", "get | 'em"),
        ("He/she rock&roll", "he she | rock and roll"),
        ("me@home & you", "me at home | and | you"),
    ],
)
def test_words_and_symbols(normaliser: Normaliser, text: str, said: str) -> None:
    assert _said(normaliser, text) == said


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("25", "twenty five"),
        ("1,234,567", "one million two hundred thirty four thousand five hundred sixty seven"),
        ("007", "oh oh seven"),
        ("-5", "minus five"),
        ("3.14", "three point one four"),
        (".5", "point five"),
        ("3rd 21st 101st.", "third | twenty first | one hundred first"),
        ("1984 1905 1900 2000 2005 2012", "nineteen eighty four | nineteen oh five | nineteen hundred | two thousand"
         " | two thousand five | twenty twelve"),
        ("1980s '90s 1,984", "nineteen eighties | nineties | one thousand nine hundred eighty four"),
        ("50% 10°", "fifty percent | ten degrees"),
        ("$5.50, £1 $0.99 $900", "five dollars and fifty cents | one pound | ninety nine cents | nine hundred dollars"),
        ("$5 million €3.5bn 10k", "five | million dollars | three point five billion euros | ten thousand"),
        ("3:30 5:00 12:05am 5:00 p.m.", "three thirty | five o'clock | twelve oh five a. m. | five | p.m."),
        ("1/2 3/4 2/3 1½", "one half | three quarters | two thirds | one and one half"),
        ("10-20 1990–1995", "ten to twenty | nineteen ninety to nineteen ninety five"),
        ("555-1234", "five five five one two three four"),
        ("#1 No. 5 No.", "number one | number | five | no"),
        ("5km 5 km 1 ft. 6 ft", "five kilometers | five | kilometers | one | foot | six | feet"),
        ("R2-D2 plays MP3 3D", "r two d two | plays | m. p. three | three d"),
    ],
)  # fmt: skip
def test_numbers(normaliser: Normaliser, text: str, said: str) -> None:
    assert _said(normaliser, text) == said


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("Dr. Brown", "doctor | brown"),
        ("'Dr.' Who", "doctor | who"),
        ("on Elm St. near St. Mary's", "on | elm | street | near | saint | mary's"),
        ("Mr Jones vs. Prof. X etc.", "mister | jones | versus | professor | x | et cetera"),
        ("NASA and the FBI, BBC's TVs", "nasa | and | the | f. b. i. | b. b. c.'s | t. v.'s"),
        ("J. R. R. and J.R.R.", "j. | r. | r. | and | j. r. r."),
        ("the US gave us", "the | u. s. | gave | us"),
        ("GIVE IT TO US BRB", "give | it | to | us | brb"),
        ("World War II.", "world | war | two"),
    ],
)
def test_abbreviations_and_acronyms(normaliser: Normaliser, text: str, said: str) -> None:
    assert _said(normaliser, text) == said


@examples(200)
@given(st.text(st.one_of(st.sampled_from("0123456789.,:/$%#&-'’½²٣asdSTAPM "), st.characters()), max_size=60))
def test_any_transcript_has_tokens_for_each_word(normaliser: Normaliser, text: str) -> None:
    try:
        words = read_transcript(text, max_characters=1000)
    except InputError:
        return
    spoken = normaliser.spoken(words)
    assert len(spoken) == len(words)
    assert all(token and token == token.lower() and " " not in token for tokens in spoken for token in tokens)


def test_folding_undoes_what_ascii_has_a_counterpart_for() -> None:
    assert fold("“Ｆｕｌｌ” naïve ﬁn\u200bal Straße—Øre ½") == "“Full” naive final Strasse-Ore 1/2"


def test_a_mistake_in_the_abbreviations_has_its_place(tmp_path: Path) -> None:
    path = tmp_path / "abbreviations.yaml"
    path.write_text(ABBREVIATIONS.read_text(encoding="utf-8").replace("anywhere:", "anywhre:", 1), encoding="utf-8")
    with pytest.raises(AuthoringError, match=r"abbreviations.yaml:\d+:\d+: .*unknown key"):
        Normaliser.load(path, KNOWN)


def test_reading_numbers_has_no_library_compiled_anew(normaliser: Normaliser) -> None:
    """typeguard would, for checks at run time: two seconds before the first number is read."""
    assert _said(normaliser, "21st of 2") == "twenty first | of | two"
    assert "typeguard" not in sys.modules["inflect"].engine.plural.__code__.co_names
    assert typeguard.typechecked.__module__.startswith("typeguard")
