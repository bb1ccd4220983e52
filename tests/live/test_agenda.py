"""What is to be done, and what makes way."""

from understudy.live.agenda import REMEMBERED_S, WORDED, Agenda
from understudy.live.messages import BehaviorMessage, WithdrawalMessage
from understudy.model import Behavior, Channel, SyncPoints


def behavior(name: str, start_s: float, end_s: float, kind: Channel = Channel.GESTURE) -> Behavior:
    sync = SyncPoints(start=start_s, ready=start_s + 0.1, relax=end_s - 0.2, end=end_s)
    return Behavior(name, kind, "BEAT", sync, 0, 0, 0.1)


def test_a_change_is_told_once_and_as_one() -> None:
    agenda = Agenda()
    one, changed = behavior("one", 0, 1), behavior("one", 0, 2)
    told = [each for every in (one, one, changed) for each in agenda.keep([every], 0.0)]
    assert told == [BehaviorMessage(one, 0.0, revised=False), BehaviorMessage(changed, 0.0, revised=True)]
    assert agenda.behaviors == (changed,)


def test_what_goes_on_relaxes_for_what_comes_and_what_has_not_begun_is_given_up() -> None:
    agenda = Agenda()
    list(agenda.keep([behavior("now", 0, 3), behavior("later", 2.5, 4), behavior("nod", 1, 3, Channel.HEAD)], 0.0))
    told = list(agenda.make_way([behavior("coming", 2, 3)], 1.0))
    assert WithdrawalMessage("later", 1.0) in told
    assert agenda.by_id["now"].sync.end == 2
    assert agenda.by_id["nod"].sync.end == 3
    assert len(told) == 2


def test_what_words_promised_keeps_its_channel() -> None:
    agenda = Agenda()
    list(agenda.keep([behavior(f"{WORDED}1.g", 1, 2)], 0.0))
    beside, nod, over = behavior("b", 2, 3), behavior("n", 1, 2, Channel.HEAD), behavior("o", 1.9, 3)
    assert agenda.beside([beside, nod, over]) == (beside, nod)


def test_only_what_is_not_over_is_given_up_and_what_is_long_over_forgotten() -> None:
    agenda = Agenda()
    list(agenda.keep([behavior("over", 0, 1), behavior("on", 1, 3)], 0.0))
    assert list(agenda.give_up(2.0)) == [WithdrawalMessage("on", 2.0)]
    agenda.forget(1 + REMEMBERED_S)
    assert agenda.behaviors
    agenda.forget(1.1 + REMEMBERED_S)
    assert not agenda.behaviors
