"""The network of `understudy.acoustic.focus.focus_model` in torch, and how it is taught.

Each line's target is a distribution over its words: what has the focus shares it, less a little that goes to the words
in proportion to how emphasised listeners would find them; where no focus is known, all goes to them. The listeners'
judgement and the tilt of the spectrum are each withheld from a share of the lines, since live streams have neither, and
noise is added to all inputs.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from torch import Tensor, nn

from training.focus.hearing import HeardLine
from understudy.acoustic.focus.cues import CUES
from understudy.acoustic.focus.focus_model import INPUTS
from understudy.model import FloatArray

HIDDEN = 24
WORDS_AT_ONCE = 5, 3
DROPOUT = 0.2
WITHHELD = 0.3
NOISE = 0.1
BATCH = 64
RATE = 3e-3
DECAY = 1e-3
TO_LISTENERS = 0.1
"""The share of the target that goes to words in proportion to their emphasis, where a focus is known."""


@dataclass(frozen=True, slots=True)
class Lesson:
    """Inputs (words × inputs), what should be said of them (words,), and how much it counts."""

    given: FloatArray
    target: FloatArray
    weight: float

    @classmethod
    def of(cls, line: HeardLine, weight_without_focus: float) -> "Lesson":
        """What a line teaches."""
        odds = np.exp(line.emphasis - line.emphasis.max())
        heard = odds / odds.sum()
        if not line.focused.any():
            return cls(line.given, heard, weight_without_focus)
        return cls(line.given, (1 - TO_LISTENERS) * line.focused / line.focused.sum() + TO_LISTENERS * heard, 1.0)


class Network(nn.Module):  # type: ignore[misc]
    """Two convolutions over words and a sum, as numpy computes them at run time."""

    def __init__(self) -> None:
        super().__init__()
        first, second = WORDS_AT_ONCE
        self.first = nn.Conv1d(INPUTS, HIDDEN, first, padding=first // 2)
        self.second = nn.Conv1d(HIDDEN, HIDDEN, second, padding=second // 2)
        self.last = nn.Conv1d(HIDDEN, 1, 1)
        self.dropout = nn.Dropout(DROPOUT)

    def forward(self, given: Tensor, there: Tensor) -> Tensor:
        """Log shares (lines, words) of given (lines, inputs, words); `there` (lines, words): where lines have words."""
        known = there[:, None]
        heard = self.dropout(torch.relu(self.first(given * known)) * known)
        judged = self.dropout(torch.relu(self.second(heard)) * known)
        return torch.log_softmax(self.last(judged)[:, 0].masked_fill(~there, -1e9), 1)


def taught(lessons: Sequence[Lesson], *, seed: int, rounds: int) -> Network:
    """A network after so many rounds through the lessons."""
    torch.manual_seed(seed)
    random, network = np.random.default_rng(seed), Network()
    optimizer = torch.optim.AdamW(network.parameters(), lr=RATE, weight_decay=DECAY)
    steps = rounds * -(-len(lessons) // BATCH)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimizer, RATE, total_steps=steps)
    for _ in range(rounds):
        order = random.permutation(len(lessons))
        for first in range(0, len(order), BATCH):
            loss = _loss(network, [lessons[place] for place in order[first : first + BATCH]])
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
            schedule.step()
    network.eval()
    return network


def _loss(network: Network, lessons: Sequence[Lesson]) -> Tensor:
    """The weighed mean cross entropy; given without some of the listeners' judgements, and with noise."""
    longest = max(len(lesson.given) for lesson in lessons)
    given = torch.zeros(len(lessons), INPUTS, longest)
    target, there = torch.zeros(len(lessons), longest), torch.zeros(len(lessons), longest, dtype=torch.bool)
    for row, lesson in enumerate(lessons):
        count = len(lesson.given)
        given[row, :, :count] = torch.tensor(lesson.given.T)
        target[row, :count], there[row, :count] = torch.tensor(lesson.target), True
    given = given + NOISE * torch.randn_like(given)
    for column in (CUES.index("tilt"), len(CUES)):
        given[:, column] *= torch.rand(len(lessons), 1) > WITHHELD
    surprise = -(target * network(given, there).masked_fill(~there, 0)).sum(1)
    return (surprise * torch.tensor([lesson.weight for lesson in lessons])).mean()


def arrays(networks: Sequence[Network]) -> dict[str, FloatArray]:
    """The weights as `FocusModel` has them."""
    found = {}
    for name in ("first", "second", "last"):
        layers = [getattr(network, name) for network in networks]
        found[name] = np.stack([layer.weight.detach().numpy() for layer in layers])
        found[f"{name}_bias"] = np.stack([layer.bias.detach().numpy() for layer in layers])
    return found
