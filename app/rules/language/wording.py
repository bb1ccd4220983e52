"""Words the messages about syntax mistakes in rule files: what was expected, and what was found."""

from lark import Token, UnexpectedCharacters, UnexpectedInput, UnexpectedToken

_ARGUMENT = "an argument: a name, a number, a text in quotes, a $variable or `_`"
_VALUE = "a value on the right: a name, a number, a text in quotes, a $variable or a computation"
_GUARD = "a guard, such as $level == high"
_PARAMETERS = "a name and its parameters: predicate NAME(argument, argument, priority max)"

_AFTER = {
    "_RULE": "the rule's name after `rule`: letters, digits and underscores",
    "_PREDICATE": _PARAMETERS,
    "_UNLESS": "a fact after `unless`, such as word(no, $start, _)",
    "LPAR": _ARGUMENT,
    "COMMA": _ARGUMENT,
    "VBAR": "a further constant after `|`: a name, a number or a text in quotes",
    "EQUAL": _VALUE,
    "COMPARISON": _VALUE,
    "PLUS": _VALUE,
    "MINUS": _VALUE,
    "STAR": _VALUE,
    "SLASH": _VALUE,
    "WEIGHT": "a number after `weight`",
    "_WHEN": _GUARD,
    "_AND": _GUARD,
}
"""What must follow a terminal of the grammar."""

_WORDS = {
    "_NEWLINE": "a new line (one statement a line)",
    "_FOREACH": "`foreach` below the rule's name",
    "_UNLESS": "a fact, `unless`, a computation or a guard",
    "WEIGHT": "`weight NUMBER`, `always` or `never` with behaviours on the lines below",
    "COMMA": "`,`",
    "RPAR": "`)`",
    "EQUAL": "`=`",
    "COMPARISON": "a comparison (< <= > >= == !=)",
    "PLUS": "an operator (+ - * /)",
    "_WHEN": "`when`",
    "_AND": "`and`",
    "ASSERT": "`assert`",
    "CHOOSE": "`choose`",
}
"""Descriptions of expected terminals, in the order in which they are listed; others are described by their
neighbours."""

_CHARACTERS = {
    '"': 'a text ends on its own line with `"`, and inside it `"` and `\\` are written `\\"` and `\\\\`',
    "$": "a variable is `$` and a name: $start",
    "!": "`!=` compares, and `unless` excludes",
    "'": 'texts stand in double quotes: "don\'t"',
}


def syntax_message(error: UnexpectedInput, text: str) -> str:
    """What was expected at `error`; `text` is the block that was parsed."""
    if isinstance(error, UnexpectedCharacters):
        hint = _CHARACTERS.get(error.char, "nothing in the language begins with it")
        return f"found `{error.char}`; {hint}"
    if isinstance(error, UnexpectedToken):
        in_rule = not text.lstrip().startswith("predicate")
        return f"expected {_expected(error) if in_rule else _PARAMETERS}; found {_found(error.token)}"
    return "the rule ends too early"


def _expected(error: UnexpectedToken) -> str:
    previous = error.state.value_stack[-1] if error.state.value_stack else None
    if isinstance(previous, Token) and previous.type in _AFTER:
        return _AFTER[previous.type]
    accepted = error.accepts or error.expected
    if {"COMMA", "RPAR"} <= accepted:
        return "`,` or `)`: a comma is missing, or the parenthesis is not closed"
    words = [word for terminal, word in _WORDS.items() if terminal in accepted]
    return " or ".join(filter(None, [", ".join(words[:-1]), *words[-1:]]))


def _found(token: Token) -> str:
    if token.type == "$END":
        return "the end of the rule"
    return "the end of the line" if token == "\n" else f"`{token}`"
