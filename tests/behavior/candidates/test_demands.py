"""What comes always and what never, by hand-written demands and in whole performances."""

from dataclasses import replace

import pytest

from understudy.behavior.candidates.demands import (
    beside,
    demanded,
    kept_free,
    meant,
    overruled,
    permitted,
    wherever_offered,
)
from understudy.behavior.reading.player import Ban, Player
from understudy.behavior.reading.supports import Support
from understudy.errors import InputError
from understudy.library.language import find_functions
from understudy.model import (
    Analysis,
    Behavior,
    Channel,
    Demand,
    Direction,
    Function,
    Interval,
    Moment,
    Utterance,
)
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform_analysis

POINTING = {"POINT_FRONT", "POINT_LEFT", "POINT_RIGHT", "POINT_UP", "HERE", "THERE"}


def spoken(understudy: Understudy, text: str) -> Analysis:
    analysis = find_functions(understudy.language, text)
    words = tuple(
        replace(word, interval=Interval(0.6 + 0.35 * word.index, 0.9 + 0.35 * word.index))
        for word in analysis.utterance.words
    )
    utterance: Utterance = replace(analysis.utterance, words=words, duration_s=1.2 + 0.35 * len(words))
    return replace(analysis, utterance=utterance)


def shown(understudy: Understudy, text: str, direction: Direction | None = None, **options: str) -> list[Behavior]:
    performance = perform_analysis(understudy, spoken(understudy, text), Options(**options), direction)  # type: ignore[arg-type]
    return [each for each in performance.behaviors if each.kept]


def player(understudy: Understudy, *bans: Ban) -> Player:
    behavior = understudy.behavior
    return Player(behavior.families, behavior.characters.named("default").entries, bans=bans)


@pytest.mark.parametrize(
    ("what", "among", "outside"),
    [
        ("gesture_point_front", "gesture_point_front", "gesture_point_up"),
        ("POINT_UP", "gesture_point_up", "gesture_point_front"),
        ("point_there", "gesture_there", "gesture_point_up"),
        ("shake", "small_shake", "sway"),
        ("frown", "small_frown", "brow_raise"),
        ("head", "big_nod", "gesture_me"),
        ("hands", "gesture_me", "big_nod"),
        ("any", "gesture_me", None),
    ],
)
def test_a_word_of_the_author_means_lexemes_families_and_channels(
    understudy: Understudy, what: str, among: str, outside: str | None
) -> None:
    names = meant(what, understudy.behavior.families, player(understudy).behaviors)
    assert among in names
    assert outside not in names


def test_what_is_demanded_is_shown_though_nothing_else_speaks_for_it(understudy: Understudy) -> None:
    demand = Demand("gesture_dismiss", 0, 0, always=True, by="the note always[0]")
    found = shown(understudy, "The train to Oxford leaves at nine.", Direction(demands=(demand,)))
    (wave,) = [each for each in found if each.lexeme == "DISMISS"]
    assert (wave.first, wave.last) == (0, 0)
    assert wave.decided_by[0].name == "required by the note always[0]"


@pytest.mark.parametrize(
    ("what", "lexemes"), [("DISMISS", {"DISMISS"}), ("dismiss", {"DISMISS"}), ("frown", {"LOWER_BROWS"})]
)
@pytest.mark.parametrize("choice", ["terms", "priority"])
def test_a_lexeme_or_a_family_is_demanded_by_its_name(
    understudy: Understudy, what: str, lexemes: set[str], choice: str
) -> None:
    demand = Demand(what, 1, 1, always=True, by="the note always[0]")
    found = shown(understudy, "The train to Oxford leaves at nine.", Direction(demands=(demand,)), choice=choice)
    asked = [each for each in found if each.decided_by and each.decided_by[0].name == "required by the note always[0]"]
    assert {each.lexeme for each in asked} == lexemes


def test_a_family_is_shown_by_the_behaviour_that_its_words_ask_for(understudy: Understudy) -> None:
    by = "the note always[0]"
    for text, lexeme in (("It goes up behind us.", "OVER_SHOULDER"), ("It goes up before us.", "POINT_FRONT")):
        demand = Demand("point_there", 3, 3, always=True, by=by)
        (asked, *_) = demanded(player(understudy), [demand], spoken(understudy, text).utterance)
        first = asked.alternatives[0].movements[0].name
        assert player(understudy).behaviors[first].lexeme == lexeme


@pytest.mark.parametrize(
    ("what", "always", "reason"),
    [
        ("bananas", False, "the note: there is no behaviour, lexeme or family 'bananas'"),
        ("gesture_dismis", True, "did you mean 'gesture_dismiss'"),
        ("hands", True, "'hands' does not say which movement"),
    ],
)
def test_what_notes_name_must_be_known(understudy: Understudy, what: str, always: bool, reason: str) -> None:
    direction = Direction(demands=(Demand(what, 0, 0, always, "the note"),))
    with pytest.raises(InputError, match=reason) as raised:
        shown(understudy, "No, not that.", direction)
    assert (raised.value.code, raised.value.field) == ("direction_family", "direction")


