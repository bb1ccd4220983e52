"""The shipped function rules, on real parses: each sense is found, and not in similar sentences."""

import pytest

from tests.support.shipped_rules import found, shipped_rules
from tests.support.words.utterances import utterance
from understudy.rules.derivation import derive_functions

AFFIRMATION = [
    ("Okay, that works.", [("plain", "Okay,")]),
    ("Oh, all right, I'll go.", [("plain", "all right,")]),
    ("Sure. Take it.", [("plain", "Sure.")]),
    ("Well, of course he did.", [("plain", "of course")]),
    ("right we did that", [("plain", "right")]),
    ("Are you okay?", []),
    ("I am not sure.", []),
    ("Turn right here.", []),
    ("Can do.", [("plain", "Can do.")]),
    ("Will do, thanks.", [("plain", "Will do,")]),
    ("What they can do is small.", []),
]
NEGATION = [
    ("No, I don't.", [("plain", "No,"), ("plain", "don't.")]),
    ("They left without him.", [("plain", "without")]),
    ("Not at all!", [("plain", "Not at all!")]),
    ("No wonder it broke.", []),
    ("You like it, don't you?", []),
    ("No-no, keep it.", [("plain", "No-no,")]),
    ("Talking there is a no-no.", []),
    ("Are you coming or not?", [("plain", "not?")]),
    ("It is not only old but also ugly.", []),
]
INTERROGATIVE = [
    ("How many people came?", [("wh", "How many people")]),
    ("So, what are you doing?", [("wh", "what")]),
    ("You did what?", [("wh", "what?")]),
    ("Do you know him?", [("polar", "Do you know him?")]),
    ("You told her?", [("polar", "You told her?")]),
    ("did you see him", [("polar", "did you see him")]),
    ("It's late, isn't it?", [("tag", "isn't it?")]),
    ("You like it, right?", [("tag", "right?")]),
    ("I wonder if he knows.", [("indirect", "if")]),
    ("Tell me where he is.", [("indirect", "where")]),
    ("no why", [("wh", "why")]),
    ("oh who cut the grass", [("wh", "who")]),
    ("it was raining what is that noise", [("wh", "what")]),
    ("they left early are you coming", [("polar", "are you coming")]),
    ("that was me right", [("tag", "right")]),
    ("the problem is it costs too much", []),
    ("turn right", []),
    ("I know what is right", [("indirect", "what")]),
    ("What a day!", []),
    ("So do I.", []),
    ("The man who came left again.", []),
    ("Only when it rains does the roof leak.", []),
    ("Never have I seen such a mess.", []),
    ("Not once did she complain.", []),
    ("Don't you dare open that letter!", []),
    ("Don't you want some soup?", [("polar", "Don't you want some soup?")]),
    ("Had we left earlier, we would have caught it.", []),
    ("Were he here, he would laugh.", []),
    ("Am I hungry!", []),
    ("May she rest in peace.", []),
    ("The woman who runs the shop moved away.", []),
    ("We met a couple who did that for years.", []),
    ("I have a cousin who's a pilot.", []),
    ("How tall is he?", [("wh", "How")]),
    ("What kind of bread does he like?", [("wh", "What kind of")]),
    ("I forgot, what was the price?", [("wh", "what")]),
    ("If it snows, will you stay?", [("polar", "will you stay?")]),
    ("Could you hold this, I want to sit down.", [("polar", "Could you hold this,")]),
]
CONTRAST = [
    ("I called, but nobody came.", [("plain", "but")]),
    ("Rather than wait, go.", [("plain", "Rather than")]),
    ("They want no other friends than them.", [("plain", "other friends than")]),
    ("They have nothing but trouble.", []),
    ("The house is small, yet it is bright.", [("plain", "yet")]),
    ("Poor and yet proud.", [("plain", "yet")]),
    ("They haven't called yet.", []),
    ("The worst is yet to come.", []),
    ("It is not only small but also dark.", []),
    ("It is not small but dark.", [("plain", "but")]),
]
PROCESS = [
    ("They began to run.", [("start", "began")]),
    ("He kept talking.", [("continue", "kept")]),
    ("Keep it going.", [("continue", "Keep")]),
    ("She is still here.", [("continue", "still")]),
    ("We are done.", [("stop", "done.")]),
    ("The show is over.", [("stop", "over.")]),
    ("She got angry.", [("change", "got angry.")]),
    ("It turned into ice.", [("change", "turned into")]),
    ("He is over there.", []),
    ("Keep the money.", []),
]
QUANTIFICATION = [
    ("They had a lot of luck.", [("many", "a lot of")]),
    ("There was no time.", [("none", "no")]),
    ("Most people left.", [("many", "Most")]),
    ("I counted two hundred and fifty men.", [("number", "two hundred and fifty")]),
    ("It rose five to ten percent.", [("number", "five to ten")]),
    ("One of them left.", [("number", "One")]),
    ("They have little time.", [("few", "little")]),
    ("The other one left.", []),
    ("Come at six.", []),
    ("Come at six thirty.", []),
    ("Thank you so much for coming.", []),
    ("Take plan B.", []),
    ("One day he will understand.", []),
    ("He works one day a week.", [("number", "one")]),
]
COMPARISON = [
    ("This is more important.", [("positive", "more important.")]),
    ("This is a lot more important.", [("strong_positive", "a lot more important.")]),
    ("He is worse.", [("negative", "worse.")]),
    ("They are as big as us.", [("equal", "as big as")]),
    ("It was the best day.", [("superlative", "the best")]),
    ("It was the most beautiful day.", [("superlative", "the most beautiful")]),
    ("You had better go.", []),
    ("He is no longer here.", []),
    ("At least he came.", []),
]
SPATIAL = [
    ("He ran up the hill.", [("up", "up")]),
    ("She looked through the window.", [("through", "through")]),
    ("They cut it down.", [("down", "down.")]),
    ("He went away.", [("away", "away.")]),
    ("Don't give up.", []),
    ("I figured it out.", []),
    ("He stood behind me.", [("back", "behind")]),
    ("He raised his right hand.", [("right", "right")]),
    ("He lives over by the lake.", [("plain", "over by")]),
    ("I am so over it.", []),
    ("Clean that mess up.", []),
    ("Where is the remote control?", []),
    ("Calm down.", []),
    ("Go straight ahead.", [("front", "straight ahead.")]),
]
PHYSICAL = [
    ("It is a huge problem.", [("big", "huge")]),
    ("That took longer.", [("long", "longer.")]),
    ("A little boy came.", [("small", "little")]),
    ("It is a compact car.", [("small", "compact")]),
    ("The firm pays well.", []),
    ("As long as he stays, go.", []),
    ("He is a little late.", []),
    ("They pushed very hard.", [("hard", "hard.")]),
    ("It is hard to say.", []),
    ("We sat at the Round Table.", []),
    ("He bought a grand piano.", []),
    ("A box of that size.", [("big", "size.")]),
]
MENTAL = [
    ("I don't know why.", [("unsure", "don't know")]),
    ("He is not sure.", [("unsure", "not sure.")]),
    ("I don't think so.", [("think", "think")]),
    ("She likes him.", [("feel", "likes")]),
    ("I find it strange.", [("think", "find")]),
    ("I'd like to go.", [("want", "like")]),
    ("I don't get it.", [("know", "don't get it.")]),
    ("I'm sick of this.", [("feel", "sick of")]),
    ("Make sure it works.", []),
    ("He was, you know, tall.", []),
    ("Certain people never learn.", [("know", "learn.")]),
    ("I am certain of it.", [("know", "certain")]),
]
PERFORMANCE = [
    ("It was, um, late.", [("hesitation", "um,")]),
    ("He was, you know, tall.", [("filler", "you know,")]),
    ("It was, like, huge.", [("filler", "like,")]),
    ("They could like, run.", [("filler", "like,")]),
    ("He paid the bill, well we paid it.", [("filler", "well")]),
    ("He did well, I think.", []),
    ("My, my brother came.", [("repeat", "My, my")]),
    ("It was, it was probably late.", [("repeat", "It was, it was")]),
    ("It, uh, it fell.", [("repeat", "It, uh, it"), ("hesitation", "uh,")]),
    ("I couldn't, you couldn't do it.", [("repair", "I couldn't,")]),
    ("They're getting, they're slowly getting old.", [("repair", "They're getting,")]),
    ("They don't have a, any program.", [("repair", "a,")]),
    ("Let me see, it was late.", [("search", "Let me see,")]),
    ("No, no, no!", []),
    ("Do you know him?", []),
    ("She looks like him.", []),
    ("Very, very good.", []),
    ("I-I forgot it.", [("repeat", "I-I")]),
    ("Th-they left.", [("repeat", "Th-they")]),
    ("Wait-wait, listen.", []),
    ("Look at it! It moves.", []),
]
DEIXIS = [
    ("I saw my old friend.", [("self", "I"), ("self", "my old friend.")]),
    ("You and your dog.", [("addressee", "You"), ("addressee", "your dog.")]),
    ("Our own babies slept.", [("inclusive", "Our own babies")]),
    ("Those people left.", [("distal", "Those"), ("distal", "Those people")]),
    ("This is it.", [("proximal", "This")]),
    ("Come here.", [("place", "here.")]),
    ("There is time.", []),
    ("He said that he left.", []),
    ("He was, you know, tall.", []),
    ("We live there.", [("inclusive", "We"), ("place", "there.")]),
]
MODAL = [
    ("He can't swim.", [("ability", "can't")]),
    ("It can't be Joey.", [("likelihood", "can't be")]),
    ("They had to leave.", [("obligation", "had to")]),
    ("Maybe he left.", [("likelihood", "Maybe")]),
    ("Can I go?", [("permission", "Can")]),
    ("He opened the can.", []),
    ("He will go.", []),
    ("Can do.", []),
]
INTENSIFIER = [
    ("It was so good.", [("plain", "so")]),
    ("He is kind of tall.", [("plain", "kind of")]),
    ("There was too much noise.", [("plain", "too")]),
    ("It is way better.", [("plain", "way")]),
    ("He is a little late.", [("plain", "a little")]),
    ("So he left.", []),
    ("What kind of man is he?", []),
    ("Really?", []),
    ("A little boy came.", []),
]
VALENCE = [
    ("What a beautiful day.", [("positive", "beautiful")]),
    ("That was a stupid mistake.", [("negative", "stupid"), ("negative", "mistake.")]),
    ("He is a hypocrite.", [("negative", "hypocrite.")]),
    ("They messed it up.", [("negative", "messed")]),
    ("He drives a white car.", []),
    ("Good morning.", []),
    ("I mean it.", []),
    ("The village lies in a valley.", []),
    ("He lies about his age.", [("negative", "lies")]),
    ("The mean temperature rose.", []),
    ("A mean old man.", [("negative", "mean")]),
    ("Price wise it works.", []),
]

