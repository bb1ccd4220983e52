"""Which of two speakers a gesture script is by: a classifier on the script alone, trained on other lines.

Features of a script: shares of lexemes and of hands, gestures a second, strokes a gesture, gestures a unit, and how
large they are; without lexemes, without sizes, and hands alone for what each carries. Lines on which either speaker
makes no gesture are left out.
"""

from collections.abc import Sequence

import numpy as np
from sklearn.linear_model import LogisticRegression
from sklearn.pipeline import make_pipeline
from sklearn.preprocessing import StandardScaler

from understudy.model import FloatArray, Hand
from understudy.profiles.generation.script import GestureScript

GROUPS = ("lexemes", "hands", "manner", "size")


def features(script: GestureScript, lexemes: Sequence[str], groups: Sequence[str]) -> list[float]:
    """The features of a script that has a gesture."""
    made = script.made
    seconds = made[-1].end_s - made[0].start_s
    found = {
        "lexemes": [sum(each.lexeme == name for each in made) / len(made) for name in lexemes],
        "hands": [sum(each.hand is hand for each in made) / len(made) for hand in Hand],
        "manner": [
            len(made) / seconds,
            float(np.mean([len(each.strokes) for each in made])),
            len(made) / len(script.units),
        ],
        "size": [float(np.mean([each.amount or 0.5 for each in made]))],
    }
    return [value for group in groups for value in found[group]]


def accuracy(one: Sequence[GestureScript], other: Sequence[GestureScript], groups: Sequence[str]) -> tuple[float, int]:
    """The share of scripts of every second line that is told rightly after the others were learnt, and their number."""
    pairs = [pair for pair in zip(one, other, strict=True) if pair[0].made and pair[1].made]
    lexemes = sorted({each.lexeme for pair in pairs for script in pair for each in script.made})
    x = np.array([features(script, lexemes, groups) for pair in pairs for script in pair])
    y = np.tile([0, 1], len(pairs))
    even = np.repeat(np.arange(len(pairs)) % 2 == 0, 2)
    right: FloatArray = np.concatenate(
        [_right(x[even], y[even], x[~even], y[~even]), _right(x[~even], y[~even], x[even], y[even])]
    )
    return float(right.mean()), len(right)


def _right(x: FloatArray, y: FloatArray, test_x: FloatArray, test_y: FloatArray) -> FloatArray:
    model = make_pipeline(StandardScaler(), LogisticRegression(C=1.0, max_iter=1000)).fit(x, y)
    return np.asarray(model.predict(test_x) == test_y, float)
