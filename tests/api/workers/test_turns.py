"""Who was told to come again comes before those who were not, in order, for as long as that is to be expected."""

from understudy.api.workers.turns import KEPT_S, MOST_KEPT, Turns


def test_turns_are_in_the_order_of_first_coming_and_kept_when_refused_again() -> None:
    now_s = [0.0]
    turns = Turns(lambda: now_s[0])
    for caller in "abc":
        turns.keep(caller, 0.5)
    turns.keep("a", 0.5)
    now_s[0] = 1.0
    assert [turns.before(caller) for caller in "abcd"] == [0, 1, 2, 3]
    turns.take("b")
    assert turns.before("c") == 1


def test_nobody_stands_back_for_who_need_not_be_back_yet_or_does_not_come() -> None:
    now_s = [0.0]
    turns = Turns(lambda: now_s[0])
    turns.keep("a", 10.0)
    now_s[0] = 9.0
    assert turns.before("b") == 0
    now_s[0] = 10.0
    assert turns.before("b") == 1
    now_s[0] = 10.1 + KEPT_S
    assert turns.before("b") == 0


def test_memory_is_bounded() -> None:
    turns = Turns(lambda: 0.0)
    for number in range(2 * MOST_KEPT):
        turns.keep(str(number), 0.0)
    assert len(turns._due_s) == MOST_KEPT
