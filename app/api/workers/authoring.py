"""Answers authors' requests in a worker: checks and plays gestures, reads poses, tries edited rules."""

from pathlib import PurePath

from ...authoring.catalogue import Catalogue
from ...authoring.gesture_texts import Playing, check_text, one_gesture, schedule_of_gesture, with_only
from ...authoring.rule_edits import compare, example_lines, mistakes_in, with_edits
from ...errors import InputError, TooLargeError, UnsupportedFormatError
from ...library.motion import OURS, realize_prepared, write_realized
from ...models import Understudy
from ...realizer.avatars.pose import read_pose
from ...schemas.gestures.definitions import GestureCheckResponse, read_gesture_check, read_gesture_motion
from ...schemas.motion import AvatarPoseResponse, read_pose_options
from ...schemas.requests import read_object
from ...schemas.rules import (
    MOST_LINES,
    LineChangeResponse,
    RuleCheckResponse,
    RuleComparisonResponse,
    RuleExplanationsResponse,
    read_rule_comparison,
    read_rule_edits,
    read_rule_explanation,
)
from ..bodies import form_limits, media_type_of
from ..negotiation import GESTURE_TYPES, JSON, chosen
from .form import read_form
from .messages import Answer, Job, Task


def check_gesture(understudy: Understudy, job: Job, content: bytes) -> tuple[Answer, bytes]:
    """A gesture's text or values with every mistake; never an error for what its author wrote."""
    asked = read_gesture_check(_json(job, content))
    realizer = understudy.realizer
    found = check_text(asked.written(realizer.library), realizer.skeleton)
    return Answer(JSON), GestureCheckResponse.of(found).to_json()


def play_gesture(understudy: Understudy, job: Job, content: bytes) -> tuple[Answer, bytes]:
    """The motion of one gesture, alone."""
    media_type = chosen(job.accept, tuple(GESTURE_TYPES), "motion")
    asked = read_gesture_motion(_json(job, content))
    definition = one_gesture(asked.text, asked.name)
    figure = understudy.behavior.characters.named(asked.character).figure
    playing = Playing(asked.level, asked.hand, asked.character, figure.manner)
    prepared = schedule_of_gesture(definition, playing)
    limits = understudy.acoustic.settings.motion_limits
    limits.check(prepared.schedule, frame_rate_hz=asked.fps)
    realizer = with_only(understudy.realizer, definition, playing)
    realized = realize_prepared(realizer, prepared, frame_rate_hz=asked.fps)
    body = write_realized(realized, realizer, GESTURE_TYPES[media_type], OURS)
    limits.check_content(body)
    return Answer(media_type, {"Vary": "Accept"}), body


def take_pose(understudy: Understudy, job: Job, content: bytes) -> tuple[Answer, bytes]:
    """The pose of an avatar as angles of joints."""
    form = read_form(job.content_type, content, form_limits(Task.GESTURE_POSE, understudy.acoustic.settings))
    if "avatar" not in form:
        raise InputError("field_missing", "the field avatar is missing; send a GLB or VRM file", field="avatar")
    options = read_pose_options(form["options"].content if "options" in form else b"{}")
    realizer = understudy.realizer
    pose = read_pose(
        form["avatar"].content,
        realizer.skeleton,
        realizer.rigs,
        animation=options.animation,
        time_s=options.time_s,
    )
    name = PurePath(form["avatar"].file_name or "").name
    return Answer(JSON), AvatarPoseResponse.of(pose, name, options.time_s).to_json()


def check_rules(understudy: Understudy, job: Job, content: bytes) -> tuple[Answer, bytes]:
    """Every mistake in edited rules and words."""
    asked = read_rule_edits(_json(job, content))
    found = mistakes_in(asked.files, understudy.behavior.characters.callable_names)
    return Answer(JSON), RuleCheckResponse.of(found).to_json()


def explain_rule(understudy: Understudy, job: Job, content: bytes) -> tuple[Answer, bytes]:
    """What a rule, behaviour or word is, says and takes part in."""
    asked = read_rule_explanation(_json(job, content))
    edited = with_edits(understudy, asked.files)
    behavior = edited.behavior
    catalogue = Catalogue.of(edited.language.rules, behavior.characters, behavior.rules, behavior.families)
    return Answer(JSON), RuleExplanationsResponse.of(catalogue, asked.name).to_json()


def compare_rules(understudy: Understudy, job: Job, content: bytes) -> tuple[Answer, bytes]:
    """What edited rules change in lines."""
    asked = read_rule_comparison(_json(job, content))
    if len(asked.lines) > MOST_LINES:
        raise TooLargeError("field_too_large", f"{len(asked.lines)} lines; {MOST_LINES} at most", field="lines")
    examples = example_lines(understudy.language.rules.lexicon) if asked.examples else {}
    lines = {**examples, **asked.lines}
    changes = compare(understudy, asked.files, lines)
    told = RuleComparisonResponse(lines=len(lines), changes=list(map(LineChangeResponse.of, changes)))
    return Answer(JSON), told.to_json()


def _json(job: Job, content: bytes) -> dict[str, object]:
    """Raises UnsupportedFormatError `media_type`, and as `read_object` does."""
    if media_type_of(job.content_type) != JSON:
        raise UnsupportedFormatError("media_type", f"send {JSON}")
    return read_object(content, "body")
