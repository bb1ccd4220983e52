"""Known words are looked up, their forms derived, unknown ones predicted by a model that is evaluated elsewhere."""

import zlib
from pathlib import Path

import numpy as np
import pytest
from pocketsphinx import get_model_path

from understudy.acoustic.pronunciation.graphones import GraphoneModel
from understudy.acoustic.pronunciation.pronouncer import Dictionary, Pronouncer, with_s
from understudy.errors import ServiceError

MODEL = Path(__file__).resolve().parents[3] / "models" / "pronunciation" / "graphones.npz"
DICTIONARY = Path(get_model_path()) / "en-us" / "cmudict-en-us.dict"


@pytest.fixture(scope="module")
def pronouncer() -> Pronouncer:
    return Pronouncer.load(DICTIONARY, MODEL)


def _phones(pronouncer: Pronouncer, token: str) -> str:
    found = pronouncer.pronounce(token)
    assert found is not None
    return " ".join(found.variants[0])


def test_known_words_have_all_their_pronunciations(pronouncer: Pronouncer) -> None:
    found = pronouncer.pronounce("read")
    assert found is not None
    assert {" ".join(phones) for phones in found.variants} == {"R EH D", "R IY D"}
    assert not found.guessed


@pytest.mark.parametrize(
    ("token", "phones"),
    [
        ("w.", "D AH B AH L Y UW"),
        ("'guess'", "G EH S"),
        ("misreadin'", "M IH S R IY D IH N"),
        ("signals'", "S IH G N AH L Z"),
        ("gesture's", "JH EH S CH ER Z"),
        ("where'd've", "W EH R D AH V"),
    ],
)
def test_forms_of_known_words_are_derived_not_guessed(pronouncer: Pronouncer, token: str, phones: str) -> None:
    found = pronouncer.pronounce(token)
    assert found is not None
    assert not found.guessed
    assert phones in {" ".join(variant) for variant in found.variants}


def test_s_after_each_kind_of_sound() -> None:
    assert with_s(("HH", "AO", "R", "S"))[-2:] == ("IH", "Z")
    assert with_s(("K", "AE", "T"))[-1] == "S"
    assert with_s(("D", "AO", "G"))[-1] == "Z"


def test_unknown_words_are_guessed_and_say_so(pronouncer: Pronouncer) -> None:
    found = pronouncer.pronounce("blorptastic")
    assert found is not None
    assert found.guessed
    assert found.variants[0][:2] == ("B", "L")
    assert found.variants[0][-2:] == ("IH", "K")


def test_a_token_without_letters_has_no_pronunciation(pronouncer: Pronouncer) -> None:
    assert pronouncer.pronounce("'") is None
    assert pronouncer.pronounce("привет") is None


def test_words_held_out_of_training_come_out_mostly_right(pronouncer: Pronouncer) -> None:
    unseen = [
        word
        for word in pronouncer.dictionary
        if word.isascii() and word.isalpha() and zlib.crc32(word.encode()) % 20 == 0
    ][::50]
    right = sum(
        " ".join(pronouncer.graphones.pronounce(word)) in pronouncer.dictionary[word].splitlines() for word in unseen
    )
    assert len(unseen) > 100
    assert right > 0.6 * len(unseen)


def test_a_dictionary_has_the_words_of_its_text_alone() -> None:
    """Words of one letter, several pronunciations, and a word that stands apart from those that begin like it."""
    lines = (
        "a AH",
        "a(2) EY",
        "a's EY Z",
        "read R EH D",
        "read(2) R IY D",
        "reads R IY D Z",
        "zoo Z UW",
        "rebel R EH B",
    )
    dictionary = Dictionary("\n".join(lines))
    assert dict(dictionary) == {
        "a": "AH\nEY",
        "a's": "EY Z",
        "read": "R EH D\nR IY D",
        "reads": "R IY D Z",
        "zoo": "Z UW",
        "rebel": "R EH B",
    }
    for absent in ("", "r", "rea", "read(2)", "read R", "zoos", "é"):
        assert absent not in dictionary


def test_broken_models_are_named(tmp_path: Path) -> None:
    broken = tmp_path / "graphones.npz"
    with pytest.raises(ServiceError, match=r"graphones\.npz"):
        GraphoneModel.load(broken)
    broken.write_bytes(b"no archive")
    with pytest.raises(ServiceError, match=r"graphones\.npz"):
        GraphoneModel.load(broken)
    np.savez(broken, order=np.array(1))
    with pytest.raises(ServiceError, match=r"graphones\.npz"):
        GraphoneModel.load(broken)
    with pytest.raises(ServiceError, match="nowhere"):
        Dictionary.read(tmp_path / "nowhere")
