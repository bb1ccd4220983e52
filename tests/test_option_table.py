"""Every door has the options of the table, by the table's names, ranges, defaults and choices, and no others.

What a door lacks, and why, stands in the sets below.
"""

import argparse
import ast
import re
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any, Literal, get_args, get_origin, get_type_hints

import pytest

from understudy.batch.scripts.columns import FIELDS
from understudy.cli.arguments.parser import make_parser
from understudy.errors import InputError
from understudy.library.motion import MotionFileKeywords, RealizeKeywords
from understudy.library.performing import PerformKeywords
from understudy.model.edits import LineSettings
from understudy.option_table import MOTION, PERFORMANCE, Option
from understudy.schemas.edits import LineSettingsForm
from understudy.schemas.options import PerformOptions, RealizeOptions

ROOT = Path(__file__).parents[1]
REQUESTS = {"perform": (PERFORMANCE, PerformOptions), "realize": (MOTION, RealizeOptions)}

JSON_ALONE = {"contours"}
"""The command line has `--trace` and `understudy pitch` instead; in Python `analyze` has them."""
WHEN_WRITTEN = {"dialect", "timing", "visemes", "bmlt_audio"}
"""In Python these are arguments of `write_bml`."""
OF_FILES = {"skeleton", "t_pose", "root_at_origin", "keys", "bap_version"}
"""In Python these are arguments of `write_motion`."""
OF_A_LINE = {"character", "agitation", "seed", "stillness", "mode", "affect"}
"""What an author sets for one line; the rest is said of the request."""
OF_A_ROW = {"character", "agitation", "affect", "seed", "listener"}
"""A script's columns; a row has `target`, one or more, and what the row lacks the command line says of all lines."""
JSON_TYPES: Mapping[type, str] = {str: "string", int: "integer", float: "number", bool: "boolean"}


def _arguments(command: str) -> dict[str, argparse.Action]:
    parser = make_parser()
    commands = next(each for each in parser._actions if isinstance(each, argparse._SubParsersAction))
    return {flag: action for action in commands.choices[command]._actions for flag in action.option_strings}


@pytest.mark.parametrize("command", REQUESTS)
def test_the_command_line_has_every_option(command: str) -> None:
    table = REQUESTS[command][0]
    arguments = _arguments(command)
    for option in table.values():
        if option.name in JSON_ALONE:
            assert option.argument not in arguments
            continue
        argument = arguments[option.argument]
        assert argument.help == option.told_in_command()
        assert tuple(argument.choices or ()) == option.choices
        if option.kind is not bool and not isinstance(option.default, (tuple, Mapping)):
            assert argument.default == option.default


def test_the_command_line_has_no_other_options() -> None:
    """But files and what is done with the result."""
    files = {"text", "text-file", "words", "functions", "direction", "edits", "trace", "realize", "avatar", "output"}
    general = {"help", "quiet", "json-log", "lexicon", "agitation-model", "no-physics", "motion-model", "scenario"}
    known = {option.argument for option in (*PERFORMANCE.values(), *MOTION.values())}
    found = {flag for flag in _arguments("perform") if flag.startswith("--")}
    assert found - known == {f"--{name}" for name in files | general}


@pytest.mark.parametrize(("table", "request_of"), REQUESTS.values(), ids=REQUESTS)
def test_requests_have_the_options_in_order(table: Mapping[str, Option], request_of: type[PerformOptions]) -> None:
    assert list(request_of.model_fields) == list(table)
    schema = request_of.model_json_schema()
    for name, told in schema["properties"].items():
        option = table[name]
        assert told["description"] == option.told_in_request()
        assert (told.get("minimum"), told.get("maximum")) in {option.limits or (None, None), (None, None)}
        if option.choices:
            assert set(_choices(told, schema)) == set(option.choices)
        elif isinstance(option.default, (str, int, float, bool)):
            assert told["type"] == JSON_TYPES[option.kind]


