"""`understudy motion-model`: learns a motion model from recordings of speech with motion, and measures the similarity
of its motion to theirs (docs/motion-models.md)."""

import argparse
import json
import sys
from dataclasses import asdict
from pathlib import Path

from ...errors import InputError
from ...library.motion_models import Search, read_pairs, scenario_named, score_motion_models, train_motion_model
from ...model.performance import Progress
from ...models import load_realizer
from ...option_table import LARGEST_SEED
from ...settings import read_settings
from ..files import require_writable, write
from ..log import Log
from ..outputs.motion_scores import THEIR_SEARCHES, draw_scores, told
from ..outputs.plot import require_plot


def run(arguments: argparse.Namespace, log: Log) -> int:
    return _ACTIONS[arguments.action](arguments, log)


def _train(arguments: argparse.Namespace, log: Log) -> int:
    require_writable(arguments.output, field="output")
    _check(arguments)
    pairs = read_pairs(Path(arguments.folder), load_realizer(), read_settings(), _progress(log))
    model = train_motion_model(pairs, kinds=arguments.kinds, seed=arguments.seed, progress=_progress(log))
    content = model.content()
    write(arguments.output, content)
    parts = f"{len(model.units)} units that move {len(model.joints)} joints, {len(content) / 1000:.0f} kB"
    log.note(f"{arguments.output}: {model.about}; {parts}")
    return 0


def _score(arguments: argparse.Namespace, log: Log) -> int:
    for output in filter(None, (arguments.output, arguments.plot)):
        require_writable(output, field="output")
    if arguments.plot:
        require_plot(arguments.plot)
    _check(arguments)
    scenarios = [scenario_named(name).name for name in arguments.scenario]
    pairs = read_pairs(Path(arguments.folder), load_realizer(), read_settings(), _progress(log))
    chosen = {"scenarios": scenarios} if scenarios else {}
    searches = [Search(step, best) for step, best in THEIR_SEARCHES] if arguments.search else []
    scores = score_motion_models(
        pairs, kinds=arguments.kinds, seed=arguments.seed, searches=searches, progress=_progress(log), **chosen
    )
    sys.stdout.write(told(scores))
    if arguments.output:
        write(arguments.output, json.dumps(asdict(scores), indent=2).encode() + b"\n")
    if arguments.plot:
        write(arguments.plot, draw_scores(scores))
    return 0


def _progress(log: Log) -> Progress:
    """Reports the progress in the log's voice."""

    def tell(stage: str) -> None:
        log.stage(stage)
        log.progress(stage)

    return tell


def _check(arguments: argparse.Namespace) -> None:
    """Raises InputError `value_wrong`."""
    if arguments.kinds is not None and not 2 <= arguments.kinds <= MOST_KINDS:
        raise InputError("value_wrong", f"--kinds {arguments.kinds}; give 2 to {MOST_KINDS}", field="kinds")
    if not 0 <= arguments.seed <= LARGEST_SEED:
        raise InputError("value_wrong", f"--seed {arguments.seed}; give 0 to {LARGEST_SEED}", field="seed")


MOST_KINDS = 200
_ACTIONS = {"train": _train, "score": _score}
