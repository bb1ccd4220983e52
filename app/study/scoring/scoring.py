"""The statistics that go with the comparison."""

from ..comparison import Comparison
from .answers import Answers
from .choices import ChoiceStatistics, choice_statistics
from .ratings import RatingStatistics, rating_statistics


def score(answers: Answers) -> RatingStatistics | ChoiceStatistics:
    """The statistics of a study; raises InputError `too_few_answers`."""
    if answers.comparison is Comparison.MODES:
        return rating_statistics(answers.ratings)
    return choice_statistics(answers.verdicts, answers.understood)
