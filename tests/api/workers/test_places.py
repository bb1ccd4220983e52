"""The places of a full queue: who asks under many names gets no more than its share, and who comes back finds room."""

import asyncio
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass, field

from understudy.api.workers.places import ASKS_S, Places
from understudy.api.workers.turns import MOST_CLIENTS, Caller, Turns

MANY, ONE, OTHER = "address of many names", "one", "other"


@dataclass(slots=True)
class _Queue:
    """A queue whose clock stands until it is set."""

    length: int
    now_s: float = 0.0
    held: ExitStack = field(default_factory=ExitStack)
    places: Places[str] = field(init=False)

    def __post_init__(self) -> None:
        self.places = Places(self.length, Turns(lambda: self.now_s), lambda: self.now_s)

    def ask(self, caller: Caller) -> bool:
        """Whether the caller is let in; if not, it is told to come again in a second."""
        if not self.places.has_room(caller):
            self.places.turns.keep(caller, 1.0)
            return False
        self.places.turns.take(caller)
        self.held.enter_context(self.places.place(caller.client))
        return True

    def flood(self, times: int, begin: int = 0) -> int:
        """How many requests of one client are let in, each under another name."""
        return sum(self.ask(Caller(MANY, str(begin + number))) for number in range(times))

    def serve(self) -> str | None:
        """The client whose job is next; its place is free from then."""
        before = list(self.places._waiting)
        self.places.next()
        return next((place.client for place in before if place not in self.places._waiting), None)


def _with(length: int, scenario: Callable[[_Queue], None]) -> None:
    async def run() -> None:
        scenario(_Queue(length))

    asyncio.run(run())


def test_who_asks_alone_has_every_place() -> None:
    def scenario(queue: _Queue) -> None:
        assert queue.flood(20) == 8

    _with(8, scenario)


def test_who_comes_back_when_told_finds_room_however_often_newcomers_ask() -> None:
    def scenario(queue: _Queue) -> None:
        queue.flood(20)
        assert not queue.ask(Caller(ONE, "a"))
        queue.now_s = 1.0
        assert queue.flood(20, 20) == 0
        assert not queue.ask(Caller(OTHER, "never seen"))
        assert queue.ask(Caller(ONE, "a"))

    _with(8, scenario)


def test_it_has_another_turn_only_when_it_is_refused_again() -> None:
    def scenario(queue: _Queue) -> None:
        queue.flood(20)
        assert not queue.ask(Caller(ONE))
        queue.now_s = 1.0
        assert queue.ask(Caller(ONE))
        assert not queue.ask(Caller(ONE))

    _with(8, scenario)


def test_while_others_ask_one_client_has_no_more_than_its_share() -> None:
    """Of eight places and four for those who return, two clients have six each, three have four."""

    def scenario(queue: _Queue) -> None:
        assert queue.flood(20) == 8
        assert not queue.ask(Caller(ONE))
        for _ in range(8):
            assert queue.serve() == MANY
            queue.flood(5)
        assert queue.places._of(MANY) == 6
        assert queue.ask(Caller(ONE))
        assert queue.ask(Caller(OTHER))
        for _ in range(8):
            queue.serve()
            queue.flood(5)
        assert queue.places._of(MANY) == 4

    _with(8, scenario)


def test_a_share_counts_only_where_places_are_few_and_only_while_others_ask() -> None:
    def scenario(queue: _Queue) -> None:
        for number in range(12):
            queue.places.has_room(Caller(str(number)))
        assert queue.flood(20) == 4
        queue.now_s = 2 * ASKS_S
        assert queue.flood(20) == 4

    _with(8, scenario)


def test_clients_are_served_in_rounds() -> None:
    def scenario(queue: _Queue) -> None:
        queue.flood(4)
        assert queue.ask(Caller(ONE, "1"))
        assert queue.ask(Caller(ONE, "2"))
        assert [queue.serve() for _ in range(3)] == [MANY, ONE, MANY]
        assert queue.ask(Caller(OTHER))
        assert [queue.serve() for _ in range(5)] == [ONE, OTHER, MANY, MANY, None]

    _with(8, scenario)


def test_without_a_queue_nobody_waits() -> None:
    def scenario(queue: _Queue) -> None:
        assert not queue.ask(Caller(ONE))
        queue.now_s = 1.0
        assert not queue.ask(Caller(ONE))

    _with(0, scenario)


def test_memory_is_bounded() -> None:
    def scenario(queue: _Queue) -> None:
        for number in range(2 * MOST_CLIENTS):
            queue.places.has_room(Caller(str(number)))
        assert len(queue.places._asked_s) == MOST_CLIENTS

    _with(1, scenario)
