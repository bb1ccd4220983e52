"""Spatial metaphors: found, and not in similar sentences; and places that referents keep."""

import pytest

from tests.support.shipped_rules import found

TIME = [
    ("Yesterday we met.", [("past", "Yesterday")]),
    ("Last week we met.", [("past", "Last week")]),
    ("Two years ago I was there.", [("past", "Two years ago")]),
    ("Next week we meet again.", [("future", "next week")]),
    ("In two weeks I leave.", [("future", "In two weeks")]),
    ("A year from now I leave.", [("future", "A year from now")]),
    ("Christmas is coming.", [("approaching", "coming.")]),
    ("The years went by.", [("passing", "years went by.")]),
    ("We run out of time.", [("passing", "run out of time.")]),
    ("The last man left.", []),
    ("Every once in a while he left.", []),
    ("My brother is coming.", []),
    ("He sleeps in a house.", []),
]
IDEA = [
    ("That is a big idea.", [("size", "big idea.")]),
    ("The problem is huge.", [("size", "huge.")]),
    ("It is a heavy responsibility.", [("weight", "heavy responsibility.")]),
    ("Hold that thought.", [("hold", "Hold that thought.")]),
    ("I can't grasp the concept.", [("hold", "grasp the concept.")]),
    ("Go further.", [("distance", "further.")]),
    ("That is a big house.", []),
    ("He dropped the glass.", []),
]
HEIGHT = [
    ("Prices went up and sales fell.", [("more", "went up"), ("less", "fell.")]),
    ("They raised the rent.", [("more", "raised")]),
    ("There was a rise in crime.", [("more", "rise")]),
    ("High expectations are bad.", [("more", "High expectations")]),
    ("He went up the stairs.", []),
    ("The glass fell.", []),
    ("Calm down.", []),
]
CONTAINER = [
    ("She is in trouble and out of luck.", [("in", "in trouble"), ("out", "out of luck.")]),
    ("It was full of holes.", [("full", "full of")]),
    ("She is in Paris.", []),
]
PATH = [
    ("You need to move on.", [("forward", "move on.")]),
    ("We were at a crossroads.", [("aside", "at a crossroads.")]),
    ("They get there.", [("arrival", "get there.")]),
    ("We live there.", []),
]
LOCUS = [
    ("I like cats, but dogs are loyal.", [("left", "cats,"), ("right", "dogs")]),
    ("The city is loud, but the country is quiet.", [("left", "The city"), ("right", "the country")]),
    ("Dogs are better than cats.", [("left", "Dogs"), ("right", "cats.")]),
    ("I'd rather have tea than coffee.", [("left", "tea"), ("right", "coffee.")]),
    ("Do you want tea or coffee?", [("left", "tea"), ("right", "coffee?")]),
    ("The choice is between work and family.", [("left", "work"), ("right", "family.")]),
    (
        "On the one hand it pays, on the other hand it bores me.",
        [("left", "On the one hand"), ("right", "on the other hand")],
    ),
    ("I called, but she left.", []),
    ("They have tea and coffee.", []),
    ("This offer as opposed to that offer is fair.", [("left", "This offer"), ("right", "that offer")]),
    (
        "The green door leads to the cellar, the white door to the attic.",
        [("left", "The green door"), ("right", "the white door")],
    ),
    ("She is tall but he is short.", [("left", "She"), ("right", "he")]),
    ("The girl fell, but she laughed.", []),
    ("My brother stayed but she left.", [("left", "My brother"), ("right", "she")]),
]
TABLE = {"time": TIME, "idea": IDEA, "height": HEIGHT, "container": CONTAINER, "path": PATH, "locus": LOCUS}


@pytest.mark.parametrize(
    ("class_name", "text", "expected"),
    [(class_name, text, expected) for class_name, rows in TABLE.items() for text, expected in rows],
)
def test_metaphors_are_found_where_they_are_and_not_where_they_are_not(
    class_name: str, text: str, expected: list[tuple[str, str]]
) -> None:
    assert [(subtype, words.lower()) for subtype, words in found(text, class_name)] == [
        (subtype, words.lower()) for subtype, words in expected
    ]


def test_later_mentions_go_where_the_contrast_has_put_their_referents() -> None:
    text = "Dogs are better than cats. Cats sleep, and a dog comes when you call."
    assert found(text, "locus") == [("left", "Dogs"), ("right", "cats."), ("right", "Cats"), ("left", "a dog")]


def test_a_mention_before_the_contrast_has_no_place() -> None:
    text = "A cat came. Dogs are better than cats."
    assert found(text, "locus") == [("left", "Dogs"), ("right", "cats.")]


def test_one_noun_on_both_sides_goes_by_the_mention_and_then_by_its_attribute() -> None:
    text = "The big dog fought the small dog, and the small dog won. A dog is a dog."
    assert found(text, "locus") == [
        ("left", "The big dog"),
        ("right", "the small dog,"),
        ("right", "the small dog"),
    ]


def test_a_pronoun_keeps_the_place_that_its_contrast_gave_it() -> None:
    text = "He is tall but she is short, so he sits behind."
    assert found(text, "locus") == [("left", "He"), ("right", "she"), ("left", "he")]
