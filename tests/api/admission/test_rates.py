"""How often one client may ask, by a clock of the test's own."""

import pytest

from understudy.api.admission.rates import MOST_CLIENTS, Rates
from understudy.errors import TooManyError


def test_so_many_a_minute_and_then_one_by_one() -> None:
    now_s = [0.0]
    rates = Rates(6, lambda: now_s[0])
    for _ in range(6):
        rates.take("a")
    with pytest.raises(TooManyError) as caught:
        rates.take("a")
    assert caught.value.retry_after_s == pytest.approx(10.0)
    rates.take("b")
    now_s[0] = 10.0
    rates.take("a")
    with pytest.raises(TooManyError):
        rates.take("a")


def test_without_a_rate_everything_passes() -> None:
    rates = Rates(0)
    for _ in range(1000):
        rates.take("a")


def test_clients_are_forgotten_so_that_memory_is_bounded() -> None:
    rates = Rates(1, lambda: 0.0)
    for number in range(MOST_CLIENTS + 1):
        rates.take(str(number))
    rates.take("0")
    with pytest.raises(TooManyError):
        rates.take(str(MOST_CLIENTS))
