"""Clients generated from the OpenAPI document compile, and read what the service answers, later versions' too."""

import importlib.util
import json
import shutil
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from tests.api.description.test_document import DOCUMENT
from understudy.performance import Line, Options, Understudy, perform, write_bml
from understudy.schemas.responses import PerformResponse

ROOT = Path(__file__).parents[3]
TYPESCRIPT = ROOT / "tests" / "support" / "typescript"
AUDIO = ROOT / "tests" / "audio" / "figure8.flac"


@pytest.fixture(scope="module")
def document(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("document") / "openapi.json"
    path.write_text(json.dumps(DOCUMENT), encoding="utf-8")
    return path


@pytest.fixture(scope="module")
def python(document: Path) -> ModuleType:
    """The models that datamodel-code-generator makes."""
    target = document.with_name("models.py")
    options = [
        "--input-file-type",
        "openapi",
        "--output-model-type",
        "pydantic_v2.BaseModel",
        "--formatters",
        "builtin",
    ]
    generate = [sys.executable, "-m", "datamodel_code_generator", "--input", str(document), "--output", str(target)]
    subprocess.run([*generate, *options], check=True, capture_output=True)
    specification = importlib.util.spec_from_file_location("models", target)
    assert specification is not None
    assert specification.loader is not None
    module = importlib.util.module_from_spec(specification)
    sys.modules["models"] = module
    specification.loader.exec_module(module)
    return module


def test_python_models_know_the_options(python: ModuleType) -> None:
    options = python.PerformOptions(agitation="high", seed=7)
    assert json.loads(options.model_dump_json(exclude_none=True))["agitation"] == "high"
    with pytest.raises(ValueError, match="agitatoin"):
        python.PerformOptions(agitatoin="high")


def test_python_models_read_answers_with_fields_that_are_new_to_them(
    python: ModuleType, understudy: Understudy
) -> None:
    performance = perform(understudy, Line(AUDIO.read_bytes(), AUDIO.with_suffix(".txt").read_text("utf-8")), Options())
    answer = json.loads(PerformResponse.of(performance, write_bml(performance)).to_json())
    answer["new"] = answer["performance"]["new"] = answer["performance"]["words"][0]["new"] = 1
    read = python.PerformResponse.model_validate(answer)
    assert [word.text for word in read.performance.words] == AUDIO.with_suffix(".txt").read_text("utf-8").split()
    unknown = {"type": "x", "title": "x", "status": 422, "code": "a_new_one", "detail": "x"}
    assert python.Problem.model_validate(unknown).code == "a_new_one"


@pytest.fixture(scope="module")
def tools(pytestconfig: pytest.Config) -> Path:
    """The folder in which openapi-typescript and the compiler are installed, once for several runs."""
    if not shutil.which("npm"):
        pytest.skip("node with npm is not installed")
    folder = pytestconfig.rootpath / ".pytest_cache" / "typescript"
    lock = (TYPESCRIPT / "package-lock.json").read_bytes()
    if (folder / "installed").exists() and (folder / "installed").read_bytes() == lock:
        return folder
    folder.mkdir(parents=True, exist_ok=True)
    for name in ("package.json", "package-lock.json"):
        shutil.copy(TYPESCRIPT / name, folder)
    try:
        subprocess.run(["npm", "ci", "--no-audit"], cwd=folder, check=True, capture_output=True, timeout=240)
    except (subprocess.CalledProcessError, subprocess.TimeoutExpired):
        pytest.skip("openapi-typescript and typescript cannot be installed from npm here")
    (folder / "installed").write_bytes(lock)
    return folder


def test_a_typescript_client_compiles(tools: Path, document: Path) -> None:
    folder, binaries = document.parent, tools / "node_modules" / ".bin"
    subprocess.run(
        [binaries / "openapi-typescript", document, "-o", folder / "api.d.ts"], check=True, capture_output=True
    )
    shutil.copy(TYPESCRIPT / "client.ts", folder)
    compile_it = [
        str(binaries / "tsc"),
        "--strict",
        "--noEmit",
        "--noUncheckedIndexedAccess",
        "--target",
        "es2022",
        "client.ts",
    ]
    done = subprocess.run(compile_it, cwd=folder, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout) == (0, "")
