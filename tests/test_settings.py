"""Every setting is documented with its default, and a wrong one is told in one line."""

import re
from pathlib import Path

import pytest

from understudy.errors import InputError
from understudy.settings import PART_BYTES, PREFIX, Settings, read_settings

PAGE = (Path(__file__).parents[1] / "docs/settings.md").read_text()
DOCUMENTED = dict(re.findall(rf"^\| `{PREFIX}(\w+)` \| (.*?) \|", PAGE, re.MULTILINE))


def test_the_page_lists_the_settings_and_no_others() -> None:
    assert [name.lower() for name in DOCUMENTED] == list(Settings.model_fields)


@pytest.mark.parametrize("name", sorted(Settings.model_fields))
def test_the_page_tells_each_default(name: str) -> None:
    default = Settings.model_fields[name].default
    told = DOCUMENTED[name.upper()].split()[0].rstrip(":")
    if default is None:
        assert told == "unset"
    elif isinstance(default, str):
        assert told == default
    else:
        assert float(told) == float(default)


@pytest.mark.parametrize("name", sorted(Settings.model_fields))
def test_each_setting_has_a_description(name: str) -> None:
    assert Settings.model_fields[name].description


def test_the_environment_sets(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNDERSTUDY_MAX_AUDIO_S", "7.5")
    assert read_settings().max_audio_s == 7.5


def test_every_wrong_variable_is_named_in_one_line(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("UNDERSTUDY_PORT", "many")
    monkeypatch.setenv("UNDERSTUDY_DEADLINE_S", "-1")
    with pytest.raises(InputError) as caught:
        read_settings()
    assert caught.value.code == "setting_wrong"
    assert "UNDERSTUDY_PORT" in caught.value.message
    assert "UNDERSTUDY_DEADLINE_S" in caught.value.message
    assert "\n" not in caught.value.message


def test_the_page_has_the_table_of_parts() -> None:
    rows = re.findall(r"^\| (\w+) \| (\d+) \|", PAGE, re.MULTILINE)
    assert {name: int(most_bytes) for name, most_bytes in rows} == PART_BYTES


def test_single_parts_may_be_larger_or_smaller() -> None:
    limits = Settings(part_bytes="bml=5, text=7").part_limits
    assert limits == {**PART_BYTES, "bml": 5, "text": 7}


@pytest.mark.parametrize(
    ("variable", "value", "reported"),
    [
        ("PART_BYTES", "bmll=5", "did you mean"),
        ("PART_BYTES", "bml=0", "write bml=BYTES"),
        ("PART_BYTES", "bml", "write bml=BYTES"),
        ("CLOSED", "metrics,doc", "'doc' cannot be closed"),
        ("MAX_BML_BYTES", "5", "set UNDERSTUDY_PART_BYTES=bml=BYTES"),
        ("METRICS", "0", "list it in UNDERSTUDY_CLOSED"),
        ("HEADER_S", "3", "UNDERSTUDY_IDLE_S"),
    ],
)
def test_wrong_and_former_settings_say_what_to_write(
    monkeypatch: pytest.MonkeyPatch, variable: str, value: str, reported: str
) -> None:
    monkeypatch.setenv(f"UNDERSTUDY_{variable}", value)
    with pytest.raises(InputError) as caught:
        read_settings()
    assert caught.value.code == "setting_wrong"
    assert f"UNDERSTUDY_{variable}: " in caught.value.message
    assert reported in caught.value.message
