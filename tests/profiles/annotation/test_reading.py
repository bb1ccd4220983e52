"""Annotations of every format: the same marks read the same, and every mistake is told with file, track and time."""

from dataclasses import replace
from pathlib import Path

import pytest

from tests.support.annotations import SPARING, SWEEPING, small_tracks
from understudy.errors import UnsupportedFormatError
from understudy.model import Hand
from understudy.profiles.annotation.elan import write_elan
from understudy.profiles.annotation.model import AnnotationError, PathForm, Position, Swivel
from understudy.profiles.annotation.reading import annotation_of, read_annotations
from understudy.profiles.annotation.tables import write_json_tracks
from understudy.profiles.annotation.tracks import Track, TrackSpan, rows_of, with_attribute_tracks

ANVIL = """<?xml version="1.0" encoding="UTF-8"?>
<annotation><head/><body>
<track name="speech.words" type="primary">
 <el index="0" start="0.5" end="0.9"><attribute name="token">never</attribute></el>
 <el index="1" start="0.9" end="1.3"><attribute name="token">mind</attribute></el>
</track>
<track name="gesture.phase" type="primary">
 <el index="0" start="0.3" end="0.6"><attribute name="type">prep</attribute></el>
 <el index="1" start="0.6" end="0.9"><attribute name="type">stroke</attribute></el>
 <el index="2" start="0.9" end="1.2"><attribute name="type">retract</attribute></el>
</track>
<track name="gesture.phrase" type="span" ref="gesture.phase">
 <el index="0" start="0" end="1"><attribute name="lexeme">negation</attribute><attribute name="hand">RH</attribute>
  <attribute name="affiliate"><value-link ref-track="speech.words" ref-index="0"/></attribute></el>
</track>
<track name="gesture.unit" type="span" ref="gesture.phase"><el index="0" start="0" end="2"/></track>
</body></annotation>"""


def _textgrid(tracks: list[Track]) -> str:
    lines = ['File type = "ooTextFile"', 'Object class = "TextGrid"', "", "xmin = 0", "xmax = 3", "tiers? <exists>"]
    lines += [f"size = {len(tracks)}", "item []:"]
    for number, track in enumerate(tracks, start=1):
        head = [f"    item [{number}]:", '        class = "IntervalTier"', f'        name = "{track.name}"']
        lines += [*head, "        xmin = 0", "        xmax = 3", f"        intervals: size = {len(track.spans)}"]
        for place, span in enumerate(track.spans, start=1):
            lines += [f"        intervals [{place}]:", f"            xmin = {span.start_s}"]
            lines += [f"            xmax = {span.end_s}", f'            text = "{span.label}"']
    return "\n".join(lines) + "\n"


def _csv(tracks: list[Track]) -> str:
    names = ("hand", "path", "from", "to", "affiliate")
    rows = [",".join(("track", "start_s", "end_s", "label", *names))]
    for track in tracks:
        for span in track.spans:
            said = (span.attributes.get(name, "") for name in names)
            rows.append(",".join((track.name, f"{span.start_s}", f"{span.end_s}", span.label, *said)))
    return "\n".join(rows) + "\n"


def test_every_format_reads_the_same(tmp_path: Path) -> None:
    tracks = list(small_tracks().values())
    rows = [row for track in with_attribute_tracks(tracks) for row in rows_of(track)]
    (tmp_path / "a.eaf").write_bytes(write_elan(rows))
    (tmp_path / "a.json").write_bytes(write_json_tracks(tracks))
    (tmp_path / "a.csv").write_text(_csv(tracks), encoding="utf-8")
    (tmp_path / "a.TextGrid").write_text(_textgrid(rows), encoding="utf-8")
    wanted = annotation_of(tracks, Path("x"))
    for name in ("a.eaf", "a.json", "a.csv", "a.TextGrid"):
        [found] = read_annotations([tmp_path / name])
        assert replace(found, path=wanted.path) == wanted, name


def test_what_was_marked_is_there() -> None:
    annotation = annotation_of(small_tracks().values(), Path("x"))
    me, no, you = annotation.phrases
    assert (me.lexeme, me.hand, len(me.strokes), me.affiliate) == ("ME", Hand.RIGHT, 2, (0, 0))
    assert me.start == Position("XP", "YCC", "ZMiddle", Swivel.OUT)
    assert (no.hand, no.path, no.affiliate) == (Hand.BOTH, PathForm.CURVED, (1, 1))
    assert (you.hand, you.affiliate) == (Hand.LEFT, (4, 5))
    assert [len(unit.phrases) for unit in annotation.units] == [2, 1]
    assert [unit.rest for unit in annotation.units] == ["clasped", "at_side"]
    assert annotation.segments == ((0, 5),)
    assert [(each.tag, each.first) for each in annotation.tags or ()] == [
        ("deixis.self", 0),
        ("negation", 1),
        ("deixis.addressee", 4),
    ]


