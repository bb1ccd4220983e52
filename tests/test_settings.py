"""Every setting is documented with its default, and a wrong one is told in one line."""

import re
from pathlib import Path

import pytest

from understudy.errors import InputError
from understudy.settings import PREFIX, Settings, read_settings

DOCUMENTED = dict(
    re.findall(
        rf"^\| `{PREFIX}(\w+)` \| (.*?) \|", (Path(__file__).parents[1] / "docs/settings.md").read_text(), re.MULTILINE
    )
)


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
