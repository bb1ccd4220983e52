"""Anneals the reader on careful lines, with second readings and with what it read before.

    python -m training.acting.annealing OUT.npz [--minutes 50] [--seed N] [--measured FILE.json]
    python -m training.acting.annealing OUT.npz --quick-share 0.3 [--other-share 0.25] [--careful-worth 0.8]
    python -m training.acting.annealing OUT.npz --from MODEL.onnx --taught --pace 7 [--delivery-share 0.5]
    python -m training.acting.annealing OUT.npz --from MODEL.onnx --without npc previs [--pace 2]
    python -m training.acting.annealing OUT.npz --only face --pace 3 --minutes 4
    python -m training.acting.annealing OUT.npz --only head face --own 2 --from MODEL.onnx --taught --pace 8

It begins with the shipped weights. Where a line was read twice (`lines/second/`), it is trained towards the mean of
both readings, and every target is drawn for `TAUGHT` of its way to what the shipped reader makes of the same line: one
reading is one opinion of many, and what was learnt from thousands of other lines is not to be lost. Where a line was
read with care (`lines/careful/`), these readings count `--careful-worth` of the whole, the others the rest, and less is
taught (`TAUGHT_CAREFUL`); of its head and face those readings that are of them alone (`lines/heads/`, `lines/faces/`)
count `--heads-alone` and `--faces-alone`. With `--other-share` each epoch has only that share of all other lines. Some
lines are cut at the end of a sentence, some are joined, and some pieces are hidden, so that the reader depends on none.
The rate falls to nearly 0 within the given time; OUT gets the running mean of the weights. With `--from` it begins with
a model of before (the last that knew no line of our kinds is models/acting/encoder.onnx of commit e589ed7d), and nobody
teaches it, but for `--taught`: what it has never been shown of the kinds `--without` can then be measured. One that has
read the careful readings learns less from them a second time: the last that had not is that of commit 60175ecb. Who
teaches is the shipped reader or `--teacher`, how much says `--taught-share`. With `--only` nothing changes but the
outputs of head or face, and nobody teaches but for `--taught`; with `--own` as many last layers are trained with them,
which begin as those of the model `--from` and stand on the first layers of the shipped one (`exporting.py` puts them
beside its last). What is heard of a delivery is guessed, or drawn from what was measured in recordings
(`training/acting/recordings.py`); only then, and where nobody teaches, are the weights of what is heard trained too.
With `--quick-share` each epoch has only that share of the lines of `QUICK`, with `--delivery-share` that of the
deliveries, whose words come two to four times in an epoch otherwise. An eighth of the lines is held out, as in
`training/acting/encoder.py`, whose needs it has, and all that three directors read; told is the loss on those of them
that were read with care.
"""

import argparse
import random
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import torch
from torch import Tensor, nn

from understudy.behavior.reading.encoder import WORDS_ALONE, Delivery
from understudy.model import SingleArray

from .augmentation import cut, joined, with_hidden
from .directed import CHANNELS, MANNER, OUTPUTS
from .encoder import (
    BATCH,
    SHIPPED,
    SIZES,
    WEIGHT_DECAY,
    Encoded,
    batches_of,
    inputs_of,
    loss_of,
    starting_weights,
)
from .graph import TRUNK, layer_of
from .listening import as_written, heard
from .material import ALONE_WORTH, CAREFUL_WORTH, Material, material
from .network import Reader, head_network, with_head_network

RATE, OUTPUT_FACTOR, EMBEDDING_FACTOR, LAYER_FACTOR = 5e-5, 4.0, 0.4, 0.85
"""Of the last layer; of the outputs and of the embeddings beside it; of each layer beside the one above it."""

OUTPUT_WEIGHTS = ("out", "out/bias", "direct")
WARM_UP_STEPS, LEAST_RATE = 40, 0.02
CUT, JOINED = 0.12, 0.08
SHORT_PIECES = 30
DROPOUT = 0.0
"""What helps where a network learns anew takes away here: the reader begins near its end. With 10,555 careful lines and
--pace 3 the loss on held-out lines is at best 5.97 with .1, 5.96 with .03 and 5.94 without."""

