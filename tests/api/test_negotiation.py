"""Which representation an Accept header gets."""

import pytest

from understudy.api.negotiation import preferred

XML, JSON = "application/xml", "application/json"


@pytest.mark.parametrize(
    ("accept", "wanted"),
    [
        (None, XML),
        ("", XML),
        ("*/*", XML),
        ("application/*", XML),
        ("application/json", JSON),
        ("APPLICATION/JSON", JSON),
        ("application/json; charset=utf-8", JSON),
        ("application/json, application/xml", XML),
        ("application/xml;q=0.5, application/json", JSON),
        ("application/xml;q=0.5, */*;q=0.8", JSON),
        ("application/json;q=0.4, */*;q=0.3", JSON),
        ("application/*;q=0.2, application/json;q=0.1", XML),
        ("application/xml;q=0, */*", JSON),
        ("text/html, */*;q=0.1", XML),
        ("text/html", None),
        ("application/json;q=0", None),
        ("application/json;q=nan", None),
        ("application/json;q=-1", None),
        ("application/json;q=2", None),
        ("*/*;q=0", None),
        (",,;,", None),
    ],
)
def test_the_type_with_the_highest_quality_is_preferred(accept: str | None, wanted: str | None) -> None:
    assert preferred(accept, (XML, JSON)) == wanted
