"""`understudy motion-model`: learns motion from recordings of speech with their motion, and tells how near a model's
own motion comes to theirs (docs/motion-models.md)."""

import argparse
from pathlib import Path

from ...errors import InputError
from ...library.motion_models import read_pairs, train_motion_model
from ...models import load_realizer
from ...option_table import LARGEST_SEED
from ...settings import read_settings
from ..files import require_writable, write
from ..log import Log


def run(arguments: argparse.Namespace, log: Log) -> int:
    return _ACTIONS[arguments.action](arguments, log)


def _train(arguments: argparse.Namespace, log: Log) -> int:
    require_writable(arguments.output, field="output")
    if arguments.kinds is not None and not 2 <= arguments.kinds <= MOST_KINDS:
        raise InputError("value_wrong", f"--kinds {arguments.kinds}; give 2 to {MOST_KINDS}", field="kinds")
    if not 0 <= arguments.seed <= LARGEST_SEED:
        raise InputError("value_wrong", f"--seed {arguments.seed}; give 0 to {LARGEST_SEED}", field="seed")
    pairs = read_pairs(Path(arguments.folder), load_realizer(), read_settings(), log.stage)
    model = train_motion_model(pairs, kinds=arguments.kinds, seed=arguments.seed, progress=log.stage)
    content = model.content()
    write(arguments.output, content)
    parts = f"{len(model.units)} units that move {len(model.joints)} joints, {len(content) / 1000:.0f} kB"
    log.note(f"{arguments.output}: {model.about}; {parts}")
    return 0


MOST_KINDS = 200
_ACTIONS = {"train": _train}