def test_what_is_asked_for_and_forbidden_is_told_as_forbidden(understudy: Understudy) -> None:
    asked = Demand("beat_chop", 2, 2, always=True, by="the note always[0]")
    barred = Demand("chop", 2, 2, always=False, by="the note never[0]")
    performance = perform_analysis(
        understudy, spoken(understudy, "The train to Oxford leaves."), Options(), Direction(demands=(asked, barred))
    )
    told = [each for each in performance.behaviors if each.lexeme == "CHOP"]
    assert [(each.kept, each.limit, each.reason) for each in told] == [
        (False, "never", "excluded by the note never[0]")
    ]


def test_a_character_shows_one_movement_of_a_family_wherever_a_rule_offers_one(understudy: Understudy) -> None:
    function = Function("f1", "deixis", "inclusive", 0, 0, 3.0, "own")
    offers = [
        Support(name, "r", function, weight) for name, weight in (("gesture_we", 2.0), ("gesture_inclusive", 9.0))
    ]
    found = list(wherever_offered(["group"], offers, player(understudy), "the character host"))
    assert [(each.what, each.function) for each in found] == [("gesture_inclusive", "f1")]


def test_demands_of_several_functions_are_moments_of_their_own_or_one(understudy: Understudy) -> None:
    """Two functions of the same words ask once; of other words, though they begin on the same one, each for itself."""
    asked = [
        Demand("big_nod", 0, last, always=True, by="me", function=function)
        for last, function in ((0, "f1"), (0, "f2"), (2, "f3"))
    ]
    found = demanded(player(understudy), asked, spoken(understudy, "Well now, here we go then.").utterance)
    assert [each.alternatives[0].movements[0].function for each in found] == ["f1", "f3"]
    assert len({each.moment.id for each in found if each.moment}) == len(found)


@pytest.mark.parametrize("choice", ["terms", "priority"])
def test_what_is_forbidden_comes_by_no_way(understudy: Understudy, choice: str) -> None:
    line = "No, I never said that, and I don't know."
    shakes = [each for each in shown(understudy, line, choice=choice) if each.lexeme == "SHAKE"]
    demand = Demand("shake", 0, 8, always=False, by="the note never[0]")
    forbidden = shown(understudy, line, Direction(demands=(demand,)), choice=choice)
    assert shakes
    assert "SHAKE" not in {each.lexeme for each in forbidden}


@pytest.mark.parametrize("kind", ["nod", "tilt"])
def test_a_nod_or_tilt_is_forbidden_also_where_the_head_does_both(understudy: Understudy, kind: str) -> None:
    who = player(understudy)
    forbidden = meant(kind, who.families, who.behaviors)
    assert {each.name for each in who.families.head["tilted_nod"]} <= forbidden
    assert not {each.name for each in who.families.head["turn"]} & forbidden


@pytest.mark.parametrize("mode", ["semantic", "prosody", "random"])
@pytest.mark.parametrize("choice", ["terms", "priority"])
def test_the_reserved_man_never_points(understudy: Understudy, choice: str, mode: str) -> None:
    from understudy.model import Mode

    for text in ("It is over there, up on that hill, behind you.", "You there, come here, look up at this one!"):
        analysis = spoken(understudy, text)
        options = Options(character="reserved", choice=choice, mode=Mode(mode))  # type: ignore[arg-type]
        kept = [each for each in perform_analysis(understudy, analysis, options).behaviors if each.kept]
        assert not POINTING & {each.lexeme for each in kept}


def test_a_ban_leaves_the_other_movements_of_an_alternative(understudy: Understudy) -> None:
    demand = Demand("big_nod", 0, 1, always=True, by="me")
    who = player(understudy)
    line = spoken(understudy, "Well now, here we go then.").utterance
    (asked,) = demanded(who, [demand, demand], line)
    barred = replace(who, bans=(Ban(1, 1, frozenset({"big_nod"}), "never"),))
    assert permitted([asked], who) == (asked,)
    assert permitted([asked], barred) == ()
    assert demanded(barred, [demand], line) == ()
    assert [each.families for each in overruled(barred, [demand], line)] == [("nod",)]


def test_strokes_keep_time_from_a_demanded_one_and_heads_make_way(understudy: Understudy) -> None:
    line = spoken(understudy, "Well now, here we go then.").utterance
    (wave,) = demanded(player(understudy), [Demand("gesture_dismiss", 3, 3, always=True, by="me")], line)
    assert kept_free([wave], [0.0, 0.5, 1.2, 1.6, 2.0, 3.0]) == [2, 3, 4]
    (nod,) = demanded(player(understudy), [Demand("big_nod", 3, 4, always=True, by="me")], line)
    head = Moment("m", Channel.HEAD, 2, 3, 2, ("shake",), 0.5)
    stroke = Moment("g", Channel.GESTURE, 3, 3, 3, ("present",), 0.5)
    assert beside([head, stroke], [nod]) == (stroke,)
