"""A request may be sent to the names that are allowed, whatever port it says."""

import pytest

from understudy.api.admission.headers import is_allowed

ALLOWED = ("lines.example", ".studio.example", "127.0.0.1", "[::1]")


@pytest.mark.parametrize(
    "host", ["lines.example", "LINES.example:8000", "lines.example.", "a.studio.example", "127.0.0.1:80", "[::1]:8000"]
)
def test_names_that_are_allowed(host: str) -> None:
    assert is_allowed(host, ALLOWED)


@pytest.mark.parametrize(
    "host",
    [
        *(None, "", "evil.example", "xlines.example", "studio.example", "lines.example.evil.example"),
        *("[::2]", "[::1].evil", "lines.example:80.evil", "[::1]:80.evil"),
    ],
)
def test_all_others_are_not_but_where_any_is(host: str | None) -> None:
    assert not is_allowed(host, ALLOWED)
    assert is_allowed(host, ())
