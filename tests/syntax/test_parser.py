"""A pipeline that is loaded quickly is the pipeline: the same tokens, and a spaCy with all its parts."""

import json
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from importlib.metadata import entry_points
from pathlib import Path

import pytest
import spacy
from spacy.util import registry

from understudy.errors import ServiceError
from understudy.files import resource_folder
from understudy.model import Interval, Parse, Word
from understudy.syntax.parser import LONG_PAUSE_S, Parser, load_pipeline, sentence_starts

PARSER = resource_folder("models") / "parser"


def _in_a_new_process(code: str) -> list[object]:
    """What the code prints, as JSON."""
    printed = subprocess.run([sys.executable, "-c", code], capture_output=True, check=True).stdout
    answer: list[object] = json.loads(printed)
    return answer


def test_the_command_line_is_left_out_and_can_be_imported_afterwards() -> None:
    code = (
        "import json, sys; from pathlib import Path; from understudy.syntax.parser import load_pipeline\n"
        f"load_pipeline(Path({str(PARSER)!r}), without=())\n"
        "import spacy; lean = sorted({'typer', 'requests', 'spacy.cli', 'spacy.cli.info'} & {*sys.modules})\n"
        "version = spacy.info()['spacy_version']; import spacy.cli\n"
        "print(json.dumps([lean, version == spacy.__version__, callable(spacy.cli.setup_cli)]))"
    )
    assert _in_a_new_process(code) == [[], True, True]


def test_a_spacy_that_was_imported_before_stays_as_it_is() -> None:
    code = (
        "import json, sys, spacy, spacy.cli; before = sys.modules['spacy.cli']\n"
        "from pathlib import Path; from understudy.syntax.parser import load_pipeline\n"
        f"load_pipeline(Path({str(PARSER)!r}), without=())\n"
        "print(json.dumps([sys.modules['spacy.cli'] is before]))"
    )
    assert _in_a_new_process(code) == [True]


def test_spacys_registries_find_all_that_is_installed() -> None:
    load_pipeline(PARSER, without=())
    installed = {each.name for each in entry_points(group="spacy_loggers")}
    assert installed
    assert set(registry.loggers.get_entry_points()) == installed


def test_it_cuts_tokens_as_spacy_loads_it() -> None:
    ours, theirs = load_pipeline(PARSER, without=()), spacy.load(PARSER)
    assert ours.tokenizer.to_bytes() == theirs.tokenizer.to_bytes()  # type: ignore[union-attr]
    for text in ("I can't, e.g. in the U.S., y'all're gonna…", "(uh) well-known? :-) 5pm, don't!"):
        assert [token.text for token in ours(text)] == [token.text for token in theirs(text)]
        assert [(token.head.i, token.dep_, token.lemma_) for token in ours(text)] == [
            (token.head.i, token.dep_, token.lemma_) for token in theirs(text)
        ]


MODEL = Path(__file__).resolve().parents[2] / "models" / "parser"
MAX_MODEL_BYTES = 12_000_000
LINES = (
    "I guess not, I think I must've misread all of those signals.",
    "Don't you worry! It's going to be fine.",
    "there's a lot more important things than that",
)


@pytest.fixture(scope="module")
def parser() -> Parser:
    return Parser.load(MODEL)


def _words(text: str) -> tuple[Word, ...]:
    return tuple(Word(index, word) for index, word in enumerate(text.split()))


def _parse(parser: Parser, text: str) -> Parse:
    return parser.parse(_words(text))


def test_the_paper_s_figure_8(parser: Parser) -> None:
    parse = _parse(parser, LINES[0])
    first = {kind: next(phrase for phrase in parse.phrases if phrase.kind == kind) for kind in ("noun", "verb")}
    assert (first["noun"].first, first["noun"].last) == (0, 0)
    assert (first["verb"].first, first["verb"].last) == (1, 1)
    assert (10, 11) in [(phrase.first, phrase.last) for phrase in parse.phrases if phrase.kind == "noun"]
    assert 7 in [clause.head for clause in parse.clauses]


def test_parts_of_a_word_share_its_number(parser: Parser) -> None:
    tokens = _parse(parser, LINES[1]).tokens
    assert [(token.word, token.text) for token in tokens[:4]] == [(0, "Do"), (0, "n't"), (1, "you"), (2, "worry")]
    assert tokens[1].lemma == "not"
    assert [token.index for token in tokens] == list(range(len(tokens)))


def test_words_keep_the_numbers_they_came_with(parser: Parser) -> None:
    later = tuple(Word(word.index + 7, word.text) for word in _words("see you later"))
    assert [token.word for token in parser.parse(later).tokens] == [7, 8, 9]


def test_punctuation_begins_a_sentence(parser: Parser) -> None:
    roots = [token for token in _parse(parser, "Stop. Look at me!").tokens if token.dependency == "root"]
    assert [root.word for root in roots] == [0, 1]


def test_without_words_there_is_nothing(parser: Parser) -> None:
    assert parser.parse(()) == Parse((), (), ())


