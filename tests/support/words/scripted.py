"""What tests of generation need: a profile by hand, a repertoire, and a line in time."""

from collections.abc import Sequence

from understudy.model import Hand, Interval, Parse, Token, Utterance, Word
from understudy.model.limits import ArmEnds, GestureForm
from understudy.profiles.generation.candidates import PlayableGesture, Repertoire
from understudy.profiles.profile import (
    LexemeHabit,
    PhaseHabit,
    Profile,
    Smoothing,
    Spread,
    TagHabit,
    UnitHabit,
)

HANDS = {Hand.LEFT: 0.0, Hand.RIGHT: 1.0, Hand.BOTH: 0.0}


def habit(share: float, *, strokes: float = 1.0, offset_s: float = 0.0, held: float = 0.0) -> LexemeHabit:
    """A right-handed habit without deviations."""
    return LexemeHabit(share, HANDS, Spread(strokes), Spread(offset_s), held)


def profile(lexemes: dict[str, LexemeHabit], tags: dict[str, dict[str, float]], *, per_minute: float = 20.0) -> Profile:
    """A profile with these habits; whatever follows whatever."""
    return Profile(
        name="nobody",
        description="Nobody.",
        annotated_s=60.0,
        gestures=20,
        gestures_per_minute=per_minute,
        tags={tag: TagHabit(10, row) for tag, row in tags.items()},
        lexemes=lexemes,
        follows={},
        hand_follows={},
        units=UnitHabit(1.5, (1.0,), (1.0,)),
        phases=PhaseHabit(Spread(0.4), Spread(0.3), Spread(0.5), Spread(0.3)),
        smoothing=Smoothing(1, 1, 1, 1, 0, 0),
    )


def repertoire(*lexemes: str, lemmas: Sequence[str] = ()) -> Repertoire:
    """Gestures whose strokes take .3 s with either hand, near the body."""
    ends = ArmEnds((0.0, 0.0, 0.0), (0.1, 0.0, 0.0), (0.1, 0.0, 0.0))
    forms = {
        Hand.LEFT: (GestureForm(0.2, 0.1, 0.5, {Hand.LEFT: ends}),),
        Hand.RIGHT: (GestureForm(0.2, 0.1, 0.5, {Hand.RIGHT: ends}),),
    }
    return Repertoire({lexeme: PlayableGesture(forms, 0.3, 0.6, None, frozenset(lemmas)) for lexeme in lexemes})


def line(text: str, *, word_s: float = 0.4, pauses: dict[int, float] | None = None) -> Utterance:
    """A line whose words take `word_s` each from .5 s on, with pauses before some."""
    words, start_s = [], 0.5
    for index, word in enumerate(text.split()):
        start_s = round(start_s + (pauses or {}).get(index, 0.0), 3)
        words.append(Word(index, word, Interval(start_s, round(start_s + word_s, 3))))
        start_s = round(start_s + word_s, 3)
    tokens = tuple(Token(word.index, word.index, word.text, word.text, "X", "X", "dep", 0) for word in words)
    return Utterance(tuple(words), Parse(tokens, (), ()), duration_s=start_s + 1.0)
