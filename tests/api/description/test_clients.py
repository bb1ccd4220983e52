"""A Python client generated from the OpenAPI document reads what the service answers, later versions' answers too; the
TypeScript client has tests of its own (clients/typescript/)."""

import importlib.util
import json
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

from tests.api.description.test_document import DOCUMENT
from understudy.bml.writing.writer import write_bml
from understudy.model import Line
from understudy.models import Understudy
from understudy.options import Options
from understudy.performance import perform
from understudy.schemas.responses import PerformResponse

ROOT = Path(__file__).parents[3]
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
