from pathlib import Path

import pytest

from tests.support.characters import CHARACTERS
from tests.support.words.by_hand import FIGURE_8, figure_8, function, spoken, utterance
from understudy.errors import AuthoringError
from understudy.model import BehaviorCandidates, Function, Level, Movement, Parse, Utterance, Word
from understudy.rules.mapping import MappingRules, map_functions, offer_movements
from understudy.rules.program.loading import load_program

ROOT = Path(__file__).resolve().parents[2]
RULES = ROOT / "app" / "rules"

# The behaviours that the paper's Table 2 names for each class, by our names.
TABLE_2 = {
    "affirmation": {"big_nod", "tilt_left_nod", "tilt_right_nod"},
    "negation": {"gesture_negation", "shake", "small_shake"},
    "interrogative": {"gesture_question", "brow_raise"},
    "contrast": {"gesture_contrast", "tilt_right", "tilt_left"},
    "comparison": {"gesture_comparative", "gesture_comparative_longer", "gesture_comparative_bigger"},
    "mental": {"tilt_half_nod_left", "shrug"},
    "performance": {"gaze_aversion_upright", "short_blink"},
    "deixis": {"gesture_point_left", "gesture_point_right", "gaze_left", "gaze_right"},
    "emphasis": {"gesture_rhythm", "small_nod", "beat_gesture"},
    "intensifier": {"brow_frown", "half_nod"},
}

# Every class of shared/functions.md and docs/functions.md with its subtypes.
SUBTYPES = {
    "affirmation": "plain",
    "negation": "plain",
    "interrogative": "wh polar tag indirect",
    "contrast": "plain",
    "process": "start continue stop change",
    "quantification": "all none many few some number plain",
    "comparison": "positive negative equal superlative strong_positive plain",
    "spatial": "up down near far front back left right inside outside through around between away plain",
    "physical": "big small long short wide narrow heavy light high low fast slow hard soft round flat",
    "mental": "think know unsure feel want remember",
    "performance": "filler repeat repair hesitation search plain",
    "deixis": "self addressee inclusive proximal distal place",
    "modal": "likelihood ability permission obligation",
    "emphasis": "plain",
    "intensifier": "plain",
    "valence": "positive negative",
    "initial_noun_phrase": "plain",
    "initial_verb_phrase": "plain",
    "greeting": "plain",
    "parting": "plain",
    "thanks": "plain",
    "apology": "plain",
    "politeness": "plain",
    "quoting": "introduction words",
    "enumeration": "first next last item",
    "topic_shift": "new return",
    "parenthesis": "plain",
    "information": "theme rheme",
    "hedging": "plain",
    "inclusion": "everyone together joining",
    "obligation": "self addressee inclusive other",
    "locus": "left right",
    "time": "past present future approaching passing",
    "idea": "size weight distance hold give aside weigh apart",
    "height": "more less",
    "container": "in into out full empty",
    "path": "forward back aside obstacle along arrival",
}
EVERY_FUNCTION = [(name, subtype) for name, subtypes in SUBTYPES.items() for subtype in subtypes.split()]


@pytest.fixture(scope="module")
def rules() -> MappingRules:
    return MappingRules.load(RULES, CHARACTERS.callable_names)


def offered(
    rules: MappingRules, functions: tuple[Function, ...], level: Level | None = Level.MEDIUM, *, seed: int = 0
) -> tuple[BehaviorCandidates, ...]:
    return offer_movements(rules, utterance(spoken(FIGURE_8), level), functions, seed=seed)


def luckiest(candidates: tuple[BehaviorCandidates, ...]) -> tuple[Movement, ...]:
    """What is drawn where nothing but luck decides."""
    lucky = (min(offer.alternatives, key=lambda each: each.lot / each.weight) for offer in candidates)
    return tuple(movement for alternative in lucky for movement in alternative.movements)


def chosen(
    rules: MappingRules, functions: tuple[Function, ...], level: Level | None = Level.MEDIUM, *, seed: int = 0
) -> tuple[Movement, ...]:
    return luckiest(offered(rules, functions, level, seed=seed))


def ever_chosen(rules: MappingRules, functions: tuple[Function, ...], level: Level) -> set[str]:
    return {movement.name for seed in range(120) for movement in chosen(rules, functions, level, seed=seed)}


SHOWN_IN_ONE_WAY = (
    ("deixis", "self"),
    ("deixis", "addressee"),
    ("initial_noun_phrase", "plain"),
    ("initial_verb_phrase", "plain"),
)
"""Persons are pointed at or not shown, and a sentence is opened by the head or not: brows, blinks and glances would be
movements that show nothing."""


def test_there_are_130_rules_most_with_alternatives(rules: MappingRules) -> None:
    choosing = [rule for rule in rules.program.rules if rule.kind == "choose"]
    assert len(choosing) >= 130
    assert len([rule for rule in choosing if len(rule.calls) > 1]) >= 120


