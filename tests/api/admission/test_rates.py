"""How often one client may ask, by a clock of the test's own."""

import pytest

from understudy.api.admission.rates import MOST_CLIENTS, Frequency, Rates
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


def test_some_may_ask_at_once_and_the_others_wait_their_time() -> None:
    now_s = [0.0]
    frequency = Frequency(10.0, 2, lambda: now_s[0])
    assert [frequency.wait_s("a") for _ in range(4)] == pytest.approx([0.0, 0.0, 0.1, 0.2])
    assert frequency.wait_s("b") == 0.0
    now_s[0] = 0.3
    assert frequency.wait_s("a") == 0.0
    for number in range(MOST_CLIENTS):
        frequency.wait_s(str(number))
    assert len(frequency._full_at_s) == MOST_CLIENTS
