"""Rules about discourse and dialogue acts: found, and not in similar sentences."""

import pytest

from tests.support.shipped_rules import found

ENUMERATION = [
    ("First, we pack. Then we leave. Finally, we rest.", [("first", "First,"), ("next", "Then"), ("last", "Finally,")]),
    ("First of all, he lied.", [("first", "First of all,")]),
    ("Then we left.", []),
    ("He finally left.", []),
    ("The first man left.", []),
]
TOPIC_SHIFT = [
    ("By the way, he left.", [("new", "By the way,")]),
    ("Anyway, I left.", [("return", "Anyway,")]),
    ("As I was saying, he left.", [("return", "As I was saying,")]),
    ("I'll do it anyway.", []),
    ("We were talking about him.", []),
    ("You know what? Let us go.", [("new", "You know what?")]),
    ("Guess what, he called.", [("new", "Guess what,")]),
    ("Do you know what he wants?", []),
    ("You know what I mean.", []),
    ("They know what! But you left.", []),
]
PARENTHESIS = [
    ("My brother (he is older) came.", [("plain", "(he is older)")]),
    ("My brother - he is much older - came.", [("plain", "he is much older")]),
    ("He is, so to speak, my brother.", [("plain", "so to speak,")]),
    ("I- I- I saw him.", []),
]
QUOTING = [
    ("She was like, no way.", [("introduction", "was like,")]),
    ("And I was like oh my god.", [("introduction", "was like")]),
    ("He said that he would come.", [("introduction", "said")]),
    ('He said, "Never again!"', [("introduction", "said,"), ("words", '"Never again!"')]),
    ("She was like a mother to me.", []),
    ("He said hello.", []),
    ("Truth be told, I never liked it.", []),
]
GREETING = [
    ("Hello, Joey.", [("plain", "Hello,")]),
    ("Good morning!", [("plain", "Good morning!")]),
    ("I said hello to her.", []),
    ("You're welcome.", []),
    ("Hi, how are you?", [("plain", "Hi,"), ("plain", "how are you?")]),
    ("How do you do that so fast?", []),
    ("How are you getting home?", []),
]
PARTING = [("Okay, see you later.", [("plain", "see you later.")]), ("I see you.", [])]
THANKS = [("Thank you so much.", [("plain", "Thank you so much.")]), ("Thanks to him we won.", [])]
APOLOGY = [
    ("I'm sorry, I forgot.", [("plain", "I'm sorry,")]),
    ("Excuse me.", [("plain", "Excuse me.")]),
    ("She is sorry.", []),
    ("I feel sorry for him.", []),
    ("I must apologise for the noise.", [("plain", "I must apologise")]),
    ("Listen, I'm sorry about that.", [("plain", "sorry about that.")]),
]
POLITENESS = [
    ("Please sit down.", [("plain", "Please")]),
    ("Would you mind opening it?", [("plain", "Would you mind")]),
    ("Could you help me?", [("plain", "Could you")]),
    ("You could help me.", []),
]
HEDGING = [
    ("I think it is fine, or something like that.", [("plain", "I think"), ("plain", "or something like that.")]),
    ("As far as I know, he left.", [("plain", "As far as I know,")]),
    ("What kind of man is he?", []),
]
OBLIGATION = [
    ("I must go.", [("self", "must")]),
    ("You have to stay.", [("addressee", "have to")]),
    ("We ought to talk.", [("inclusive", "ought to")]),
    ("He should leave.", [("other", "should")]),
    ("I can go.", []),
    ("I must apologise.", []),
    ("I have to admit it is good.", []),
    ("We are just going to have to wait.", [("inclusive", "have to")]),
    ("You always have to shout.", [("addressee", "have to")]),
]
INCLUSION = [
    ("All of us came together.", [("everyone", "All of us"), ("together", "together.")]),
    ("Let's go.", [("joining", "Let's")]),
    ("He put it together.", []),
    ("The United Nations met.", []),
]
TABLE = {
    "enumeration": ENUMERATION,
    "topic_shift": TOPIC_SHIFT,
    "parenthesis": PARENTHESIS,
    "quoting": QUOTING,
    "greeting": GREETING,
    "parting": PARTING,
    "thanks": THANKS,
    "apology": APOLOGY,
    "politeness": POLITENESS,
    "hedging": HEDGING,
    "obligation": OBLIGATION,
    "inclusion": INCLUSION,
}


@pytest.mark.parametrize(
    ("class_name", "text", "expected"),
    [(class_name, text, expected) for class_name, rows in TABLE.items() for text, expected in rows],
)
def test_discourse_is_found_where_it_is_and_not_where_it_is_not(
    class_name: str, text: str, expected: list[tuple[str, str]]
) -> None:
    assert found(text, class_name) == expected
