"""Who was told to come again comes before those who were not, in order, for as long as that is to be expected; names
that a client makes up gain it nothing against others."""

import asyncio

import pytest

from understudy.api.workers.turns import (
    HELD_S,
    KEPT_S,
    MOST_CLIENTS,
    MOST_EACH,
    MOST_HELD,
    MOST_PROMPT,
    Caller,
    Refusals,
    Turns,
)
from understudy.errors import ServiceError


def test_turns_are_in_the_order_of_first_coming_and_kept_when_refused_again() -> None:
    now_s = [0.0]
    turns = Turns(lambda: now_s[0])
    for client in "abc":
        turns.keep(Caller(client), 0.5)
    turns.keep(Caller("a"), 0.5)
    now_s[0] = 1.0
    assert [turns.before(Caller(client)) for client in "abcd"] == [0, 1, 2, None]
    turns.take(Caller("b"))
    assert turns.before(Caller("c")) == 1


def test_a_turn_begins_at_the_told_time_and_ends_for_who_does_not_come() -> None:
    now_s = [0.0]
    turns = Turns(lambda: now_s[0])
    turns.keep(Caller("a"), 10.0)
    turns.keep(Caller("b"), 1.0)
    now_s[0] = 3.0
    assert (turns.before(Caller("a")), turns.before(Caller("b"))) == (None, 0)
    now_s[0] = 10.0
    assert (turns.before(Caller("a")), turns.before(Caller("b"))) == (0, None)
    now_s[0] = 10.1 + KEPT_S
    assert turns.before(Caller("a")) is None


def test_the_second_turn_of_a_client_comes_after_the_first_of_every_other() -> None:
    now_s = [0.0]
    turns = Turns(lambda: now_s[0])
    for name in ("1", "2", "3"):
        turns.keep(Caller("many", name), 0.5)
    turns.keep(Caller("one", "1"), 0.5)
    turns.keep(Caller("two", "1"), 0.5)
    turns.keep(Caller("two", "2"), 0.5)
    now_s[0] = 1.0
    order = [("many", "1"), ("one", "1"), ("two", "1"), ("many", "2"), ("two", "2"), ("many", "3")]
    assert [turns.before(Caller(client, name)) for client, name in order] == [0, 1, 2, 3, 4, 5]


def test_memory_is_bounded() -> None:
    turns = Turns(lambda: 0.0)
    for number in range(2 * MOST_CLIENTS):
        turns.keep(Caller(str(number)), 0.0)
    for number in range(2 * MOST_EACH):
        turns.keep(Caller("0", str(number)), 0.0)
    assert len(turns._kept) == MOST_CLIENTS
    assert max(map(len, turns._kept.values())) == MOST_EACH


async def refused_after_s(refusals: Refusals, client: str, code: str = "service_full") -> float:
    """How long a refusal takes by the event loop's clock."""
    loop = asyncio.get_running_loop()
    began_s = loop.time()
    with pytest.raises(ServiceError):
        async with refusals.held_back(client):
            raise ServiceError(code, "no")
    return loop.time() - began_s


async def refused_at_once(refusals: Refusals, client: str, times: int, code: str = "service_full") -> list[bool]:
    """For each of so many refusals, one after the other, whether it came at once."""
    return [await refused_after_s(refusals, client, code) < HELD_S / 2 for _ in range(times)]


def test_who_asks_again_at_once_waits_for_the_next_refusal_and_nobody_else_does() -> None:
    now_s = [0.0]
    refusals = Refusals(lambda: now_s[0])

    async def ask() -> None:
        assert await refused_at_once(refusals, "impatient", MOST_PROMPT + 1) == [True] * MOST_PROMPT + [False]
        assert await refused_at_once(refusals, "other", 1) == [True]
        assert await refused_at_once(refusals, "impatient", 1, "service_stopping") == [True]
        now_s[0] = 1.1
        assert await refused_at_once(refusals, "impatient", 1) == [True]

    asyncio.run(ask())


def test_those_who_come_again_after_a_second_never_wait() -> None:
    """Several behind one address, of whom each waits as long as it is told."""
    now_s = [0.0]
    refusals = Refusals(lambda: now_s[0])

    async def ask() -> None:
        for _ in range(10):
            assert await refused_at_once(refusals, "patient", MOST_PROMPT) == [True] * MOST_PROMPT
            now_s[0] += 1.01

    asyncio.run(ask())


def test_only_so_many_refusals_are_held() -> None:
    refusals = Refusals(lambda: 0.0)

    async def ask() -> None:
        await asyncio.gather(*(refused_after_s(refusals, "crowd") for _ in range(MOST_PROMPT)))
        took_s = await asyncio.gather(*(refused_after_s(refusals, "crowd") for _ in range(MOST_HELD + 10)))
        assert sum(each >= HELD_S for each in took_s) == MOST_HELD

    asyncio.run(ask())


def test_refusals_of_many_clients_take_little_memory() -> None:
    refusals = Refusals(lambda: 0.0)

    async def ask() -> None:
        for number in range(2 * MOST_CLIENTS):
            await refused_after_s(refusals, str(number))

    asyncio.run(ask())
    assert len(refusals._refused_s) == MOST_CLIENTS
