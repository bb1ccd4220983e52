"""Functions given with a line: read if valid, mistakes reported by number and key."""

import pytest

from understudy.errors import InputError, UndecodableError
from understudy.model import GivenFunction
from understudy.schemas.given_functions import MOST_FUNCTIONS, read_functions


def test_functions_are_read_in_the_names_of_the_answers() -> None:
    content = b'[{"class": "deixis", "subtype": "self", "first": 0, "last": 1, "priority": 5}]'
    assert read_functions(content) == (GivenFunction("deixis", "self", 0, 1, 5.0),)
    assert read_functions(b"[]") == ()


@pytest.mark.parametrize("subtype", ["", ', "subtype": ""', ', "subtype": "plain"'])
def test_a_class_without_subtypes_needs_none(subtype: str) -> None:
    content = f'[{{"class": "contrast", "first": 2, "last": 2{subtype}}}]'
    assert read_functions(content.encode()) == (GivenFunction("contrast", "plain", 2, 2),)


@pytest.mark.parametrize(
    ("content", "said"),
    [
        ('{"class": "contrast", "first": 0, "last": 0}', "must be a JSON list"),
        ('[{"class": "contrast", "first": 0, "last": 0}, 5]', "functions[1]: input should be"),
        ('[{"class": "contrast", "first": 0}]', "functions[0].last: field required"),
        ('[{"class": "contrast", "first": 0, "last": 0, "span": 2}]', "functions[0].span: extra inputs"),
        ('[{"class": "contrast", "first": "0", "last": 0}]', "functions[0].first: input should be a valid integer"),
        ('[{"class": "contrast", "first": true, "last": 1}]', "functions[0].first"),
        ('[{"class": "contrast", "first": -1, "last": 0}]', "functions[0].first"),
        ('[{"class": 3, "first": 0, "last": 0}]', "functions[0].class"),
        ('[{"class": "contrast", "first": 0, "last": 0, "priority": NaN}]', "functions[0].priority"),
        ('[{"class": "contrast", "first": 0, "last": 0, "priority": 1e9}]', "functions[0].priority"),
        ('[{"class": "contrast", "first": 0, "last": 20000}]', "over 20001 words together; 20000 at most"),
        ("[" + ",".join(["{}"] * (MOST_FUNCTIONS + 1)) + "]", "more than 1000"),
    ],
)
def test_what_is_wrong_is_told_by_number_and_key(content: str, said: str) -> None:
    with pytest.raises(InputError) as caught:
        read_functions(content.encode())
    assert (caught.value.code, caught.value.field) == ("functions_wrong", "functions")
    assert said in caught.value.message
    assert "\n" not in caught.value.message


@pytest.mark.parametrize("content", [b"", b"[", b"\xff", b"[" * 100_000])
def test_what_is_no_json_is_told(content: bytes) -> None:
    with pytest.raises(UndecodableError) as caught:
        read_functions(content)
    assert (caught.value.code, caught.value.field) == ("not_json", "functions")
