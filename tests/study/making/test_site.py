"""Modules of a page in its import map."""

import base64
import json
from collections import Counter
from itertools import pairwise
from pathlib import Path

import pytest

from understudy.errors import ServiceError
from understudy.study.making.site import Modules, packages_of, rater_orders, williams_square


def _write(root: Path, files: dict[str, str]) -> None:
    for name, content in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(content)


def _texts(root: Path, packages: dict[str, Path] | None = None) -> dict[str, str]:
    imports = json.loads(Modules(root, packages or {}).import_map(root / "page/main.js"))["imports"]
    prefix = "data:text/javascript;base64,"
    assert all(address.startswith(prefix) for address in imports.values())
    return {name: base64.b64decode(address.removeprefix(prefix)).decode() for name, address in imports.items()}


def test_relative_imports_are_named_by_their_paths(tmp_path: Path) -> None:
    _write(
        tmp_path,
        {
            "page/main.js": 'import { a } from "./a.js";\nimport "../shared/b.js";\nexport { c } from "./a.js";\n',
            "page/a.js": "import { b } from '../shared/b.js';\nexport const a = 'from here';\n",
            "shared/b.js": "export const b = 1;\n",
        },
    )
    assert _texts(tmp_path) == {
        "page/main.js": 'import { a } from "page/a.js";\nimport "shared/b.js";\nexport { c } from "page/a.js";\n',
        "page/a.js": "import { b } from 'shared/b.js';\nexport const a = 'from here';\n",
        "shared/b.js": "export const b = 1;\n",
    }


def test_packages_are_found_by_their_names_and_folders(tmp_path: Path) -> None:
    _write(
        tmp_path,
        {
            "page/main.js": 'import { Scene } from "three";\nimport { O } from "three/addons/o.js";\n',
            "vendor/three/three.js": 'export*from"./core.js";',
            "vendor/three/core.js": "export const Scene=1;",
            "vendor/three/addons/o.js": 'import{Scene}from"three";export const O=Scene;',
        },
    )
    packages = {"three": tmp_path / "vendor/three/three.js", "three/addons/": tmp_path / "vendor/three/addons"}
    found = _texts(tmp_path, packages)
    assert found["page/main.js"].startswith('import { Scene } from "vendor/three/three.js";')
    assert found["vendor/three/three.js"] == 'export*from"vendor/three/core.js";'
    assert found["vendor/three/addons/o.js"].startswith('import{Scene}from"vendor/three/three.js";')


def test_comments_import_nothing(tmp_path: Path) -> None:
    _write(tmp_path, {"page/main.js": '/** @import { A } from "./types.js" */\nexport const a = 1;\n'})
    assert list(_texts(tmp_path)) == ["page/main.js"]


def test_a_module_that_is_not_there_is_told(tmp_path: Path) -> None:
    _write(tmp_path, {"page/main.js": 'import "./none.js";\n'})
    with pytest.raises(ServiceError, match=r"none\.js is missing"):
        _texts(tmp_path)


def test_packages_are_those_of_the_studio(tmp_path: Path) -> None:
    page = tmp_path / "index.html"
    page.write_text(
        '<script type="importmap">{"imports": {"three": "./studio/v/three.js", "three/": "./studio/v/"}}</script>'
    )
    assert packages_of(page, "./studio/") == {"three": tmp_path / "v/three.js", "three/": tmp_path / "v"}


@pytest.mark.parametrize("count", range(1, 13))
def test_each_thing_is_in_each_place_equally_often(count: int) -> None:
    rows = williams_square(count)
    assert all(sorted(row) == list(range(count)) for row in rows)
    assert set(Counter((place, thing) for row in rows for place, thing in enumerate(row)).values()) == {
        len(rows) // count
    }


@pytest.mark.parametrize("count", range(2, 13))
def test_each_thing_comes_after_each_other_equally_often(count: int) -> None:
    rows = williams_square(count)
    follows = Counter(pair for row in rows for pair in pairwise(row))
    assert len(follows) == count * (count - 1)
    assert len(set(follows.values())) == 1


def test_three_clips_are_seen_in_all_six_orders() -> None:
    assert sorted(williams_square(3)) == [(0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)]


@pytest.mark.parametrize(("lines", "clips"), [(5, 3), (11, 2), (6, 3), (1, 2), (4, 3)])
def test_each_line_has_each_order_of_its_clips_equally_often(lines: int, clips: int) -> None:
    raters = rater_orders(lines, clips)
    assert all(sorted(line for line, _order in rater) == list(range(lines)) for rater in raters)
    orders = Counter(pair for rater in raters for pair in rater)
    assert len(orders) == lines * len(williams_square(clips))
    assert len(set(orders.values())) == 1


def test_a_rater_does_not_see_the_clips_in_one_order_alone() -> None:
    assert all(len({order for _line, order in rater}) > 1 for rater in rater_orders(5, 3))
