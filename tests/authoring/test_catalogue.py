"""The catalogue lists authored items with their places."""

from pathlib import Path

import pytest

from understudy.authoring.catalogue import Catalogue, Item, ItemKind
from understudy.cli.outputs.listings import counts, explanation
from understudy.errors import InputError

ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def catalogue() -> Catalogue:
    return Catalogue.load()


def test_every_item_is_where_it_says(catalogue: Catalogue) -> None:
    lines: dict[str, list[str]] = {}
    for item in catalogue.items:
        text = lines.setdefault(item.file, (ROOT / item.file).read_text(encoding="utf-8").splitlines())
        name = item.name.split()[0].split("_family_")[-1]
        assert name.lower() in text[item.line - 1].lower(), item


def test_every_kind_is_listed_and_rules_have_distinct_names(catalogue: Catalogue) -> None:
    assert {item.kind for item in catalogue.items} == set(ItemKind)
    rules = [item.name for item in catalogue.items if item.kind in (ItemKind.FUNCTION, ItemKind.BEHAVIOR)]
    assert len(rules) == len(set(rules))


def test_words_are_found_whatever_their_capitals_and_unknown_names_are_told(catalogue: Catalogue) -> None:
    assert {item.kind for item in catalogue.named("NEVER")} == {ItemKind.WORD}
    with pytest.raises(InputError) as caught:
        catalogue.named("nevr")
    assert "never" in caught.value.message


def names(items: tuple[Item, ...], kind: ItemKind) -> set[str]:
    return {item.name for item in items if item.kind is kind}


def test_what_leads_to_what_is_told_from_the_word_to_the_movement(catalogue: Catalogue) -> None:
    [word] = [item for item in catalogue.named("never") if item.class_name == "negation"]
    [rule], [mapping], [movement] = map(catalogue.named, ("negation_word", "show_negation", "shake"))
    assert names(catalogue.that_follow(word), ItemKind.FUNCTION) == {"negation_word"}
    assert "show_negation" in names(catalogue.that_follow(rule), ItemKind.BEHAVIOR)
    assert "shake" in names(catalogue.that_follow(mapping), ItemKind.BML)
    assert "show_negation" in names(catalogue.that_lead_to(movement), ItemKind.BEHAVIOR)
    assert names(catalogue.that_lead_to(mapping), ItemKind.FUNCTION) == {"negation_word"}
    assert "never" in names(catalogue.that_lead_to(rule), ItemKind.WORD)


def test_an_explanation_is_complete(catalogue: Catalogue) -> None:
    [rule] = catalogue.named("negation_word")
    told = "\n".join(explanation(catalogue, rule))
    assert f"{rule.file}:{rule.line}" in told
    assert all(f"    {line}" in told for line in (*rule.comment.splitlines(), *rule.source.splitlines()))
    assert "  comes from words: " in told
    assert "  leads to mapping rules: " in told


def test_counts_add_up(catalogue: Catalogue) -> None:
    by_class, by_file = "\n".join(counts(catalogue.items)).split("\n\n")
    *_, total = by_class.splitlines()
    assert sum(map(int, total.split()[1:])) == len(catalogue.items)
    assert sum(int(line.split()[0]) for line in by_file.splitlines()) == len(catalogue.items)
    assert f"{sum(item.class_name == 'thanks' and item.kind is ItemKind.WORD for item in catalogue.items):16d}" in next(
        line for line in by_class.splitlines() if line.startswith("thanks ")
    )


def test_what_a_behaviour_gives_as_its_reason_is_explained(catalogue: Catalogue) -> None:
    [family] = catalogue.named("gesture_family_contrast_sides")
    [place] = catalogue.named("gesture_place_left")
    assert place in catalogue.that_follow(family)
