"""Learns a speaker's profile from annotations (NGS §3.2).

The counts are the paper's: P(g∣s) over affiliates, bigrams of lexemes and of hands, P(hand∣g), a lexeme's strokes and
its distance to its word, the rate. Our additions are the smoothing (`tables`), the shrinkage of a rare lexeme's means
towards the speaker's overall ones, and a distance between units that is learned from the speaker, as the paper
suggests. Remarks report scarce or missing data.
"""

from collections import Counter
from collections.abc import Collection, Iterator, Sequence

from ...errors import InputError
from ...model import Hand, Notice
from ..annotation.model import Annotation
from ..profile import FIRST, Profile, Smoothing
from ..segments import spoken_s
from .habits import database_of, form_habits, head_habit, lexeme_habits, phase_habit, rest_habit, unit_habit
from .observations import all_of
from .tables import rows_of, shares_of, tag_table

FEWEST_GESTURES = 10
"""The minimum number of gestures."""


def learn(annotations: Sequence[Annotation], name: str, description: str = "") -> Profile:
    """The profile of the speaker of these annotations, whose tags must be known.

    Raises InputError `too_few_gestures`.
    """
    gestures, tags = all_of(annotations)
    _check_enough(len(gestures))
    seconds = sum(spoken_s(each.words, each.segments) for each in annotations)
    hand_counts = Counter(each.phrase.hand for each in gestures)
    hand_share = shares_of({hand: hand_counts[hand] + 1.0 for hand in Hand})
    lexeme_share = shares_of(Counter(each.phrase.lexeme for each in gestures))
    table = tag_table(tags)
    follows = rows_of([(each.before, each.phrase.lexeme) for each in gestures], lexeme_share)
    hands = rows_of([(each.phrase.lexeme, each.phrase.hand) for each in gestures], hand_share)
    hand_follows = rows_of([(each.hand_before or FIRST, each.phrase.hand) for each in gestures], hand_share)
    return Profile(
        name=name,
        description=description or f"Learnt from {len(gestures)} gestures in {seconds / 60:.1f} minutes of speech.",
        annotated_s=seconds,
        gestures=len(gestures),
        gestures_per_minute=60 * len(gestures) / seconds,
        tags=table.tags,
        lexemes=lexeme_habits(gestures, hands.rows),
        follows=follows.rows,
        hand_follows=hand_follows.rows,
        units=unit_habit(annotations, gestures),
        phases=phase_habit(annotations),
        smoothing=Smoothing(
            tags=table.strength,
            sequence=follows.strength,
            hands=hands.strength,
            hand_sequence=hand_follows.strength,
            held_out=table.held_out,
            blind=table.blind,
        ),
        rests=rest_habit(annotations),
        head=head_habit(annotations, seconds),
        forms=form_habits(gestures),
        database=database_of(gestures),
    )


def _check_enough(gestures: int) -> None:
    if gestures < FEWEST_GESTURES:
        message = f"{gestures} gestures are annotated; a profile is learnt from {FEWEST_GESTURES} or more"
        raise InputError("too_few_gestures", message, field="annotation")


FEW_GESTURES = 100
"""With fewer gestures the profile is doubtful. The lexeme distribution of 25 consecutive gestures of the examples
differs from that of all by a quarter (the share that would have to be moved), of 50 by an eighth, of 100 by one in
twenty (`docs/measurements/profiles.md`). NGS had about 200 gestures per speaker, in nine minutes."""


def doubts(profile: Profile, annotations: Sequence[Annotation], postures: Collection[str]) -> Iterator[Notice]:
    """The remarks on a profile learned from these annotations; `postures` are the postures that bodies can take."""
    for each in annotations:
        if each.unread:
            message = f"{each.path}: tracks that are not read: {', '.join(each.unread)}"
            yield Notice("annotation_tracks_unread", message)
    unknown = [each for each in profile.head.postures if each not in postures]
    if unknown:
        message = f"unknown postures: {', '.join(unknown)}; there are {', '.join(postures)}"
        yield Notice("annotation_postures_unknown", message)
    if profile.gestures < FEW_GESTURES:
        message = (
            f"{profile.gestures} gestures in {profile.annotated_s / 60:.1f} minutes of speech are too few to know a "
            "speaker well: rare habits are guessed from common ones; annotate about nine minutes"
        )
        yield Notice("annotation_short", message)
    if profile.smoothing.held_out <= profile.smoothing.blind:
        message = "the tags do not predict the gestures: held-out gestures were as likely with any tag"
        yield Notice("profile_tags_tell_nothing", message)
