"""Lists of three or more, and things counted off."""

import pytest

from tests.support.shipped_rules import facts, found

LISTS = [
    ("I packed socks, shirts and a hat.", {("1", "socks,"), ("2", "shirts"), ("3", "a hat.")}),
    ("The room was cold, dark and empty.", {("1", "cold,"), ("2", "dark"), ("3", "empty.")}),
    ("He ran, jumped and fell.", {("1", "ran,"), ("2", "jumped"), ("3", "fell.")}),
    ("He met Anna, Peter, Paul and Mary.", {("1", "Anna,"), ("2", "Peter,"), ("3", "Paul"), ("4", "Mary.")}),
    ("I packed socks and shirts.", set()),
    ("My old, tired, faithful dog died.", set()),
]
COUNTED = [
    ("There are two reasons for that.", {("2", "two")}),
    ("One, two, three, go!", {("1", "One,"), ("2", "two,"), ("3", "three,")}),
    ("Rule number one: never be late.", {("1", "one:")}),
    ("He owns four boats.", set()),
    ("There are seven reasons for that.", set()),
    ("We waited three hours.", set()),
    ("One day you will see.", set()),
]


@pytest.mark.parametrize(("text", "expected"), LISTS)
def test_items_are_numbered_in_their_order(text: str, expected: set[tuple[str, ...]]) -> None:
    assert facts(text, "list_item") == expected
    assert {words for subtype, words in found(text, "enumeration") if subtype == "item"} == {
        each[1] for each in expected
    }


@pytest.mark.parametrize(("text", "expected"), COUNTED)
def test_fingers_count_what_is_counted_off_and_no_more_than_five(text: str, expected: set[tuple[str, ...]]) -> None:
    assert facts(text, "counted") == expected
