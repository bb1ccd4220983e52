"""`lexicon/live.yaml`, and mistakes in it."""

from pathlib import Path

import pytest

from understudy.errors import AuthoringError
from understudy.files import resource_folder
from understudy.live.models import LiveModels
from understudy.live.table import LiveTable

SHIPPED = resource_folder("lexicon") / "live.yaml"


def test_the_shipped_table_is_in_use(models: LiveModels) -> None:
    assert "beat_gesture" in models.table.hands


def test_every_mistake_is_told_with_its_place(tmp_path: Path, models: LiveModels) -> None:
    path = tmp_path / "live.yaml"
    path.write_text(SHIPPED.read_text().replace("small_shake", "smal_shake").replace("half_nod", "no_nod"))
    with pytest.raises(AuthoringError) as raised:
        LiveTable.load(path, models.understudy.behavior.characters.behavior_names)
    told = [str(mistake) for mistake in raised.value.mistakes]
    assert len(told) == 2
    assert any("small_shake" in mistake and f"{path}:" in mistake for mistake in told)


def test_nothing_may_be_missing(tmp_path: Path) -> None:
    (tmp_path / "live.yaml").write_text("hands: []\n")
    with pytest.raises(AuthoringError):
        LiveTable.load(tmp_path / "live.yaml", ())
