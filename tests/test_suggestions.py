"""Suggestions for unknown names."""

from understudy.suggestions import MOST_COMPARED, did_you_mean, nearest_names


def test_the_nearest_name_is_suggested_and_nothing_where_none_is_near() -> None:
    assert did_you_mean("negaton", ("affirmation", "negation")) == "; did you mean 'negation'?"
    assert did_you_mean("zzz", ("affirmation", "negation")) == ""
    assert did_you_mean("zzz", ("negation",), otherwise="; see rules list") == "; see rules list"


def test_several_names_are_suggested_where_asked_for() -> None:
    assert did_you_mean("nodd", ("nod", "nods", "shake"), most=3) == "; did you mean 'nod' or 'nods'?"


def test_a_very_long_name_or_list_costs_no_more() -> None:
    assert nearest_names("x" * 1_000_000, ("x" * 200,)) == ("x" * 200,)
    assert nearest_names("near", (f"name{number}" for number in range(MOST_COMPARED * 2)), most=1) == ()