MEAN_OF_STEPS = 100
TOLD_EVERY_S = 240.0
CALIBRATED_BY, FEW = 1600, 6.0
"""The lines by which biases are set at the start, and what is added to both sums of an output."""

Told = tuple[Encoded, Delivery]
"""A line, and what is heard of it."""


def calibrate(reader: Reader, given: Material) -> SingleArray:
    """Sets the biases of the outputs so that as much is expected as careful readings want, by words alone: readers
    differ in what they like, and an optimizer moves a bias by no more than its rate in a step. Returns by how much."""
    lines = [each for each in given.kept if each.line.name in given.with_care and not each.line.is_delivery]
    random.Random(0).shuffle(lines)
    outputs = sum(SIZES) - len(MANNER)
    read, wanted = (np.full(outputs, FEW) for _sum in range(2))
    reader.eval()
    with torch.no_grad():
        for first in range(0, min(len(lines), CALIBRATED_BY), BATCH):
            batch = lines[first : first + BATCH]
            likely = torch.sigmoid(reader(*inputs_of(batch, [WORDS_ALONE] * len(batch)))).numpy()
            for each, own in zip(batch, likely, strict=True):
                counted = each.counts[:, :outputs] > 0
                read += (counted * own[: len(each.ends), :outputs]).sum(axis=0)
                wanted += (counted * each.wanted[:, :outputs]).sum(axis=0)
        more = np.zeros(OUTPUTS, np.float32)
        more[:outputs] = np.log(wanted / read)
        reader.weights["out/bias"] += torch.from_numpy(more)
    reader.train()
    return more


def train_only(reader: Reader, channels: Sequence[str], own: int) -> None:
    """Leaves all weights as they are but those that give the outputs of `channels`, and the last `own` layers."""
    trained = torch.zeros(OUTPUTS)
    for channel in channels:
        trained[CHANNELS[channel]] = 1
    for name, each in reader.weights.items():
        of_last_layers = TRUNK - own <= layer_of(name.replace("/", ".")) < TRUNK
        each.requires_grad_(name in OUTPUT_WEIGHTS or of_last_layers)
        if name in OUTPUT_WEIGHTS:
            each.register_hook(lambda gradient: gradient * trained.view(-1, *[1] * (gradient.ndim - 1)))


def anneal(reader: Reader, given: Material, minutes: float, seed: int, *, pace: float = 1.0) -> Mapping[str, Tensor]:
    """Trains for that time; the running mean of the weights."""
    chance = random.Random(seed)
    optimizer = _optimizer(reader, pace)
    rates = [group["lr"] for group in optimizer.param_groups]
    mean = {name: each.detach().clone() for name, each in reader.weights.items()}
    began_s = told_s = time.monotonic()
    for step, batch in enumerate(_endless(given, chance)):
        share = (time.monotonic() - began_s) / (60 * minutes)
        if share >= 1:
            break
        for group, rate in zip(optimizer.param_groups, rates, strict=True):
            group["lr"] = rate * min(1.0, (step + 1) / WARM_UP_STEPS) * max(LEAST_RATE, 1 - share)
        lines, told = [each for each, _ in batch], [delivery for _, delivery in batch]
        if given.teacher:
            lines = _taught(lines, told, given, given.teacher)
        _step(reader, optimizer, loss_of(reader, lines, told))
        _follow(mean, reader, min(1 - 1 / MEAN_OF_STEPS, step / (step + 20)))
        if time.monotonic() - told_s > TOLD_EVERY_S:
            told_s = time.monotonic()
            print(f"step {step + 1}: {_held_out(reader, mean, given)}", flush=True)
    print(f"end: {_held_out(reader, mean, given)}", flush=True)
    return mean


def _step(reader: Reader, optimizer: torch.optim.Optimizer, loss: Tensor) -> None:
    optimizer.zero_grad()
    loss.backward()
    nn.utils.clip_grad_norm_(reader.parameters(), 1.0)
    optimizer.step()