TABLE = {
    "affirmation": AFFIRMATION,
    "negation": NEGATION,
    "interrogative": INTERROGATIVE,
    "contrast": CONTRAST,
    "process": PROCESS,
    "quantification": QUANTIFICATION,
    "comparison": COMPARISON,
    "spatial": SPATIAL,
    "physical": PHYSICAL,
    "mental": MENTAL,
    "performance": PERFORMANCE,
    "deixis": DEIXIS,
    "modal": MODAL,
    "intensifier": INTENSIFIER,
    "valence": VALENCE,
}


@pytest.mark.parametrize(
    ("class_name", "text", "expected"),
    [(class_name, text, expected) for class_name, rows in TABLE.items() for text, expected in rows],
)
def test_functions_are_found_where_they_are_and_not_where_they_are_not(
    class_name: str, text: str, expected: list[tuple[str, str]]
) -> None:
    assert found(text, class_name) == expected


def test_every_rule_says_its_sense() -> None:
    assert [rule.name for rule in shipped_rules().program.rules if not rule.comment] == []


def test_the_rules_speak_of_all_sixteen_classes() -> None:
    asserted = {
        mention.arguments[0]
        for rule in shipped_rules().program.rules
        for mention in rule.asserts
        if mention.predicate == "fcn" and not mention.arguments[0].startswith("$")
    }
    assert {*TABLE, "emphasis"} <= asserted
    assert len(shipped_rules().program.rules) >= 150


def test_the_same_line_gives_the_same_functions_with_words_alone() -> None:
    spoken = utterance("no no no", "0:no/no/INTJ 1:no/no/INTJ 2:no/no/INTJ")
    assert derive_functions(shipped_rules(), spoken) == derive_functions(shipped_rules(), spoken)
    assert len(derive_functions(shipped_rules(), spoken)) == 3


def test_a_line_of_nothing_but_numbers_stays_within_the_limits_of_the_chainer() -> None:
    spoken = utterance("two " * 600, " ".join(f"{index}:two/two/NUM" for index in range(600)))
    functions = derive_functions(shipped_rules(), spoken)
    kept = [found for found in functions if found.kept and found.class_name == "quantification"]
    assert {word for found in kept for word in range(found.first, found.last + 1)} == set(range(600))
