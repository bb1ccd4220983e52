from pathlib import Path

import pytest

from understudy.behavior.reading.planner import TermNames, load_weights
from understudy.errors import AuthoringError

FAMILIES = ("present", "negation")
TERMS = ("voice(stressed)", "function(negation)")


def written(folder: Path, content: str) -> Path:
    path = folder / "weights.yaml"
    path.write_text(content)
    return path


def test_any_is_every_family_and_adds_to_their_own(tmp_path: Path) -> None:
    path = written(tmp_path, "terms:\n  voice(stressed): {any: 0.5, negation: 1}\n")
    assert load_weights(path, FAMILIES, TERMS) == {"voice(stressed)": {"present": 0.5, "negation": 1.5}}


def test_every_mistake_is_told_with_its_place(tmp_path: Path) -> None:
    path = written(tmp_path, "terms:\n  voice(stresed): {any: 1}\n  function(negation): {negatoin: 1}\n")
    with pytest.raises(AuthoringError) as raised:
        load_weights(path, FAMILIES, TERMS)
    assert [(mistake.line, mistake.message) for mistake in raised.value.mistakes] == [
        (2, "'voice(stresed)' is not a term; did you mean 'voice(stressed)'?"),
        (3, "'negatoin' is no family of gestures and no kind of head movement or face; did you mean 'negation'?"),
    ]


@pytest.mark.parametrize("weight", ["11", "much", ".nan"])
def test_weights_are_numbers_that_do_not_settle_all(tmp_path: Path, weight: str) -> None:
    path = written(tmp_path, f"terms:\n  voice(stressed): {{any: {weight}}}\n")
    with pytest.raises(AuthoringError):
        load_weights(path, FAMILIES, TERMS)


def test_heads_and_faces_are_weighed_beside_families_and_any_does_not_mean_them(tmp_path: Path) -> None:
    path = written(tmp_path, "terms:\n  function(negation): {any: 0.5, shake: -2}\n")
    found = load_weights(path, FAMILIES, TERMS, ("shake", "nod"))
    assert found == {"function(negation)": {"present": 0.5, "negation": 0.5, "shake": -2.0}}


@pytest.mark.parametrize(
    ("term", "known"),
    [
        ("function(dismissal)", True),
        ("function(dismissal.plain)", True),
        ("function(dismissal) here", True),
        ("given(dismissal)", True),
        ("waved off(3)", True),
        ("tone(angry)", True),
        ("agitation(high)", True),
        ("clause(root) end", True),
        ("function(dismissal.odd)", False),
        ("waved(3)", False),
    ],
)
def test_an_authors_own_classes_and_facts_are_terms(term: str, *, known: bool) -> None:
    names = TermNames.of({"clause(root) end"}, ["waved off({0})"], {"dismissal": ("plain",)})
    assert (term in names) == known


def test_terms_of_facts_are_among_the_names_that_are_proposed() -> None:
    names = TermNames.of((), ["voice(focus)", "mood({0})"], {})
    assert "voice(focus)" in set(names)
    assert "mood({0})" not in set(names)
    assert "mood(wh)" in names
