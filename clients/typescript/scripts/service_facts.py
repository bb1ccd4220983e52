"""Writes what the client is generated from, as JSON on standard output: the service's OpenAPI document, and the joint
names of every rig by ours. `generate.js` runs it; understudy must be installed.
"""

import json
import sys

from fastapi import FastAPI

from understudy.api.description.document import describe
from understudy.api.routes import router
from understudy.files import resource_folder
from understudy.realizer.body.skeleton import Skeleton
from understudy.realizer.exporting.retargeting import load_rigs


def facts() -> dict[str, object]:
    """`openapi`, without a version that would differ at each release, and `rigs`."""
    app = FastAPI(title="Understudy", version="any")
    app.include_router(router)
    describe(app)
    rigs = load_rigs(resource_folder("lexicon") / "retarget", Skeleton.standing())
    return {"openapi": app.openapi(), "rigs": {name: dict(rig.names) for name, rig in rigs.items()}}


if __name__ == "__main__":
    json.dump(facts(), sys.stdout, ensure_ascii=False, sort_keys=True)