def _choices(told: dict[str, Any], schema: Mapping[str, Any]) -> Iterator[object]:
    """The values that a part of a schema allows, besides null."""
    if "$ref" in told:
        told = schema["$defs"][told["$ref"].removeprefix("#/$defs/")]
    yield from told.get("enum", ())
    for each in told.get("anyOf", ()):
        yield from _choices(each, schema)


def test_keywords_of_python_are_the_options() -> None:
    assert set(PerformKeywords.__annotations__) == set(PERFORMANCE) - WHEN_WRITTEN - JSON_ALONE
    assert set(RealizeKeywords.__annotations__) == set(MOTION) - OF_FILES
    assert set(MotionFileKeywords.__annotations__) == OF_FILES - {"skeleton"} | {"audio"}


@pytest.mark.parametrize(
    ("keywords", "table"), [(PerformKeywords, PERFORMANCE), (RealizeKeywords, MOTION), (MotionFileKeywords, MOTION)]
)
def test_keywords_of_python_allow_the_choices(keywords: type, table: Mapping[str, Option]) -> None:
    for name, hint in get_type_hints(keywords).items():
        allowed = {value for each in (hint, *get_args(hint)) if get_origin(each) is Literal for value in get_args(each)}
        if allowed and name != "affect":  # which is a tone, or numbers
            assert allowed == set(table[name].choices), name


def test_edits_set_options_of_the_table() -> None:
    assert set(LineSettings.__dataclass_fields__) == set(LineSettingsForm.model_fields) == OF_A_LINE
    assert set(PERFORMANCE) >= OF_A_LINE


def test_rows_of_a_script_have_options_of_the_table() -> None:
    of_the_script = {"id", "text", "recording", "comment", "direction", "edits", "scene", "take", "start", "end"}
    assert set(FIELDS) - of_the_script == OF_A_ROW | {PERFORMANCE["targets"].flag}
    assert set(PERFORMANCE) >= OF_A_ROW


def _blender_properties(path: Path) -> dict[str, Mapping[str | None, object]]:
    """The arguments of Blender's properties that are constants, by the property's name."""
    found: dict[str, Mapping[str | None, object]] = {}
    for each in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        match each:
            case ast.AnnAssign(target=ast.Name(id=name), annotation=ast.Call(keywords=told)):
                found[name] = {word.arg: word.value.value for word in told if isinstance(word.value, ast.Constant)}
    return found


def test_the_panels_of_blender_have_the_tables_ranges() -> None:
    found = _blender_properties(ROOT / "plugins/blender/interface/properties.py")
    for name in ("stillness", "lead_in_s", "tail_s"):
        option = PERFORMANCE.get(name) or MOTION[name]
        assert (found[name]["min"], found[name]["max"]) == option.limits
    assert found["character"]["default"] == PERFORMANCE["character"].default
    assert {"seed", "agitation", "profile", "listener", "targets"} <= set(found)


def test_the_panel_of_the_studio_has_the_tables_ranges() -> None:
    form = (ROOT / "app/studio/page/line/project_form.js").read_text(encoding="utf-8")
    assert set(re.findall(r'setOption\(store, "(\w+)"', form)) <= set(PERFORMANCE)
    ranges = re.findall(r'min: ([\d.]+), max: ([\d.]+),[^}]*?id: "(\w+)"', form)
    assert ranges
    for least, most, name in ranges:
        assert (float(least), float(most)) == PERFORMANCE[name].limits


def test_a_number_outside_its_range_is_refused_with_what_it_means() -> None:
    PERFORMANCE["stillness"].check(1.0)
    with pytest.raises(
        InputError, match=r"^lead_in_s: 5; give 0 to 3: seconds by which the performance begins"
    ) as caught:
        PERFORMANCE["lead_in_s"].check(5)
    assert caught.value.field == "lead_in_s"
    with pytest.raises(InputError):
        PERFORMANCE["stillness"].check(float("nan"))