@pytest.mark.parametrize(
    "text",
    [
        "...",
        "—",
        "😀 😀👍🏽",
        "(" * 5_000,
        "a" * 5_000,
        "don't" * 20,
        "\u200b",
        "e\u0301\u0301 ﷽",
        "' ' '",
        "x " * 400,
    ],
)
def test_odd_words_are_parsed_too(parser: Parser, text: str) -> None:
    parse = _parse(parser, text)
    words = len(text.split())
    assert {token.word for token in parse.tokens} == set(range(words))
    assert all(0 <= phrase.first <= phrase.head <= phrase.last < words for phrase in parse.phrases)
    assert all(0 <= clause.first <= clause.head <= clause.last < words for clause in parse.clauses)
    assert all(0 <= token.head < len(parse.tokens) for token in parse.tokens)


def test_a_parse_does_not_depend_on_what_was_parsed_before_or_beside_it(parser: Parser) -> None:
    expected = {text: Parser.load(MODEL).parse(_words(text)) for text in LINES}
    with ThreadPoolExecutor(4) as pool:
        parses = list(pool.map(lambda text: (text, _parse(parser, text)), LINES * 10))
    assert all(parse == expected[text] for text, parse in parses)


def test_lines_read_together_are_read_as_one_by_one(parser: Parser) -> None:
    lines = [_words(text) for text in (*LINES, "", "uh I I don't")]
    assert parser.parse_all(lines) == tuple(map(parser.parse, lines))
    assert parser.parse_all([]) == ()


def test_the_vocabulary_does_not_grow_with_what_is_read(parser: Parser) -> None:
    vocabulary = parser._pipeline.vocab  # memory held is not visible from outside
    _parse(parser, "warm up")
    before = len(vocabulary.strings)
    _parse(parser, " ".join(f"nonce{number}word" for number in range(50)))
    assert len(vocabulary.strings) == before


def test_the_model_is_small() -> None:
    assert sum(path.stat().st_size for path in MODEL.rglob("*") if path.is_file()) <= MAX_MODEL_BYTES


def test_a_missing_pipeline_is_named(tmp_path: Path) -> None:
    for where in (tmp_path / "nothing", tmp_path, "no_such_pipeline"):
        with pytest.raises(ServiceError) as caught:
            Parser.load(where)
        assert caught.value.code == "parser_missing"
        assert str(where) in caught.value.message
        assert "\n" not in caught.value.message


@pytest.mark.parametrize("damaged", ["config.cfg", "parser/model", "tagger/cfg", "trainable_lemmatizer/trees"])
def test_a_damaged_pipeline_is_named(tmp_path: Path, damaged: str) -> None:
    shutil.copytree(MODEL, tmp_path / "parser")
    (tmp_path / "parser" / damaged).unlink()
    with pytest.raises(ServiceError) as caught:
        Parser.load(tmp_path / "parser")
    assert caught.value.code == "parser_missing"
    assert "\n" not in caught.value.message


def test_a_pipeline_without_known_labels_is_refused(tmp_path: Path) -> None:
    spacy.blank("en").to_disk(tmp_path)
    with pytest.raises(ServiceError) as caught:
        Parser.load(tmp_path)
    assert caught.value.code == "parser_labels"


def test_a_pipeline_without_lemmas_is_refused(tmp_path: Path) -> None:
    nlp = spacy.load(MODEL)
    nlp.remove_pipe("trainable_lemmatizer")
    nlp.to_disk(tmp_path)
    with pytest.raises(ServiceError, match="lemmas") as caught:
        Parser.load(tmp_path)
    assert caught.value.code == "parser_incomplete"


@pytest.mark.parametrize(
    ("text", "starts"),
    [
        ("Hello there", {0}),
        ("Hello. How are you? Fine!", {0, 1, 4}),
        ("“Stop!” he said.", {0, 1}),
        ("I saw Dr. Who and J. Smith. They left.", {0, 7}),
        ("No. I mean it.", {0, 1}),
        ("well... maybe not", {0}),
        ("Well... Maybe not", {0, 1}),
        ("I know… “Maybe not", {0, 2}),
        ("yeah. i know", {0, 1}),
        ("Hello . How are you", {0, 2}),
    ],
)
def test_sentences_begin_after_marks_that_end_one(text: str, starts: set[int]) -> None:
    assert sentence_starts(tuple(Word(index, word) for index, word in enumerate(text.split()))) == starts


def _spoken(text: str, pause_after: int, pause_s: float) -> tuple[Word, ...]:
    words, now_s = [], 0.0
    for index, word in enumerate(text.split()):
        words.append(Word(index, word, Interval(now_s, now_s + 0.25)))
        now_s += 0.25 + (pause_s if index == pause_after else 0.0)
    return tuple(words)


def test_an_unpunctuated_line_is_cut_at_long_pauses_alone() -> None:
    assert sentence_starts(_spoken("yeah right i guess so", 1, LONG_PAUSE_S)) == {0, 2}
    assert sentence_starts(_spoken("yeah right i guess so", 1, LONG_PAUSE_S / 2)) == {0}


def test_a_pause_in_a_punctuated_line_is_a_hesitation() -> None:
    assert sentence_starts(_spoken("Yeah, right, I guess so.", 1, 2 * LONG_PAUSE_S)) == {0}


def test_no_words_have_no_sentences() -> None:
    assert sentence_starts(()) == frozenset()
