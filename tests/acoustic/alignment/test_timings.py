"""Words timed elsewhere are matched to the transcript, mistakes are reported, and what is written can be read again."""

import json

import pytest

from understudy.acoustic.alignment.timings import read_fillers, read_timings, to_ctm, to_textgrid
from understudy.errors import InputError, UndecodableError, UnsupportedFormatError
from understudy.model import Filler, Interval, Phone, Word
from understudy.text.transcript import read_transcript

DURATION_S = 2.0
TEXT = 'Oh, "no" — naïve'


def _words(text: str = TEXT) -> tuple[Word, ...]:
    return read_transcript(text, max_characters=1000)


def _timed() -> tuple[Word, ...]:
    oh, no, dash, naive = _words()
    return (
        Word(oh.index, oh.text, Interval(0.1, 0.25), (Phone("OW", Interval(0.1, 0.25)),)),
        Word(
            no.index,
            no.text,
            Interval(0.25, 0.777),
            (Phone("N", Interval(0.25, 0.4)), Phone("OW", Interval(0.4, 0.777))),
        ),
        dash,
        Word(naive.index, naive.text, Interval(1.0, 2.0)),
    )


def _json(words: list[dict[str, object]]) -> bytes:
    return json.dumps({"words": words}).encode()


def _read_json(*words: dict[str, object]) -> tuple[Word, ...]:
    return read_timings(_json(list(words)), "json", _words("one two"), duration_s=DURATION_S)


def test_json_of_align_is_read_with_phones_and_unspoken_words() -> None:
    phones = [{"label": "OW", "start_s": 0.1, "end_s": 0.25, "stress": 1}]
    content = _json(
        [
            {"index": 0, "text": "Oh,", "start_s": 0.1, "end_s": 0.25, "phones": phones},
            {"index": 1, "text": '"no"', "start_s": 0.25, "end_s": 0.777},
            {"index": 2, "text": "—", "phones": []},
            {"index": 3, "text": "naive", "start_s": 1, "end_s": 2, "confidence": 0.5},
        ]
    )
    words = read_timings(content, "json", _words(), duration_s=DURATION_S)
    assert [word.text for word in words] == ["Oh,", '"no"', "—", "naïve"]
    assert words[0].phones == (Phone("OW", Interval(0.1, 0.25), 1),)
    assert words[2].interval is None
    assert words[3].interval == Interval(1.0, 2.0)


def test_textgrid_reads_back_what_was_written() -> None:
    written = to_textgrid(_timed(), DURATION_S)
    assert read_timings(written.encode(), "textgrid", _words(), duration_s=DURATION_S) == _timed()
    assert read_timings(written.encode("utf-16"), "textgrid", _words(), duration_s=DURATION_S) == _timed()


def test_ctm_reads_back_words_to_the_millisecond() -> None:
    written = to_ctm(_timed(), "my line.wav")
    assert written.splitlines()[0] == "my_line.wav 1 0.100 0.150 Oh,"
    read = read_timings(written.encode(), "ctm", _words(), duration_s=DURATION_S)
    assert [word.interval for word in read] == [word.interval for word in _timed()]


def test_textgrid_of_other_tools_short_form_with_stress_digits_and_silences() -> None:
    content = """File type = "ooTextFile"
Object class = "TextGrid"

0
2
<exists>
2
"IntervalTier"
"speaker - words"
0
2
3
0
0.5
"one"
0.5
1
""
1
2
"two"
"IntervalTier"
"phones"
0
2
2
0
0.2
"W"
0.2
0.5
"AH1"
"""
    one, two = read_timings(content.encode(), "textgrid", _words("One, two!"), duration_s=DURATION_S)
    assert one.phones == (Phone("W", Interval(0, 0.2)), Phone("AH", Interval(0.2, 0.5), 1))
    assert two.interval == Interval(1, 2)


def test_ctm_comments_and_silences_are_passed_over() -> None:
    content = b";; made by a tool\nx 1 0.0 0.5 SIL\nx 1 0.5 0.25 one 0.98\n\nx 1 0.75 0.25 two\n"
    one, two = read_timings(content, "ctm", _words("one two"), duration_s=DURATION_S)
    assert (one.interval, two.interval) == (Interval(0.5, 0.75), Interval(0.75, 1.0))


@pytest.mark.parametrize(
    ("words", "code", "names"),
    [
        ([("one", 0.0, 0.5)], "timings_words_differ", "word 1 of the text is 'two'"),
        ([("one", 0.0, 0.5), ("too", 0.5, 1.0)], "timings_words_differ", "has 'too'"),
        ([("one", 0.0, 0.5), ("two", 0.5, 1.0), ("three", 1.0, 1.5)], "timings_words_differ", "'three'"),
        ([("one", -0.1, 0.5), ("two", 0.5, 1.0)], "timings_out_of_order", "entry 0"),
        ([("one", 0.5, 0.4), ("two", 0.5, 1.0)], "timings_out_of_order", "entry 0"),
        ([("one", 0.0, 0.5), ("two", 0.4, 1.0)], "timings_out_of_order", "before 'one' ends"),
        ([("one", 0.0, 0.5), ("two", 0.5, 2.1)], "timings_beyond_audio", "2.000 s"),
        ([("one", 0.0, float("nan")), ("two", 0.5, 1.0)], "timings_not_a_time", "entry 0"),
        ([("one", 0.0, float("inf")), ("two", 0.5, 1.0)], "timings_not_a_time", "entry 0"),
    ],
)
def test_wrong_timings_say_where(words: list[tuple[str, float, float]], code: str, names: str) -> None:
    with pytest.raises(InputError) as caught:
        _read_json(*({"text": text, "start_s": start_s, "end_s": end_s} for text, start_s, end_s in words))
    assert caught.value.code == code
    assert caught.value.field == "words"
    assert names in caught.value.message


