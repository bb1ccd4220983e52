"""The table of gestures says what the realizer will do, so that what is scheduled with it is played."""

from dataclasses import replace

import pytest
from hypothesis import example, given
from hypothesis import strategies as st

from tests.support.characters import CHARACTERS
from tests.support.examples import examples
from tests.support.motion.gesture_clips import MARKERS, clip, gesture, library
from tests.support.words.by_hand import FIGURE_8, movement, offered, spoken, utterance
from understudy.behavior.characters.gesture_forms import with_forms
from understudy.behavior.choice.scheduling import schedule
from understudy.behavior.idle.stillness import stilled
from understudy.model import Channel, Hand, Level, Schedule
from understudy.model.limits import equal_transition_s, shortest_transition_s, transition_times
from understudy.models import load_gesture_table, load_gestures
from understudy.realizer.scheduling.gesture_table import gesture_table
from understudy.realizer.scheduling.planning import plan_gestures
from understudy.realizer.scheduling.selection import clips_of, place_clip, requests_of
from understudy.realizer.scheduling.transitions import stroke_speed_m_s, way_m

TABLE = load_gesture_table(CHARACTERS.gesture_lexemes)
LIBRARY = load_gestures()
GESTURES = sorted(
    name for name, entry in CHARACTERS.named("default").entries.items() if entry.channel is Channel.GESTURE
)
WORDS = (FIGURE_8 + " ") * 2


def test_forms_are_the_clips_that_may_be_drawn() -> None:
    clips = library(clip(), clip("long", markers=replace(MARKERS, stroke_end=1.4, relax=1.5, end=2.0)))
    forms = gesture_table(clips, ["GREETING"]).of("GREETING", Level.MEDIUM)[Hand.RIGHT]
    assert [form.before_s for form in forms] == pytest.approx([0.3, 0.3])
    assert [form.after_s for form in forms] == pytest.approx([0.2, 0.6])


@pytest.mark.parametrize("amounts", [(None, None), (0.2, 0.9)])
@pytest.mark.parametrize(("first", "second"), [("ME", "NEGATION"), ("SURROUND", "BEAT"), ("BEAT", "GATHER")])
def test_transition_times_are_those_of_placed_clips(
    first: str, second: str, amounts: tuple[float | None, float | None]
) -> None:
    behaviors = (
        gesture("g1", 2.0, 2.5, lexeme=first, amount=amounts[0]),
        gesture("g2", 3.5, 4.0, lexeme=second, hand=Hand.BOTH, amount=amounts[1]),
    )
    requests = requests_of(Schedule(behaviors, 9.0))
    befores, afters = ([place_clip(each, one) for each in clips_of(one, LIBRARY)] for one in requests)
    ways = [
        (way_m(one, two, arm), stroke_speed_m_s(two))
        for one in befores
        for two in afters
        for arm in set(one.arms) & set(two.arms)
    ]
    forms = (TABLE.of(each.lexeme, Level.MEDIUM)[each.hand or Hand.RIGHT] for each in behaviors)
    times = transition_times(*forms, amounts=amounts)
    assert times.shortest_s == pytest.approx(max(shortest_transition_s(*way) for way in ways))
    assert times.equal_s == pytest.approx(max(equal_transition_s(*way) for way in ways))


@given(
    names=st.lists(st.sampled_from(GESTURES), min_size=2, max_size=12),
    word_s=st.floats(0.12, 0.5),
    level=st.sampled_from(Level),
    character=st.sampled_from(sorted(CHARACTERS.by_name)),
    stillness=st.sampled_from([0.0, 0.35, 0.5, 0.9]),
    seed=st.integers(0, 3),
)
@example(["gesture_flat", "beat_both", "beat_both"], 0.5, Level.LOW, "expansive", 0.0, 0)  # begins at -6e-17 s
@example(["mime_throw", "mime_oath"], 0.5, Level.HIGH, "expansive", 0.5, 0)
@example([*["beat_both"] * 6, "gesture_aside", "gesture_comparative"], 0.25, Level.HIGH, "expansive", 0.5, 0)
@example(["mime_hit", "gesture_apology", "gesture_past", "mime_push_both"], 0.425, Level.HIGH, "expansive", 0.35, 2)
@examples(60)
def test_what_is_scheduled_is_played(
    names: list[str], word_s: float, level: Level, character: str, stillness: float, seed: int
) -> None:
    lively = replace(CHARACTERS.named(character), gestures_per_minute=60)
    words = spoken(WORDS, word_s=word_s, start_s=0.0)
    offers = [
        offered(replace(movement(name, 2 * place, priority=place % 5), function=f"f{place}"))
        for place, name in enumerate(names)
    ]
    behaviors = schedule(offers, utterance(words, level), with_forms(lively, TABLE, level), seed=seed)
    kept = tuple(each for each in stilled(behaviors, stillness) if each.kept)
    own = LIBRARY.in_manner(lively.figure.manner)
    plan = plan_gestures(own, Schedule(kept, 30.0, agitation=level, stillness=stillness), seed=seed)
    asked = {each.id: each.sync for each in kept if each.kind is Channel.GESTURE}
    assert plan.realized.keys() == asked.keys()
    assert not [each for each in plan.decisions if each.action in ("dropped", "late")]
    for name, sync in plan.realized.items():
        assert sync.stroke == pytest.approx(asked[name].stroke, abs=1e-3)
        assert sync.stroke_start is not None
        assert sync.stroke_start >= (asked[name].stroke_start or 0.0) - 0.002
        assert (sync.stroke_end or 0.0) <= (asked[name].stroke_end or 0.0) + 0.002
