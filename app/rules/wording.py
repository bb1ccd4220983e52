"""What a syntax mistake in a rule file is called: messages in an author's words, each with examples that provoke it.

The examples are parsed when a mistake has happened, and the one that fails in the same state of the parser, if
possible at the same token, gives the message (lark's `match_examples`).
"""

from lark import Lark, UnexpectedCharacters, UnexpectedInput, UnexpectedToken

_HEAD = "rule r\nforeach\n  word($w, $s, $e)\n"

_EXAMPLES = {
    "expected the rule's name after `rule`, letters, digits and underscores": ["rule\n", "rule $x\n", 'rule "x"\n'],
    "expected nothing more after the rule's name": ["rule r s\n", "rule r 4\n", "rule r priority 4\n", "rule r-s\n"],
    "expected `foreach` on the line after the rule's name": ["rule r\nassert\n", "rule r\nword($w)\n", "rule r\n$x\n"],
    "expected a name and its parameters: predicate NAME(argument, argument, priority max)": [
        "predicate\n",
        "predicate p\n",
        "predicate p($x)\n",
        "predicate p(x,)\n",
        "predicate p(x y)\n",
        "predicate p(x max max)\n",
        "predicate p(x) y\n",
    ],
    "expected `,` or `)`: the parenthesis is not closed, or a comma is missing": [
        _HEAD[:-2] + "\nassert\n",
        "rule r\nforeach\n  word($w $s)\n",
        "rule r\nforeach\n  word(a b)\n",
        "rule r\nforeach\n  word(1 2)\n",
        "rule r\nforeach\n  word(_ _)\n",
        "rule r\nforeach\n  word(a|b c)\n",
        "rule r\nforeach\n  word($w, a = b)\n",
    ],
    "expected an argument: a name, a number, a text in quotes, a $variable or `_`": [
        "rule r\nforeach\n  word($w,)\n",
        "rule r\nforeach\n  word(,$w)\n",
        "rule r\nforeach\n  word(a|)\n",
        "rule r\nforeach\n  word(a|$x)\n",
        "rule r\nforeach\n  word($w, <)\n",
    ],
    "expected a fact after `unless`": [
        "rule r\nforeach\n  unless\n",
        "rule r\nforeach\n  unless unless\n",
        "rule r\nforeach\n  unless < 3\n",
    ],
    "expected a comparison (< <= > >= == !=) or, after one $variable, `=`": [
        "rule r\nforeach\n  $x\n  $y == 3\n",
        "rule r\nforeach\n  $x $y\n",
        "rule r\nforeach\n  $x a\n",
    ],
    "expected a value on the right": [
        "rule r\nforeach\n  $x ==\n",
        "rule r\nforeach\n  $x = \n",
        "rule r\nforeach\n  $x = = 3\n",
        "rule r\nforeach\n  $x = $y +\n",
        "rule r\nforeach\n  $x = $y *\n",
        "rule r\nforeach\n  $x < = 3\n",
    ],
    "expected a new line: one statement a line": [
        "rule r\nforeach\n  word($w) word($v)\n",
        "rule r\nforeach\n  word($w) unless word($v)\n",
        "rule r\nforeach\n  word($w), word($v)\n",
        "rule r\nforeach\n  word($w) assert\n",
        "rule r\nforeach\n  word($w) == 3 $x\n",
        "rule r\nforeach\n  $x = 3 4\n",
    ],
    "expected a fact to assert, one a line": [
        _HEAD + "assert\n  unless word($w, $s, $e)\n",
        _HEAD + "assert\n  word($w, $s, $e)\n  foreach\n",
        _HEAD + "assert\n  $x = 3\n",
    ],
    "expected `weight NUMBER` (and perhaps `when GUARD`), with the behaviours on the lines below": [
        _HEAD + "choose\n  nod($s, $e)\n",
        _HEAD + "choose\n  weight\n",
        _HEAD + "choose\n  weight $x\n",
        _HEAD + "choose\n  weight high\n",
        _HEAD + "choose\n  weight 3 nod($s, $e)\n",
        _HEAD + "choose\n  3\n",
    ],
    "expected a guard after `when`, such as $level == high": [
        _HEAD + "choose\n  weight 1 when\n",
        _HEAD + "choose\n  weight 1 when $x\n",
        _HEAD + "choose\n  weight 1 when $x = 3\n",
        _HEAD + "choose\n  weight 1 when $x == 3 and\n",
    ],
}


def syntax_message(parser: Lark, error: UnexpectedInput, text: str) -> str:
    """What was expected where `error` struck; `text` is what was parsed."""
    found = _found(error, text)
    if isinstance(error, UnexpectedCharacters):
        return f"{found}; {_CHARACTERS.get(error.char, 'no part of the language begins so')}"
    message = error.match_examples(parser.parse, _EXAMPLES, use_accepts=False)
    return f"{message or 'no statement of the language goes on so'}, found {found}"


_CHARACTERS = {
    '"': 'a text ends on its own line with `"`, and inside it `"` and `\\` are written `\\"` and `\\\\`',
    "$": "a variable is `$` and a name: $start",
    "=": "`==` compares, and `=` computes a new $variable on a line of its own",
    "!": "`!=` compares, and `unless` excludes",
    "'": 'texts stand in double quotes: "don\'t"',
    "-": "a name has letters, digits and underscores; quote what has others",
}


def _found(error: UnexpectedInput, text: str) -> str:
    if isinstance(error, UnexpectedToken):
        if error.token.type == "$END":
            return "the end of the rule"
        return "the end of the line" if error.token == "\n" else f"`{error.token}`"
    return f"`{text[error.pos_in_stream]}`" if error.pos_in_stream is not None else "the end"
