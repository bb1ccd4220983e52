from pathlib import Path

import pytest

from understudy.behavior.listeners.head_rates import HeadRates
from understudy.errors import AuthoringError

GOOD = """\
nods_after_pause: 0.2
nods_after_phrase: 0.1
mirrored: 0
delay_s: 0.5
delay_spread_s: 0.3
"""


def test_rates_are_read(tmp_path: Path) -> None:
    (tmp_path / "head_rates.yaml").write_text(GOOD, encoding="utf-8")
    assert HeadRates.load(tmp_path / "head_rates.yaml") == HeadRates(0.2, 0.1, 0.0, 0.5, 0.3)


def test_every_mistake_is_told_with_its_line(tmp_path: Path) -> None:
    wrong = GOOD.replace("0.2", "1.2").replace("delay_s: 0.5", "delay_s: soon").replace("mirrored", "mirored")
    (tmp_path / "head_rates.yaml").write_text(wrong, encoding="utf-8")
    with pytest.raises(AuthoringError) as caught:
        HeadRates.load(tmp_path / "head_rates.yaml")
    assert {mistake.line for mistake in caught.value.mistakes} >= {1, 3, 4}
