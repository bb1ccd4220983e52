"""Reading rule files: blocks, comments, places; and the messages about syntax mistakes, each at its place (`@`)."""

from pathlib import Path

import pytest

from understudy.rules.language.parsing import parse_rules, read_rules
from understudy.rules.language.tree import (
    Alternatives,
    Atom,
    ChooseClause,
    Computation,
    Constant,
    Pattern,
    PredicateTree,
    RuleTree,
    SourcePosition,
)

HERE = Path("here.rules")
MISTAKES = [
    ("rule @\nforeach", "expected the rule's name after `rule`", "the end of the line"),
    ("rule @$x\nforeach", "expected the rule's name after `rule`", "`$x`"),
    ("rule r @priority 4\nforeach", "expected a new line", "`priority`"),
    ("rule r\n  @word($w)", "expected `foreach`", "`word`"),
    ("rule r@", "expected `foreach`", "the end"),
    ("rule r\nforeach\n  word($w @$s)", "expected `,` or `)`", "`$s`"),
    ("rule r\nforeach\n  word(a, $w @$s)", "expected `,` or `)`", "`$s`"),
    ("rule r\nforeach\n  word($w, $s\n@assert\n  word($w)", "expected `,` or `)`", "`assert`"),
    ("rule r\nforeach\n  word($w,@)", "expected an argument", "`)`"),
    ("rule r\nforeach\n  word(a, a|@$x)", "expected a further constant after `|`", "`$x`"),
    ("rule r\nforeach\n  word($w, $s, $e) @word($v)", "expected a new line", "`word`"),
    ("rule r\nforeach\n  word($w)@, word($v)", "expected a new line", "`,`"),
    ("rule r\nforeach\n  $x = 3 @4", "expected a new line (one statement a line) or an operator", "`4`"),
    ("rule r\nforeach\n  unless@\n", "expected a fact after `unless`", "the end of the line"),
    (
        "rule r\nforeach\n  word($w)\n  $x @$y\nassert",
        "expected a new line (one statement a line), `=`, a comparison",
        "`$y`",
    ),
    ("rule r\nforeach\n  word($w)\n@< 3", "expected a fact, `unless`, a computation or a guard, `assert`", "`<`"),
    ("rule r\nforeach\n  word($w)\n  $x ==@\nassert", "expected a value on the right", "the end of the line"),
    ("rule r\nforeach\n  word($w)\n  $x = $y +@\nassert", "expected a value on the right", "the end of the line"),
    ("rule r\nforeach\n  $x = 3 * @/ 4", "expected a value on the right", "`/`"),
    ("rule r\nforeach\n  word($w, $s)\nassert\n  unless @word($w, $s)", "a new line", "`word`"),
    ("rule r\nforeach\n  word($w, $s)\nchoose\n  @nod($s)", "expected `weight NUMBER`", "`nod`"),
    ("rule r\nforeach\n  word($w, $s)\nchoose\n  weight @$x", "expected a number after `weight`", "`$x`"),
    ("rule r\nforeach\n  word($w)\nchoose\n  weight 1 when $x @= 3", "expected a comparison", "`=`"),
    ("rule r\nforeach\n  word($w)\nchoose\n  weight 1 when @\n", "expected a guard", "the end of the line"),
    (
        "rule r\nforeach\n  word($w)\nchoose\n  weight 1 @nod()\n",
        "expected a new line (one statement a line) or `when`",
        "`nod`",
    ),
    ("@predicate (a, b)", "expected `rule NAME` or `predicate NAME(...)`", ""),
    ("predicate p(a @b)", "expected a name and its parameters", "`b`"),
    ("predicate p(@$a)", "expected a name and its parameters", "`$a`"),
    ('rule r\nforeach\n  word(@"a, $s, $e)\nassert', "a text ends on its own line", '`"`'),
    ("rule r\nforeach\n  word(@'a', $s, $e)\nassert", "texts stand in double quotes", "`'`"),
    ("rule r\nforeach\n  word(a, $s, $e)\n  $s @! 3", "`!=` compares", "`!`"),
    ("rule r\nforeach\n  word(a@; b)", "nothing in the language begins with it", "`;`"),
    ("rule r\nforeach\n  @$x\n", "expected a fact such as", ""),
    ("rule r\nforeach\n  @3 + 4\nassert\n word(a)", "expected a fact such as", ""),
    ("rule r\nforeach\n  unless @$x\nassert\n word(a)", "expected a fact such as", ""),
    ("rule r\nforeach\n  word(a)\nassert\n  @$x", "expected a fact to assert", ""),
    ("rule r\nforeach\n  word(a)\nchoose\n  weight 1\n    @nod", "expected a behaviour such as", ""),
    (f"rule r\nforeach\n  $x = {'(' * 59}1 + @(1{')' * 60}", "more than 60 signs in a line", ""),
    (f"rule r\nforeach\n  word($w, $s)\n  $s <= @{'9' * 5000}\nassert\n word(a)", "is beyond 1e+15", "9'"),
    (f"rule r\nforeach\n  word($w)\nchoose\n  weight - @{'9' * 400}\n    nod()", "is beyond 1e+15", "9'"),
    ("@speak($x)\nrule r", "expected `rule NAME` or `predicate NAME(...)`", ""),
]