def _follow(mean: dict[str, Tensor], reader: Reader, decay: float) -> None:
    with torch.no_grad():
        for name, each in reader.weights.items():
            if each.requires_grad:
                mean[name].lerp_(each, 1 - decay)


def _taught(lines: Sequence[Encoded], told: Sequence[Delivery], given: Material, teacher: Reader) -> list[Encoded]:
    """The lines with their targets drawn towards what the teacher reads."""
    with torch.no_grad(), torch.autocast("cpu", torch.bfloat16):
        logits = teacher(*inputs_of(lines, told)).numpy()
    if given.more is not None:
        logits = logits + given.more
    taught = []
    for each, own in zip(lines, logits, strict=True):
        share, read = given.taught(each.line), 1 / (1 + np.exp(-own[: len(each.ends)]))
        wanted = np.asarray((1 - share) * each.wanted + share * read, np.float32)
        taught.append(replace(each, wanted=wanted))
    return taught


def _endless(given: Material, chance: random.Random) -> Iterator[list[Told]]:
    """Batches of lines of about the same length, epoch after epoch."""
    mask = given.vocabulary.get("[MASK]", given.vocabulary["[UNK]"])
    while True:
        for batch in batches_of(list(_epoch(given, chance)), chance, lambda told: len(told[0].pieces)):
            yield [(with_hidden(each, mask, chance), told) for each, told in batch]


def _epoch(given: Material, chance: random.Random) -> Iterator[Told]:
    """The lines of an epoch and what is heard of them, some of them cut, some joined."""
    singles: list[Encoded] = []
    for each in given.kept:
        if chance.random() >= given.share(each.line):
            continue
        lot = 1.0 if each.line.is_delivery else chance.random()
        if lot < CUT:
            yield cut(each, chance), WORDS_ALONE
        elif lot < CUT + JOINED and len(each.pieces) < SHORT_PIECES:
            singles.append(each)
        else:
            yield each, heard(each.line, given.voices, chance)
    chance.shuffle(singles)
    for first, second in zip(singles[::2], singles[1::2], strict=False):
        yield joined(first, second), WORDS_ALONE


def _optimizer(reader: Reader, pace: float) -> torch.optim.Optimizer:
    """The weights by rate: outputs quicker than layers, lower layers slower."""
    groups: dict[tuple[float, float], list[nn.Parameter]] = {}
    for name, each in reader.weights.items():
        layer = layer_of(name.replace("/", "."))
        if not each.requires_grad:
            continue
        if name in OUTPUT_WEIGHTS:
            key = (OUTPUT_FACTOR * RATE, 0.0)
        elif layer >= 0:
            decayed = each.ndim > 1 and not name.endswith("norm")
            key = (RATE * LAYER_FACTOR ** max(0, TRUNK - 1 - layer), WEIGHT_DECAY if decayed else 0.0)
        else:
            key = (EMBEDDING_FACTOR * RATE, 0.0)
        groups.setdefault(key, []).append(each)
    return torch.optim.AdamW(
        [{"params": each, "lr": pace * key[0], "weight_decay": key[1]} for key, each in groups.items()]
    )


def _held_out(reader: Reader, mean: Mapping[str, Tensor], given: Material) -> str:
    """The loss of the running mean on deliveries and on lines."""
    own = {name: each.detach().clone() for name, each in reader.weights.items()}
    _set(reader, mean)
    reader.eval()
    chance = random.Random(0)
    told = []
    with torch.no_grad():
        for name, deliveries in (("deliveries", True), ("lines", False)):
            lines = [each for each in given.checked if each.line.is_delivery is deliveries]
            batches = [lines[first : first + BATCH] for first in range(0, len(lines), BATCH)]
            losses = [
                loss_of(reader, each, [as_written(one.line, given.voices, chance) for one in each]) for each in batches
            ]
            told.append(f"{name} {np.mean([float(each) for each in losses]):.4f}")
    _set(reader, own)
    reader.train()
    return ", ".join(told)