def test_phones_must_lie_in_their_word_in_order() -> None:
    phones = [{"label": "W", "start_s": 0.3, "end_s": 0.5}, {"label": "AH", "start_s": 0.1, "end_s": 0.3}]
    with pytest.raises(InputError, match="must hold its phones"):
        _read_json(
            {"text": "one", "start_s": 0, "end_s": 0.5, "phones": phones}, {"text": "two", "start_s": 1, "end_s": 2}
        )


def test_rounding_of_other_tools_is_forgiven() -> None:
    one, two = _read_json(
        {"text": "one", "start_s": 0.0, "end_s": 0.504}, {"text": "two", "start_s": 0.5, "end_s": 2.004}
    )
    assert one.interval is not None
    assert two.interval == Interval(0.5, DURATION_S)


@pytest.mark.parametrize(
    ("content", "format"),
    [
        (b"{", "json"),
        (b"[]", "json"),
        (b'{"words": [{"index": 0}]}', "json"),
        (b'{"words": [{"text": "one", "start_s": "soon", "end_s": 1}]}', "json"),
        (b"[" * 100_000, "json"),
        (b"\xff\xff", "json"),
        (b"x 1 0.5 one", "ctm"),
        (b"x 1 zero 0.5 one", "ctm"),
        (b"", "textgrid"),
        (b"not a grid", "textgrid"),
        (b'File type = "ooTextFile"\nitem [1]:\n xmin = -0.5\n', "textgrid"),
        (b"[1, 2]", "textgrid"),
        (b'{"tiers": 1}', "textgrid"),
    ],
)
def test_what_is_no_timings_file_is_refused(content: bytes, format: str) -> None:  # noqa: A002
    with pytest.raises(UndecodableError) as caught:
        read_timings(content, format, _words("one two"), duration_s=DURATION_S)
    assert caught.value.code == "timings_unreadable"
    assert "\n" not in caught.value.message


def test_other_formats_are_refused() -> None:
    with pytest.raises(UnsupportedFormatError, match="json, textgrid, ctm"):
        read_timings(b"", "srt", _words(), duration_s=DURATION_S)


def test_fillers_beside_the_words_are_read_as_far_as_the_audio_goes() -> None:
    fillers = [{"text": "um", "start_s": 0.5, "end_s": 0.8}, {"text": "uh", "start_s": DURATION_S, "end_s": 2.5}]
    content = json.dumps({"words": [], "fillers": fillers}).encode()
    assert read_fillers(content, "json", duration_s=DURATION_S) == (Filler("um", Interval(0.5, 0.8)),)
    assert read_fillers(b"line 1 0.0 0.4 one", "ctm", duration_s=DURATION_S) == ()


def test_a_filler_that_is_none_is_told() -> None:
    with pytest.raises(UndecodableError) as caught:
        read_timings(b'{"words": [], "fillers": [{"text": "um", "start_s": -1, "end_s": 1}]}', "json", (), duration_s=2)
    assert "fillers.0.start_s" in caught.value.message


def _marks(*marks: tuple[int, str, str]) -> bytes:
    """A synthesizer's speech marks: milliseconds, type, value."""
    lines = (json.dumps({"time": time, "type": kind, "value": value, "start": 0}) for time, kind, value in marks)
    return "\n".join(lines).encode() + b"\n"


def test_a_synthesizers_speech_marks_are_read_a_word_ends_where_the_mouth_closes_or_the_next_begins() -> None:
    content = _marks(
        *((0, "sentence", "One two three"), (100, "word", "One"), (110, "viseme", "t"), (300, "word", "two")),
        *((480, "viseme", "sil"), (700, "word", "three"), (950, "viseme", "i")),
    )
    words = read_timings(content, "json", _words("One two three"), duration_s=DURATION_S)
    assert [word.interval for word in words] == [Interval(0.1, 0.3), Interval(0.3, 0.48), Interval(0.7, 0.95)]
    assert read_fillers(content, "json", duration_s=DURATION_S) == ()


def test_words_in_one_line_of_json_are_no_speech_marks_though_time_is_spoken() -> None:
    words = [{"text": "time", "start_s": 0.1, "end_s": 0.4}, {"text": "flies", "start_s": 0.4, "end_s": 0.9}]
    found = read_timings(json.dumps({"words": words}).encode(), "json", _words("time flies"), duration_s=1.0)
    assert [each.interval for each in found] == [Interval(0.1, 0.4), Interval(0.4, 0.9)]


def test_without_a_mark_after_it_the_last_word_lasts_as_usual() -> None:
    words = read_timings(_marks((0, "word", "one"), (500, "word", "two")), "json", _words("one two"), duration_s=2.0)
    assert [word.interval for word in words] == [Interval(0.0, 0.5), Interval(0.5, 0.8)]
    (one,) = read_timings(_marks((100, "word", "one")), "json", _words("one"), duration_s=2.0)
    assert one.interval == Interval(0.1, 0.4)


def test_a_line_that_is_no_mark_is_told() -> None:
    content = _marks((0, "word", "one")) + b'{"time": "soon", "type": "word"}\n'
    with pytest.raises(UndecodableError, match="line 2 is not a speech mark: time: Input should be a valid number"):
        read_timings(content, "json", _words("one"), duration_s=2.0)
