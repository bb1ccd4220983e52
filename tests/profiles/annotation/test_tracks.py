"""What a stretch of time touches, holds and lies in, beside a look at each thing."""

import random

from understudy.profiles.annotation.tracks import InTime


def test_a_look_at_each_finds_the_same() -> None:
    rng = random.Random(20)
    spans = [(start, start + rng.choice((0.0, 0.5, 1.0, 4.0))) for start in (rng.randrange(20) / 2 for _ in range(30))]
    found = InTime.of(spans, lambda span: span)
    for start, end in [(rng.randrange(20) / 2, rng.randrange(20, 40) / 2) for _ in range(50)] + [
        (3.0, 3.0),
        (3.0, 3.5),
    ]:
        assert sorted(found.touching(start, end)) == sorted(each for each in spans if each[0] < end and each[1] > start)
        assert sorted(found.within(start, end)) == sorted(each for each in spans if start <= each[0] and each[1] <= end)
        assert found.any_holds(start, end) is any(each[0] <= start and end <= each[1] for each in spans)


def test_nothing_is_in_nothing() -> None:
    empty = InTime[int].of((), lambda _thing: (0.0, 0.0))
    assert (empty.touching(0, 9), empty.within(0, 9), empty.any_holds(1, 2)) == ((), (), False)