def _set(reader: Reader, weights: Mapping[str, Tensor]) -> None:
    with torch.no_grad():
        for name, each in reader.weights.items():
            each.copy_(weights[name])


def main() -> None:
    arguments = _arguments()
    torch.set_num_threads(1)
    torch.manual_seed(arguments.seed)
    weights, vocabulary = starting_weights(arguments.start or SHIPPED)
    if arguments.own:
        weights = head_network(with_head_network(starting_weights(SHIPPED)[0], head_network(weights), arguments.own))
    reader = Reader(weights, dropout=arguments.dropout)
    alone = not arguments.taught and (bool(arguments.only) or arguments.start is not None)
    reader.weights["heard"].requires_grad_(arguments.measured is not None or alone)
    if arguments.only:
        train_only(reader, arguments.only, arguments.own)
    given = replace(
        material(
            arguments.directing,
            vocabulary,
            arguments.measured,
            without=arguments.without,
            teacher=None if alone else arguments.teacher,
            careful_worth=arguments.careful_worth,
            only=arguments.only,
            alone_worth={"head": arguments.heads_alone, "face": arguments.faces_alone},
        ),
        quick_share=arguments.quick_share,
        other_share=arguments.other_share,
        delivery_share=arguments.delivery_share,
        taught_share=arguments.taught_share,
    )
    print(f"{len(given.kept)} lines, {len(given.with_care)} read with care; {len(given.checked)} held out", flush=True)
    if given.with_care and not arguments.without and (arguments.own or not arguments.only):
        more = calibrate(reader, given)
        given = given if arguments.start else replace(given, more=more)
        print(f"calibrated: {_held_out(reader, dict(reader.weights), given)}", flush=True)
    _set(reader, anneal(reader, given, arguments.minutes, arguments.seed, pace=arguments.pace))
    np.savez(arguments.output, allow_pickle=False, **reader.exported())


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--minutes", type=float, default=50.0)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--measured", type=Path, help="what the analysis measured in recordings")
    parser.add_argument("--directing", type=Path, default=Path("../shared/directing"))
    parser.add_argument(
        "--from", dest="start", type=Path, help="a model of before, which nobody teaches but for --taught"
    )
    parser.add_argument("--taught", action="store_true", help="the teacher teaches the model of before too")
    parser.add_argument("--taught-share", type=float, help="how far all targets are drawn towards what is taught")
    parser.add_argument("--teacher", type=Path, default=SHIPPED, help="a model that teaches instead of the shipped one")
    parser.add_argument(
        "--only", nargs="+", choices=CHANNELS, default=[], help="channels whose outputs alone are trained"
    )
    parser.add_argument("--own", type=int, default=0, help="how many last layers the channels have for themselves")
    parser.add_argument("--without", nargs="+", default=[], help="kinds of lines that are left out")
    parser.add_argument("--quick-share", type=float, default=1.0, help="in how many epochs quickly read lines are")
    parser.add_argument("--other-share", type=float, default=1.0, help="in how many epochs lines read without care are")
    parser.add_argument("--delivery-share", type=float, default=1.0, help="in how many epochs deliveries are")
    parser.add_argument("--careful-worth", type=float, default=CAREFUL_WORTH, help="what readings made with care count")
    for channel, worth in ALONE_WORTH.items():
        parser.add_argument(f"--{channel}s-alone", type=float, default=worth, help=f"what {channel}s read alone count")
    parser.add_argument("--pace", type=float, default=1.0, help="a factor of the learning rates")
    parser.add_argument("--dropout", type=float, default=DROPOUT, help="the share of the states that is left out")
    arguments = parser.parse_args()
    if arguments.taught and not arguments.start:
        parser.error("--taught goes with --from: without it the reader is always taught")
    if arguments.own and not arguments.only:
        parser.error("--own goes with --only: the layers are those of some channels")
    return arguments


if __name__ == "__main__":
    main()
