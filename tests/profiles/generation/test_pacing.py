"""That gestures are spread over a text as the speaker's rate has it."""

from collections import Counter

from tests.support.words.scripted import habit, line, profile, repertoire
from understudy.profiles.annotation.model import TaggedWords
from understudy.profiles.generation.generating import Speaker, generate

WORDS, SEGMENTS = 20, 12


def test_every_segment_has_what_its_time_allots() -> None:
    """A word takes .4 s, a segment 8 s, its pause 1 s: at 20 gestures a minute that is 3, and 2.67 for the
    first, without a pause. One gesture at most is made up for others."""
    words = WORDS * SEGMENTS
    speaker = profile({"A": habit(1.0)}, {"any": {"A": 0.5}}, per_minute=20)
    text = line(" ".join("x" for _each in range(words)), pauses=dict.fromkeys(range(WORDS, words, WORDS), 1.0))
    tags = [TaggedWords("x", word, word) for word in range(words)]
    for seed in range(5):
        made = generate(Speaker(speaker, repertoire("A"), seed), text, tags).made
        in_segment = Counter(each.word // WORDS for each in made)
        assert all(1 <= in_segment[segment] <= 4 for segment in range(SEGMENTS))
        assert abs(len(made) - 20 * (8 * SEGMENTS + SEGMENTS - 1) / 60) < 2