@pytest.mark.parametrize("level", Level)
@pytest.mark.parametrize(("class_name", "subtype"), EVERY_FUNCTION)
def test_every_function_has_alternatives_on_two_channels(
    rules: MappingRules, class_name: str, subtype: str, level: Level
) -> None:
    (offer,) = offered(rules, (function(class_name, subtype, 2, 3),), level)
    entries = CHARACTERS.named("default").entries
    channels = {entries[each.name].channel for alternative in offer.alternatives for each in alternative.movements}
    assert len(channels) >= (1 if (class_name, subtype) in SHOWN_IN_ONE_WAY else 2)


@pytest.mark.parametrize("class_name", TABLE_2)
def test_the_behaviours_of_table_2_are_offered_for_their_class(rules: MappingRules, class_name: str) -> None:
    calls = {
        call
        for rule in rules.program.rules
        if any(mention.predicate == "fcn" and mention.arguments[0] == class_name for mention in rule.joins)
        for call in rule.calls
    }
    assert TABLE_2[class_name] <= calls


@pytest.mark.parametrize("level", Level)
@pytest.mark.parametrize(("class_name", "subtype"), EVERY_FUNCTION)
def test_every_function_has_a_movement_on_its_words(
    rules: MappingRules, class_name: str, subtype: str, level: Level
) -> None:
    movements = chosen(rules, (function(class_name, subtype, 2, 3, 4.5),), level)
    assert movements
    for movement in movements:
        assert (movement.first, movement.last, movement.priority) == (2, 3, 4.5)
        assert movement.function == f"{class_name}2"


def test_every_subtype_that_function_rules_derive_is_mapped(rules: MappingRules) -> None:
    program = load_program([RULES / "vocabulary.rules", *sorted((RULES / "functions").glob("*.rules"))])
    derived = {
        (mention.arguments[0], mention.arguments[1])
        for rule in program.rules
        for mention in rule.asserts
        if mention.predicate == "fcn" and not any(argument.startswith("$") for argument in mention.arguments[:2])
    }
    assert [each for each in sorted(derived) if not chosen(rules, (function(*each, 2, 2),))] == []


def test_figure_8(rules: MappingRules) -> None:
    candidates = offered(rules, figure_8(), Level.HIGH)
    ideal = {
        offer.function and offer.function.id: {
            frozenset(each.name for each in alternative.movements) for alternative in offer.alternatives
        }
        for offer in candidates
    }
    for word in (0, 3, 5):
        assert frozenset({"gesture_me"}) in ideal[f"deixis{word}"]
    assert frozenset({"shake", "gesture_negation"}) in ideal["negation2"]
    assert ideal.keys() == {each.id for each in figure_8()}


def test_luck_follows_the_weights(rules: MappingRules) -> None:
    start = (function("process", "start", 4, 4),)
    (offer,) = offered(rules, start)
    share = 3 / sum(alternative.weight for alternative in offer.alternatives)
    names = [chosen(rules, start, seed=seed)[0].name for seed in range(600)]
    assert names.count("gesture_start") / 600 == pytest.approx(share, abs=0.06)


def test_low_agitation_moves_the_head_from_side_to_side(rules: MappingRules) -> None:
    emphasis = (function("emphasis", "plain", 1, 1), function("initial_verb_phrase", "plain", 5, 6))
    low, high = ever_chosen(rules, emphasis, Level.LOW), ever_chosen(rules, emphasis, Level.HIGH)
    assert "sway" in low - high
    assert "small_nod" in high - low


def test_high_agitation_beats_rather_than_raises_a_brow(rules: MappingRules) -> None:
    emphasis = (function("emphasis", "plain", 1, 1),)
    low, high = ever_chosen(rules, emphasis, Level.LOW), ever_chosen(rules, emphasis, Level.HIGH)
    assert {"beat_gesture", "beat_both"} <= high - low
    assert "small_brow_raise" in low


def test_without_a_voice_the_agitation_counts_as_medium(rules: MappingRules) -> None:
    for seed in range(10):
        no_progress = chosen(rules, figure_8(), None, seed=seed)
        assert no_progress == chosen(rules, figure_8(), Level.MEDIUM, seed=seed)


def test_a_comparison_of_size_has_its_own_gesture(rules: MappingRules) -> None:
    longer = (function("comparison", "positive", 3, 4), function("physical", "long", 4, 4))
    names = [movement.name for seed in range(40) for movement in chosen(rules, longer, seed=seed)]
    assert names.count("gesture_comparative_longer") > names.count("gesture_comparative")


