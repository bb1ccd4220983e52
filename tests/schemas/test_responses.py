"""The JSON schemas of CONTRACT.md, from hand-made values."""

import json
from dataclasses import replace
from typing import Any

import numpy as np

from understudy.errors import InputError
from understudy.model import (
    NEUTRAL,
    Agitation,
    AlignedLine,
    Analysis,
    Audio,
    Because,
    Behavior,
    Channel,
    Clause,
    Contours,
    Filler,
    Function,
    Hand,
    Interval,
    Notice,
    Parse,
    Performance,
    Phone,
    Phrase,
    SignalAnalysis,
    StressThresholds,
    SyncPoints,
    Token,
    Utterance,
    VoiceQuality,
    Word,
)
from understudy.schemas.line_parts import BehaviorResponse, FunctionResponse, WordResponse
from understudy.schemas.response_model import ResponseModel
from understudy.schemas.responses import (
    AgitationResponse,
    AlignResponse,
    AnalysisResponse,
    FunctionsResponse,
    MistakeResponse,
    PerformanceResponse,
    PerformResponse,
)

WORDS = (
    Word(0, "Not", Interval(0.1, 0.30000000000000004), (Phone("N", Interval(0.1, 0.2)),), 0.25),
    Word(1, "—"),
    Word(2, "those.", Interval(0.4, 0.9), (Phone("OW", Interval(0.5, 0.6), 1),), 0.0),
)
TOKEN = Token(0, 0, "Not", "not", "PART", "RB", "advmod", 2)
PARSE = Parse((TOKEN,), (Phrase("noun", 2, 2, 2),), (Clause("root", 0, 2, 2),))
FILLERS = (Filler("um", Interval(0.9, 1.0)),)
UTTERANCE = Utterance(WORDS, PARSE, Agitation(0.2, 0.3, 0.5), StressThresholds(-20.0, None), 1.0, FILLERS)
KEPT = Function("f1", "negation", "plain", 0, 0, 5.0, "negation_word", (Because(word=0),))
LOST = Function("f2", "deixis", "distal", 1, 2, 3.0, "those", (Because(fact="lexical", rule="r"),), False, "f1")
NOTICES = (Notice("pronunciation_guessed", "guessed"),)
SHAKE = Behavior(
    "b1", Channel.HEAD, "SHAKE", SyncPoints(0.0, 1.0, 0.1, 0.2, 0.3, 0.4, 0.5), 0, 0, 5.0, "shake", "f1", repetitions=2
)
BLINK = Behavior("b2", Channel.EYES, "BLINK", SyncPoints(0.5, 0.7, ready=0.6, relax=0.65), 2, 2, -0.0)
BEAT = Behavior(
    "b3", Channel.GESTURE, "BEAT", SyncPoints(0, 1), 2, 2, 3.0, "beat", "f2", Hand.LEFT,
    kept=False, lost_to="b1", reason="no room",
)  # fmt: skip
PERFORMANCE = Performance(UTTERANCE, (KEPT, LOST), (SHAKE, BLINK, BEAT), "default", 7, NOTICES)


def _told(answer: ResponseModel) -> dict[str, Any]:
    told: dict[str, Any] = json.loads(answer.to_json())
    return told


def test_a_function_has_the_text_and_times_of_its_words() -> None:
    assert _told(FunctionResponse.of(LOST, WORDS)) == {
        "id": "f2",
        "class": "deixis",
        "subtype": "distal",
        "first": 1,
        "last": 2,
        "text": "— those.",
        "start_s": 0.4,
        "end_s": 0.9,
        "priority": 3.0,
        "rule": "those",
        "because": [{"rule": "r", "fact": "lexical"}],
        "kept": False,
        "lost_to": "f1",
    }


def test_a_class_without_subtypes_has_an_empty_one() -> None:
    assert (FunctionResponse.of(KEPT, WORDS).subtype, FunctionResponse.of(LOST, WORDS).subtype) == ("", "distal")


def test_without_audio_a_function_has_no_times_and_a_winner_names_no_loser() -> None:
    told = _told(FunctionResponse.of(KEPT, (Word(0, "Not"),)))
    assert not {"start_s", "end_s", "lost_to"} & told.keys()
    assert told["because"] == [{"word": 0}]


def test_words_that_are_not_spoken_have_no_times() -> None:
    assert _told(WordResponse.model_validate(WORDS[1])) == {"index": 1, "text": "—", "phones": []}
    assert _told(WordResponse.model_validate(WORDS[2])) == {
        "index": 2,
        "text": "those.",
        "start_s": 0.4,
        "end_s": 0.9,
        "stressed_ratio": 0.0,
        "phones": [{"label": "OW", "start_s": 0.5, "end_s": 0.6, "stress": 1}],
    }