def test_anvil_spans_and_links(tmp_path: Path) -> None:
    path = tmp_path / "a.anvil"
    path.write_text(ANVIL, encoding="utf-8")
    [annotation] = read_annotations([path])
    [phrase] = annotation.phrases
    assert (phrase.lexeme, phrase.affiliate, phrase.interval.start_s, phrase.interval.end_s) == (
        "NEGATION",
        (0, 0),
        0.3,
        0.9,
    )
    assert annotation.units[0].retraction is not None
    assert annotation.tags is None


def test_anvil_links_are_numbers_of_words_in_their_time(tmp_path: Path) -> None:
    path = tmp_path / "a.anvil"
    linked = ANVIL.replace('<el index="0" start="0.5"', '<el index="8" start="0.5"').replace(
        'ref-index="0"', 'ref-index="8"'
    )
    path.write_text(linked.replace("<annotation>", '<annotation xmlns="urn:anvil">'), encoding="utf-8")
    [annotation] = read_annotations([path])
    assert annotation.phrases[0].affiliate == (0, 0)


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16"])
@pytest.mark.parametrize(("delimiter", "comma"), [(",", "."), (";", ","), ("\t", ",")])
def test_tables_as_spreadsheets_save_them(tmp_path: Path, encoding: str, delimiter: str, comma: str) -> None:
    tracks = list(small_tracks().values())
    rows = [line.split(",") for line in _csv(tracks).splitlines()]
    text = "\r\n".join(delimiter.join(cell.replace(".", comma) for cell in row) for row in rows)
    (tmp_path / "a.csv").write_bytes(text.encode(encoding))
    [found] = read_annotations([tmp_path / "a.csv"])
    assert [phrase.lexeme for phrase in found.phrases] == ["ME", "NEGATION", "YOU"]
    assert found.words[-1].text == "lied"


TAGS = {"deixis.self", "deixis.addressee", "negation"}


def _mistakes(tracks: dict[str, Track], **changed: tuple[TrackSpan, ...]) -> list[str]:
    changes = {name: Track(name, spans) for name, spans in changed.items()}
    with pytest.raises(AnnotationError) as raised:
        annotation_of({**tracks, **changes}.values(), Path("x.eaf"), {"ME", "NEGATION", "YOU"}, TAGS)
    return [str(each) for each in raised.value.mistakes]


def test_every_mistake_at_once_with_its_place() -> None:
    tracks = small_tracks()
    phrases = list(tracks["phrases"].spans)
    phrases[0] = replace(phrases[0], attributes={"hand": "XH", "path": "wavy", "from": "XP YCC", "affiliate": "99"})
    phrases[1] = replace(phrases[1], label="NEGATON")
    found = _mistakes(tracks, phrases=tuple(phrases))
    assert len(found) == 5
    assert all(each.startswith("x.eaf: phrases at ") for each in found)
    text = "\n".join(found)
    for told in ("hand 'xh'", "path 'wavy'", "sector across", "affiliate '99'", "did you mean 'NEGATION'?"):
        assert told in text


@pytest.mark.parametrize(
    ("changed", "told"),
    [
        ({"units": (TrackSpan(0.2, 2.1, ""),)}, "x.eaf: phrases at 2.200 s: YOU lies in no unit"),
        (
            {"units": (TrackSpan(0.2, 2.1, ""), TrackSpan(2.2, 3.0, ""), TrackSpan(5.0, 6.0, ""))},
            "units at 5.000 s: no gesture lies",
        ),
        ({"phases": (TrackSpan(0.6, 0.9, "strike"),)}, "no phase is called 'strike'; did you mean 'stroke'?"),
        ({"phrases": (TrackSpan(0.2, 0.6, "ME", {"hand": "RH"}),)}, "it has neither a stroke nor an independent hold"),
        ({"words": (TrackSpan(1.0, 0.9, "I"),)}, "words at 1.000 s: ends at 0.900 s"),
        ({"words": (TrackSpan(0.5, 0.9, "I"), TrackSpan(0.8, 1.0, "am"))}, "words at 0.800 s: overlaps 'I'"),
        (
            {"units": (TrackSpan(0.2, 2.1, "at side"), TrackSpan(2.2, 3.0, "claspd"))},
            "units at 2.200 s: the hands have no rest pose 'claspd'",
        ),
        (
            {"tags": (TrackSpan(0.5, 0.9, "negatoin"),)},
            "tags at 0.500 s: no function is called 'negatoin'; did you mean",
        ),
        ({"phrases.hand": (TrackSpan(5.0, 5.5, "RH"),)}, "phrases.hand at 5.000 s: 'RH' labels nothing"),
    ],
)
def test_contradictions(changed: dict[str, tuple[TrackSpan, ...]], told: str) -> None:
    assert any(told in each for each in _mistakes(small_tracks(), **changed))