@pytest.mark.parametrize(("marked", "expected", "found"), MISTAKES)
def test_syntax_mistakes(marked: str, expected: str, found: str) -> None:
    before, _, after = marked.partition("@")
    _, mistakes = parse_rules(before + after, HERE)
    mistake = mistakes[0]
    place = (before.count("\n") + 1, len(before.rpartition("\n")[2]) + 1)
    assert expected in mistake.message
    assert found in mistake.message
    assert (mistake.line, mistake.column) == place
    assert mistake.source_line == (before + after).split("\n")[mistake.line - 1]


def test_a_mistake_hides_none_in_other_blocks() -> None:
    text = "stray\npredicate p(\nrule one\n foreach\n p($x\n\npredicate q(a)\nrule two\nrule three\nforeach\n q($x)\n"
    file, mistakes = parse_rules(text, HERE)
    assert [mistake.line for mistake in mistakes] == [1, 2, 5, 8]
    assert [block.tree.name for block in file.blocks] == ["q", "three"]
    assert file.unread == {"p", "one", "two"}


def test_one_text_under_two_names_has_its_mistakes_under_each() -> None:
    for path in (HERE, HERE.with_name("elsewhere.rules")):
        file, mistakes = parse_rules("stray\nrule one\nforeach\n p($x\n", path)
        assert file.path == path
        assert [(mistake.path, mistake.line) for mistake in mistakes] == [(path, 1), (path, 4)]


def test_every_part_has_its_place() -> None:
    text = '# one\n\n# two\n#  three\nrule r\nforeach\n  p(a|"b c", $x, -1.5,\n    _)\n  $y = $x + 2\n'
    file, mistakes = parse_rules(text, HERE)
    assert not mistakes
    [block] = file.blocks
    assert block.comment == "two\nthree"
    assert block.source == text.partition("three\n")[2].rstrip()
    assert isinstance(block.tree, RuleTree)
    pattern, computation = block.tree.statements
    assert isinstance(pattern, Pattern)
    assert pattern.fact.arguments[0] == Alternatives(("a", "b c"), SourcePosition(7, 5))
    assert pattern.fact.arguments[2] == Constant(-1.5, SourcePosition(7, 19))
    assert [argument.place for argument in pattern.fact.arguments][1:] == [
        SourcePosition(7, 14),
        SourcePosition(7, 19),
        SourcePosition(8, 5),
    ]
    assert isinstance(computation, Computation)
    assert computation.expression.place == SourcePosition(9, 8)


def test_newlines_separate_statements_but_not_arguments() -> None:
    text = "rule r\n\nforeach\n  p(a,  # why\n    b)\n\n  # more\n  q()\nassert p(c, d)\n  q()"
    file, mistakes = parse_rules(text, HERE)
    assert not mistakes
    [block] = file.blocks
    assert isinstance(block.tree, RuleTree)
    assert len(block.tree.statements) == 2


def test_keywords_are_names_where_names_stand() -> None:
    text = "predicate p(rule, max, when max)\nrule foreach\nforeach\n  p(unless, and, $p)\nassert\n  p(max, if, 1)"
    file, mistakes = parse_rules(text, HERE)
    assert not mistakes
    declaration = file.blocks[0].tree
    assert isinstance(declaration, PredicateTree)
    assert [(parameter.name, parameter.merged) for parameter in declaration.parameters] == [
        ("rule", False),
        ("max", False),
        ("when", True),
    ]


def test_weights_guards_and_calls_of_a_choice() -> None:
    choose = "choose\n  weight 0.5 when $x != a and $x != b\n    nod()\n    beat($x)\n  weight 2\n    nod()"
    text = f"rule r\nforeach\n  p($x)\n{choose}"
    file, _ = parse_rules(text, HERE)
    tree = file.blocks[0].tree
    assert isinstance(tree, RuleTree)
    [choice] = tree.conclusions
    assert isinstance(choice, ChooseClause)
    assert [(one.weight, len(one.guards), [call.name for call in one.calls]) for one in choice.alternatives] == [
        (0.5, 2, ["nod", "beat"]),
        (2, 0, ["nod"]),
    ]


def test_texts_may_hold_quotes_and_comment_signs() -> None:
    file, mistakes = parse_rules('rule r\nforeach\n  p("say \\"#1\\"", "\\\\")', HERE)
    assert not mistakes
    tree = file.blocks[0].tree
    assert isinstance(tree, RuleTree)
    pattern = tree.statements[0]
    assert isinstance(pattern, Pattern)
    assert isinstance(pattern.fact, Atom)
    assert [argument.value for argument in pattern.fact.arguments if isinstance(argument, Constant)] == [
        'say "#1"',
        "\\",
    ]


@pytest.mark.parametrize(("content", "said"), [(b"rule \xff", "not UTF-8 text at byte 5"), (None, "cannot be read: ")])
def test_unreadable_files(tmp_path: Path, content: bytes | None, said: str) -> None:
    path = tmp_path / "some.rules"
    if content is not None:
        path.write_bytes(content)
    _, [mistake] = read_rules(path)
    assert mistake.path == path
    assert mistake.message.startswith(said)


@pytest.mark.parametrize("text", ["", "\n# only a comment\n", "\ufeff# with a byte order mark"])
def test_a_file_may_be_empty(tmp_path: Path, text: str) -> None:
    (tmp_path / "empty.rules").write_text(text, encoding="utf-8")
    file, mistakes = read_rules(tmp_path / "empty.rules")
    assert (file.blocks, mistakes) == ((), ())
