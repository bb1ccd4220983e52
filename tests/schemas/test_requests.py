"""Input other than audio and text: read if valid, mistakes reported by part."""

import json

import pytest

from understudy.errors import LONGEST_SHOWN, InputError, UndecodableError, UnsupportedFormatError
from understudy.model import GivenFunction, Level, Timings
from understudy.option_table import LARGEST_SEED
from understudy.options import Options
from understudy.schemas.options import check_options, read_options
from understudy.schemas.requests import (
    MOST_FUNCTIONS,
    MOST_WRONG,
    line_id,
    read_functions,
    read_object,
    read_request,
    read_timings,
)


def test_options_have_the_names_and_defaults_of_the_command_line() -> None:
    assert read_options(b"{}") == Options()
    assert read_options(b'{"character": "shy", "agitation": "low", "seed": 5}') == Options("shy", Level.LOW, 5)
    assert read_options(b'{"agitation": null}') == Options()
    assert read_options(b'{"lead_in_s": 2}') == Options(lead_in_s=2.0)
    assert read_options(f'{{"seed": {LARGEST_SEED}}}'.encode()).seed == LARGEST_SEED


@pytest.mark.parametrize(
    ("content", "field"),
    [
        (b'{"agitation": "mid"}', "agitation"),
        (b'{"agitation": 3}', "agitation"),
        (b'{"seed": "5"}', "seed"),
        (b'{"seed": true}', "seed"),
        (b'{"seed": 1.5}', "seed"),
        (f'{{"seed": {LARGEST_SEED + 1}}}'.encode(), "seed"),
        (b'{"character": null}', "character"),
        (b'{"charcter": "shy"}', "charcter"),
        (b'{"lead_in_s": 5}', "lead_in_s"),
        (b'{"lead_in_s": "1"}', "lead_in_s"),
        (b"[]", "options"),
        (b'"low"', "options"),
    ],
)
def test_a_wrong_option_is_named(content: bytes, field: str) -> None:
    with pytest.raises(InputError) as caught:
        read_options(content)
    assert caught.value.field == field
    assert caught.value.code == ("value_wrong" if field != "options" else "not_an_object")
    assert "\n" not in caught.value.message


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b'{"charcter": "shy"}', "did you mean 'character'?"),
        (b'{"lead_in": 1}', "did you mean 'lead_in_s'?"),
        (b'{"xyzzy": 1}', "there are character, agitation, "),
        (b'{"agitation": "hgh"}', "'low', 'medium' or 'high'; did you mean 'high'?"),
        (b'{"mode": "semantics"}', "did you mean 'semantic'?"),
        (b'{"reference": {"features": "full"}}', "reference.recordings: field required"),
    ],
)
def test_a_misspelt_option_is_told_the_nearest_name(content: bytes, told: str) -> None:
    with pytest.raises(InputError) as caught:
        read_options(content)
    assert told in caught.value.message


@pytest.mark.parametrize("given", [b"[0.1, 0.2]", b'{"tone": "sad"}', b"[[0, 0.1, 0.2]]", b"3"])
def test_what_has_no_form_of_affect_is_told_the_forms(given: bytes) -> None:
    with pytest.raises(InputError, match=r"^affect: give a tone \(neutral, .*, or a track of these") as caught:
        read_options(b'{"affect": ' + given + b"}")
    assert (caught.value.code, caught.value.field) == ("value_wrong", "affect")
    assert "valid tuple" not in caught.value.message


def test_all_that_is_wrong_is_told_up_to_a_few() -> None:
    with pytest.raises(InputError) as caught:
        read_options(b'{"charcter": "shy", "agitation": "hi", "seed": "x"}')
    assert all(part in caught.value.message for part in ("charcter: ", "agitation: ", "seed: "))
    with pytest.raises(InputError) as caught:
        read_options(json.dumps({f"x{n}": n for n in range(1000)}).encode())
    assert f"and {1000 - MOST_WRONG} more" in caught.value.message
    assert len(caught.value.message) < 2000


def test_a_listener_moves_as_the_character_beside_its_name() -> None:
    options = read_options(json.dumps({"listener": ["Zoë=reserved", "bob"]}).encode())
    assert options.listeners == ("Zoë", "bob")
    assert options.played_by == (("Zoë", "reserved"),)


@pytest.mark.parametrize("names", [["bob=reserved", "bob"], ["bob="], ["=reserved"], ["bob=a b"]])
def test_a_listener_is_named_once_and_rightly(names: list[str]) -> None:
    with pytest.raises(InputError) as caught:
        check_options({"listener": names})
    assert caught.value.field == "listener"


@pytest.mark.parametrize("name", ["voice" * 100_000, "\u0001" * 100_000])
def test_what_was_sent_is_cut_in_the_message(name: str) -> None:
    for options in ({name: 1}, {"listener": [name]}, {"agitation": name}):
        with pytest.raises(InputError) as caught:
            check_options(options)
        assert len(caught.value.message) < 2000
        assert len(caught.value.field or "") <= LONGEST_SHOWN


@pytest.mark.parametrize("content", [b"", b"{", b"\xff", b"{'seed': 1}", b"[" * 100_000, b'{"a": NaN'])
def test_what_is_no_json_is_undecodable(content: bytes) -> None:
    with pytest.raises(UndecodableError) as caught:
        read_object(content, "body")
    assert caught.value.code == "not_json"


def test_a_number_that_python_does_not_read_is_told_without_its_advice() -> None:
    with pytest.raises(UndecodableError) as caught:
        read_object(b'{"seed": %s}' % (b"9" * 5000), "body")
    assert caught.value.message == "body is not JSON: a number has too many digits"


def test_a_lone_surrogate_is_told_as_such() -> None:
    with pytest.raises(InputError) as caught:
        read_object(b'{"text": "\\ud800"}', "body")
    assert caught.value.code == "text_surrogate"


def test_a_question_is_a_text_with_an_id() -> None:
    assert read_request({"id": 4, "text": "No."}).id == 4
    assert read_request({"text": "No.", "functions": []}).text == "No."
    for fields, field in (({}, "text"), ({"text": 5}, "text"), ({"id": [], "text": "a"}, "id")):
        with pytest.raises(InputError) as caught:
            read_request(fields)
        assert caught.value.field == field


@pytest.mark.parametrize(("found", "known"), [("a", "a"), (7, 7), (None, None), ([], None), ({}, None)])
def test_the_id_of_a_wrong_question_comes_back_where_it_can(found: object, known: object) -> None:
    assert line_id({"id": found}) == known


def test_the_ending_tells_the_format_of_words() -> None:
    assert read_timings("a/b.TextGrid", b"x") == Timings(b"x", "textgrid")
    assert read_timings("b.json", b"x").format == "json"
    assert read_timings("b.CTM", b"x").format == "ctm"


@pytest.mark.parametrize("name", ["", "-", "words", "words.txt", ".json"])
def test_other_endings_are_refused(name: str) -> None:
    with pytest.raises(UnsupportedFormatError) as caught:
        read_timings(name, b"")
    assert caught.value.field == "words"


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