def test_seeds_draw_differently_and_the_same_seed_the_same(rules: MappingRules) -> None:
    draws = [chosen(rules, figure_8(), seed=seed) for seed in range(5)]
    assert len(set(draws)) > 1
    assert draws == [chosen(rules, figure_8(), seed=seed) for seed in range(5)]


def test_the_order_of_the_functions_does_not_matter(rules: MappingRules) -> None:
    assert chosen(rules, tuple(reversed(figure_8()))) == chosen(rules, figure_8())


def test_the_same_function_draws_differently_in_other_lines(rules: MappingRules) -> None:
    emphasis = (function("emphasis", "plain", 1, 1),)
    lines = [utterance(spoken(f"Say {number} again.")) for number in range(20)]
    draws = [luckiest(offer_movements(rules, line, emphasis, seed=0)) for line in lines]
    assert len({tuple(each.name for each in draw) for draw in draws}) > 1
    assert draws == [luckiest(offer_movements(rules, line, emphasis, seed=0)) for line in lines]


def test_another_function_does_not_change_the_draw(rules: MappingRules) -> None:
    no = function("negation", "plain", 2, 2)
    alone = chosen(rules, (no,))
    beside = chosen(rules, (no, function("valence", "positive", 11, 11)))
    assert [each.name for each in alone] == [each.name for each in beside if each.function == no.id]


def test_functions_that_lost_are_not_shown(rules: MappingRules) -> None:
    lost = Function("f1", "negation", "plain", 2, 2, 5, "by_hand", kept=False, lost_to="f2")
    assert chosen(rules, (lost,)) == ()


@pytest.mark.parametrize(
    ("rule", "message"),
    [
        ("foreach\n  word(no, $s, $e)\nchoose\n  weight 1\n    shake($s, $e)\n", "maps no function"),
        ("foreach\n  fcn(negation, _, $s, $e, _)\nchoose\n  weight 1\n    shaek($s, $e)\n", "shake"),
        ("foreach\n  fcn(negatoin, _, $s, $e, _)\nchoose\n  weight 1\n    shake($s, $e)\n", "did you mean 'negation'"),
        ("foreach\n  fcn(negation, strnog, $s, $e, _)\nchoose\n  weight 1\n    shake($s, $e)\n", "no subtype strnog"),
        ("foreach\n  fcn(negation|modla, _, $s, $e, _)\nchoose\n  weight 1\n    shake($s, $e)\n", "class modla"),
    ],
)
def test_rules_that_cannot_map_do_not_load(tmp_path: Path, rule: str, message: str) -> None:
    with pytest.raises(AuthoringError, match=message):
        MappingRules.load(_folder(tmp_path, rule), CHARACTERS.callable_names)


def test_a_behaviour_on_no_span_is_the_rules_mistake(tmp_path: Path) -> None:
    rule = "foreach\n  fcn(negation, _, $s, $e, _)\nchoose\n  weight 1\n    shake($e, $s)\n"
    rules = MappingRules.load(_folder(tmp_path, rule), CHARACTERS.callable_names)
    with pytest.raises(AuthoringError, match=r"shake\(3, 2\) is not a span"):
        chosen(rules, (function("negation", "plain", 2, 2),))


def _folder(folder: Path, rule: str) -> Path:
    for name in ("behaviors", "functions"):
        (folder / name).mkdir()
    for name in ("vocabulary.rules", "functions/priorities.yaml"):
        (folder / name).write_text((RULES / name).read_text(encoding="utf-8"), encoding="utf-8")
    (folder / "behaviors" / "one.rules").write_text(f"rule one\n{rule}", encoding="utf-8")
    return folder


def test_always_and_never_are_demands_for_any_fact_and_no_offers(tmp_path: Path) -> None:
    rule = """
foreach
  word(whatever, $start, $end)
choose
  always
    gesture_dismiss($start, $end)
  never when $start >= 0
    shake($start, $end)
    head($start, $end)
"""
    rules = MappingRules.load(_folder(tmp_path, rule), CHARACTERS.callable_names)
    words = tuple(Word(index, text) for index, text in enumerate(("So", "whatever.")))
    mapped = map_functions(rules, Utterance(words, Parse((), (), ())), (), seed=0)
    assert mapped.offers == ()
    assert [(each.what, each.first, each.always, each.by) for each in mapped.demands] == [
        ("gesture_dismiss", 1, True, "rule one"),
        ("shake", 1, False, "rule one"),
        ("head", 1, False, "rule one"),
    ]


def test_what_is_neither_behaviour_nor_family_nor_channel_cannot_be_forbidden(tmp_path: Path) -> None:
    rule = "foreach\n  word(no, $s, $e)\nchoose\n  never\n    shakes($s, $e)\n"
    with pytest.raises(AuthoringError, match="unknown behaviour shakes; did you mean 'shake'"):
        MappingRules.load(_folder(tmp_path, rule), CHARACTERS.callable_names)
