"""Marks of emphasis and tags: the words stay, with their numbers, and what the marks say is known."""

import pytest

from understudy.errors import InputError
from understudy.model import PLAIN, Demand, GivenFunction
from understudy.text.reading import read_marked, without_marks
from understudy.text.tag_table import TagTable
from understudy.text.tags import GENERIC_GESTURE, MOST_DEPTH, SpokenText

TABLE = TagTable(
    {"performative": {"type": {"greet": "greeting", "order": "modal.obligation"}}}, {"rheme": "information.rheme"}
)


def _read(text: str) -> SpokenText:
    return read_marked(text, lambda: TABLE)


@pytest.mark.parametrize(
    ("text", "plain", "emphasized"),
    [
        ("It is *so* late.", "It is so late.", {2}),
        ('He "*never*, ever" did.', 'He "never, ever" did.', {1}),
        ("**Very much so**, _yes_.", "Very much so, yes.", {0, 1, 2, 3}),
        ("2*3 *left open", "2*3 *left open", set()),
        ("*one **two*", "one **two", {0, 1}),
        ("snake_case and * a", "snake_case and * a", set()),
    ],
)
def test_marks_are_taken_out_and_words_keep_their_numbers(text: str, plain: str, emphasized: set[int]) -> None:
    assert without_marks(text) == (plain, frozenset(emphasized))
    assert len(plain.split()) == len(text.split())


def test_tags_of_three_languages_say_how_words_are_spoken() -> None:
    spoken = _read(
        '<speak>Oh <emphasis level="strong">no</emphasis>, <break time="300ms"/><pause sec="0.2"/>'
        '<prosody rate="slow">very <prosody rate="50%">slowly</prosody></prosody>.'
        '<emphasis level="reduced"> now</emphasis></speak>'
    )
    assert spoken.text == "Oh no, very slowly. now"
    assert spoken.speaking.emphasized == {1}
    assert spoken.speaking.pauses_s == ((1, 0.5),)
    assert [spoken.speaking.slowness(word) for word in (0, 2, 3)] == pytest.approx([1, 1 / 0.8, 1 / 0.4])


def test_tags_become_functions_and_behaviours() -> None:
    spoken = _read(
        '<apml><performative type="GREET">Hello.</performative><s>You</s><s>there: '
        '<function class="negation" priority="7">not <gesture name="OFFER">that</gesture></function>'
        " <gesture>one</gesture></s><voice>!</voice></apml>"
    )
    assert spoken.text.split() == ["Hello.", "You", "there:", "not", "that", "one", "!"]
    assert spoken.functions == (
        GivenFunction("greeting", PLAIN, 0, 0),
        GivenFunction("negation", PLAIN, 3, 4, 7.0),
    )
    assert [(each.what, each.first, each.last) for each in spoken.demands] == [("OFFER", 4, 4), (GENERIC_GESTURE, 5, 5)]
    assert all(isinstance(each, Demand) and each.always for each in spoken.demands)
    assert spoken.speaking.unread_tags == ("voice",)


def test_a_tag_that_names_a_function_by_itself_is_the_least_important() -> None:
    spoken = _read("<apml><theme>As for us,</theme> <rheme>we <emphasis>go</emphasis></rheme></apml>")
    assert spoken.functions == (GivenFunction("information", "rheme", 3, 4, 1.0),)
    assert spoken.speaking.unread_tags == ("theme",)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("<speak>\n<b>so</speak>", "line 2, column 8: the text begins with a tag but is not XML: mismatched tag"),
        ("<speak>a & b</speak>", "write & as &amp;"),
        ('<!DOCTYPE a [<!ENTITY b "c">]><a>&b;</a>', "a DOCTYPE is not read"),
        ('<speak>\n <break time="soon"/></speak>', "line 2, column 2: <break time='soon'>; give seconds"),
        ('<speak><break strength="huge"/></speak>', "there are none, x-weak"),
        ('<speak><prosody rate="0">a</prosody></speak>', "give 30% to 300%"),
        ("<speak><function>a</function></speak>", "needs its class"),
        ("<speak><gesture/>a</speak>", "has no words"),
        ("<a>" * (MOST_DEPTH + 1), "tags inside one another"),
    ],
)
def test_a_tag_that_cannot_be_read_is_told_with_its_place(text: str, told: str) -> None:
    with pytest.raises(InputError, match=r"^text, line ") as wrong:
        _read(text)
    assert told in wrong.value.message
    assert wrong.value.code == "tags_wrong"