def test_what_is_missing_everywhere_is_one_mistake() -> None:
    tracks = small_tracks()
    handless = tuple(replace(span, attributes={}) for span in tracks["phrases"].spans)
    [told] = _mistakes(tracks, phrases=handless)
    assert told.startswith("x.eaf: phrases: no phrase has a hand")
    tracks.pop("units")
    assert _mistakes(tracks, words=(TrackSpan(0.5, 0.4, "I"),)) == [
        "x.eaf: units: the track is missing",
        "x.eaf: words at 0.500 s: ends at 0.400 s; a span starts at 0 or later, ends later",
    ]


def test_tracks_that_say_nothing_to_us_are_named() -> None:
    tracks = [*small_tracks().values(), Track("comments", (TrackSpan(0.0, 1.0, "coughs"),))]
    assert annotation_of(tracks, Path("x")).unread == ("comments",)


def test_the_words_nearest_in_time_are_meant() -> None:
    tracks = small_tracks()
    words = [
        TrackSpan(float(place), place + 0.9, text) for place, text in enumerate(["to", "be", "or", "not", "to", "be"])
    ]
    phrases = [TrackSpan(0.2, 1.3, "ME", {"hand": "RH", "affiliate": "to be"})]
    phrases += [TrackSpan(2.2, 2.6, "YOU", {"hand": "RH", "affiliate": "To be!"})]
    changed = {"words": Track("words", tuple(words)), "phrases": Track("phrases", tuple(phrases))}
    changed["phases"] = Track("phases", (TrackSpan(0.6, 0.9, "stroke"), TrackSpan(2.4, 2.6, "stroke")))
    found = annotation_of({**tracks, **changed, "tags": Track("tags", ())}.values(), Path("x"))
    assert [phrase.affiliate for phrase in found.phrases] == [(0, 1), (4, 5)]


def test_missing_tracks_and_unknown_formats(tmp_path: Path) -> None:
    with pytest.raises(AnnotationError) as raised:
        annotation_of([Track("phrase_list", ())], Path("x.csv"))
    assert [each.track for each in raised.value.mistakes] == ["phases", "phrases", "units", "words"]
    with pytest.raises(UnsupportedFormatError):
        read_annotations([tmp_path / "a.docx"])


@pytest.mark.parametrize(
    ("name", "content", "told"),
    [
        ("a.eaf", "<x", "not XML"),
        ("a.eaf", "<annotation/>", "<ANNOTATION_DOCUMENT> is expected"),
        ("a.TextGrid", "hello", "not a TextGrid"),
        ("a.csv", "track,start\n", "line 1: the column end_s is missing"),
        ("a.csv", "track,start_s,end_s,label,hands\n", "line 1: no column may be called 'hands'; did you mean 'hand'?"),
        ("a.csv", "track;start_s;end_s;label\n;0,5;1;I\n", "line 2: no track"),
        ("a.csv", "track,start_s,end_s,label\nwords,nan,1,I\n", "words: line 2: start_s 'nan'; give seconds"),
        ("a.csv", "track,start_s,end_s,label\nwords,0,1\n", "words: line 2: 3 cells; the header has 4"),
        ("a.csv", 'track,start_s,end_s,label\nwords,0,1,"I\n', "line 2: unexpected end"),
        ("a.csv", "track,start_s,end_s,label\nwords,0,1,\xe4\n".encode("latin-1"), "line 2: byte 36 is not UTF-8"),
        (
            "a.eaf",
            "<ANNOTATION_DOCUMENT><HEADER TIME_UNITS='PAL-frames'/></ANNOTATION_DOCUMENT>",
            "times in PAL-frames",
        ),
        ("a.eaf", "<ANNOTATION_DOCUMENT><TIME_SLOT TIME_VALUE='x'/></ANNOTATION_DOCUMENT>", "line 1: time slot"),
        ("a.anvil", ANVIL.replace('start="0.5"', 'start="inf"'), "speech.words: line 4: element 0 has no time"),
        ("a.anvil", ANVIL.replace('ref-index="0"', 'ref-index="7"'), "0.300 s: affiliate names elements 7 to 7"),
        ("a.anvil", ANVIL.replace('ref="gesture.phase"', 'ref="phase"'), "refers to the track 'phase', which is not"),
        ("a.csv", "track,start_s,end_s,label\nwords,x,1,I\n", "words: line 2: start_s 'x'; give seconds"),
        ("a.json", '{"tracks": {"words": [{"start_s": "x"}]}}', "words: span 0: start_s"),
    ],
)
def test_what_cannot_be_read(tmp_path: Path, name: str, content: str | bytes, told: str) -> None:
    (tmp_path / name).write_bytes(content.encode() if isinstance(content, str) else content)
    with pytest.raises(AnnotationError) as raised:
        read_annotations([tmp_path / name])
    assert told in str(raised.value)


def test_the_examples_are_several_minutes_each_and_hold_together() -> None:
    for annotation in read_annotations([SWEEPING, SPARING]):
        assert annotation.duration_s > 300
        assert len(annotation.phrases) > 100
        assert annotation.tags
