"""Who was told to come again comes before those who were not, in order, for as long as that is to be expected; names
that a client makes up gain it nothing against others."""

from understudy.api.workers.turns import KEPT_S, MOST_CLIENTS, MOST_EACH, Caller, Turns


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