def test_numbers_are_rounded_and_zero_has_no_sign() -> None:
    assert b'"end_s":0.3,' in WordResponse.model_validate(WORDS[0]).to_json()
    assert b'"priority":0.0,' in BehaviorResponse.model_validate(BLINK).to_json()


def test_a_behavior_has_the_sync_points_that_are_set_in_their_order() -> None:
    told = _told(BehaviorResponse.model_validate(SHAKE))
    assert list(told["sync"]) == ["start", "ready", "stroke_start", "stroke", "stroke_end", "relax", "end"]
    assert told["kind"] == "head"
    assert _told(BehaviorResponse.model_validate(BLINK))["sync"] == {
        "start": 0.5,
        "ready": 0.6,
        "relax": 0.65,
        "end": 0.7,
    }
    lost = _told(BehaviorResponse.model_validate(BEAT))
    assert (lost["hand"], lost["kept"], lost["lost_to"], lost["reason"]) == ("left", False, "b1", "no room")


def test_an_analysis_tells_all_that_was_heard_and_understood() -> None:
    told = _told(AnalysisResponse.of(Analysis(UTTERANCE, (KEPT,), NOTICES)))
    assert told["audio"] == {"duration_s": 1.0}
    assert told["stress"] == {"energy_db": -20.0}
    assert told["agitation"] == "high"
    assert told["memberships"] == {"low": 0.2, "medium": 0.3, "high": 0.5}
    assert told["parse"]["tokens"][0]["lemma"] == "not"
    assert told["parse"]["phrases"] == [{"kind": "noun", "first": 2, "last": 2, "head": 2}]
    assert told["parse"]["clauses"] == [{"label": "root", "first": 0, "last": 2, "head": 2}]
    assert [word["index"] for word in told["words"]] == [0, 1, 2]
    assert told["fillers"] == [{"text": "um", "start_s": 0.9, "end_s": 1.0}]
    assert told["warnings"] == [{"code": "pronunciation_guessed", "message": "guessed"}]


def test_a_performance_is_an_analysis_with_its_movements() -> None:
    told = _told(PerformanceResponse.of_performance(PERFORMANCE))
    analysis = _told(AnalysisResponse.of(Analysis(UTTERANCE, (KEPT, LOST), NOTICES)))
    assert analysis.items() <= told.items()
    assert (told["character"], told["seed"]) == ("default", 7)
    assert [behavior["id"] for behavior in told["behaviors"]] == ["b1", "b2", "b3"]
    whole = _told(PerformResponse.of(PERFORMANCE, "<bml>é</bml>".encode()))
    assert whole == {"bml": "<bml>é</bml>", "performance": told, "warnings": told["warnings"]}


def test_a_word_says_so_when_its_times_are_guessed_and_only_then() -> None:
    guessed = replace(WORDS[0], spread=True)
    assert _told(WordResponse.model_validate(guessed))["spread"] is True
    assert "spread" not in _told(WordResponse.model_validate(WORDS[0]))


def test_the_small_shapes() -> None:
    silence = np.zeros(0, np.float32)
    heard = SignalAnalysis(
        Audio(silence),
        Contours(*(silence,) * 4),
        VoiceQuality(*(silence,) * 4),
        silence,
        Agitation(0.5, 0.25, 0.25),
        NEUTRAL,
        (),
    )
    told = _told(AgitationResponse.of("a.wav", heard))
    assert told["affect"]["tones"]["neutral"] == 1.0
    assert {key: told[key] for key in ("file", "agitation", "memberships")} == {
        "file": "a.wav",
        "agitation": "low",
        "memberships": {"low": 0.5, "medium": 0.25, "high": 0.25},
    }
    aligned = _told(AlignResponse.of(AlignedLine(WORDS, 1.0, NOTICES, FILLERS)))
    assert [filler["text"] for filler in aligned["fillers"]] == ["um"]
    assert len(aligned["words"]) == 3
    assert aligned["audio"] == {"duration_s": 1.0}
    functions = FunctionsResponse.of(Analysis(UTTERANCE, (KEPT,)))
    assert list(_told(functions)) == ["functions"]
    assert list(_told(FunctionsResponse.of(Analysis(UTTERANCE, ()), 3))) == ["id", "functions"]
    mistake = MistakeResponse.of(InputError("text_empty", "no words"), "x")
    assert _told(mistake) == {"id": "x", "error": {"code": "text_empty", "message": "no words"}}
