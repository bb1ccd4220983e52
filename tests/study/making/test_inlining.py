"""Modules of a page in its import map."""

import base64
import json
from pathlib import Path

import pytest

from understudy.errors import ServiceError
from understudy.study.making.inlining import Modules, packages_of


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
