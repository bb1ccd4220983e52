"""The model of an error over HTTP (RFC 9457); `understudy.api.problems` writes it."""

from enum import StrEnum
from types import MappingProxyType
from typing import Annotated

from pydantic import BaseModel, Field

CODES = MappingProxyType(
    {
        400: (
            *("audio_undecodable", "audio_truncated", "audio_length_unstated", "text_not_utf8", "timings_unreadable"),
            *("avatar_undecodable", "not_json", "form_broken", "client_disconnected"),
        ),
        401: ("key_wrong",),
        403: ("rules_read_only", "origin_refused"),
        404: ("not_found",),
        405: ("method_not_allowed",),
        406: ("not_acceptable",),
        408: ("upload_slow",),
        412: ("file_changed",),
        413: (
            *("audio_too_large", "audio_too_long", "text_too_long", "bml_too_large", "body_too_large"),
            *("field_too_large", "work_too_large"),
        ),
        415: ("audio_format_unsupported", "audio_codec_unsupported", "timings_format", "media_type"),
        421: ("host_unknown",),
        422: (
            *("audio_empty", "audio_too_short", "audio_sample_rate", "audio_channels", "audio_bad_sample"),
            *("audio_silent", "text_empty", "text_word_too_long", "text_control_character", "text_surrogate"),
            "affect_wrong",
            *("transcript_unspoken", "transcript_mismatch", "timings_words_differ", "timings_not_a_time"),
            *("timings_out_of_order", "timings_beyond_audio", "bml_wrong", "unknown_character", "unknown_avatar"),
            *("unknown_skeleton", "value_wrong", "functions_wrong", "functions_class", "functions_span"),
            *("reference_unreadable", "reference_other_features", "direction_wrong", "direction_family"),
            *("direction_importance", "direction_span", "not_an_object", "field_missing", "field_unknown"),
            *("field_repeated", "motion_too_large", "target_wrong", "unknown_target", "unknown_profile"),
            *("gesture_wrong", "unfit_gesture", "unknown_name", "rules_wrong", "rules_unreadable", "unknown_file"),
            *("edits_wrong", "profile_wrong", "tags_wrong", "lexicon_wrong", "agitation_model"),
            "file_wrong",
            *("bvh_wrong", "pairs_wrong", "motion_model"),
        ),
        429: ("too_many_requests", "too_many_wrong_keys"),
        500: (
            *("aligner_crashed", "model_unreadable", "model_damaged", "affect_model_failed", "plot_unavailable"),
            "parser_missing",
            *(
                "parser_incomplete",
                "parser_labels",
                "physics_missing",
                "lexicon_unlinked",
                "installation_incomplete",
                "nursery_ended",
                "internal_error",
            ),
        ),
        501: ("usd_missing", "blender_missing"),
        503: (*("service_full", "service_stopping", "uploads_full", "connections_full", "worker_lost", "not_ready"),),
        504: ("deadline_passed",),
    }
)
"""The codes of each status, as in docs/errors.md."""

ErrorCode = StrEnum("ErrorCode", [(code, code) for codes in CODES.values() for code in codes])  # type: ignore[misc]


class Problem(BaseModel):
    """What went wrong: `code` is stable, `detail` is for people, `field` names the part of the request at fault. Later
    versions may have further codes and further members."""

    type: Annotated[str, Field(examples=["urn:understudy:error:text_empty"])]
    title: Annotated[str, Field(examples=["Unprocessable Entity"])]
    status: Annotated[int, Field(examples=[422])]
    code: Annotated[ErrorCode | str, Field(examples=["text_empty"])]
    detail: Annotated[str, Field(examples=["the text has no words; send the words that are spoken"])]
    field: Annotated[str | None, Field(examples=["text"])] = None
