"""Shows the scores of motion models as tables and figures, beside the papers' scores (AHG §4, RTS §3.1)."""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING

from ...library.motion_models import Correlation, Scores

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

NAMES = MappingProxyType({"p": "f^p", "a": "f^a", "ap": "f^ap", "AP": "f^AP", "labels": "labels"})
THEIR_FEATURES: Mapping[str, tuple[float, float, float]] = MappingProxyType(
    {"ap": (0.66, 3.69, 7.26), "p": (0.41, 5.28, 7.30), "a": (0.64, 5.19, 8.29), "AP": (0.47, 4.25, 7.71)}
)
"""Correlation with the original movement, divergence of kinds and of durations (AHG Tables 2 and 3)."""

THEIR_SCENARIOS: Mapping[str, tuple[float, float, float, float]] = MappingProxyType(
    {
        "S1": (0.566, 0.520, 0.482, 0.516),
        "S2": (0.516, 0.449, 0.456, 0.483),
        "S3": (0.495, 0.354, 0.329, 0.308),
        "S4": (0.461, 0.292, 0.287, 0.299),
        "S5": (0.614, 0.585, 0.593, 0.588),
        "S6": (0.627, 0.545, 0.558, 0.541),
    }
)
"""Correlation with the original, with activation, valence and dominance (AHG Tables 4 and 5)."""

THEIR_SEARCHES: Mapping[tuple[int, int], tuple[float, int]] = MappingProxyType(
    {
        **{
            (10, n): each
            for n, each in enumerate(
                [
                    (0.4383, 51),
                    (0.4779, 56),
                    (0.5043, 57),
                    (0.5472, 57),
                    (0.6165, 59),
                    (0.7067, 57),
                    (0.7689, 59),
                    (0.8103, 59),
                    (0.8548, 59),
                    (0.8615, 59),
                ],
                start=3,
            )
        },
        **{
            (9, n): each
            for n, each in enumerate(
                [(0.6520, 59), (0.7050, 59), (0.7303, 59), (0.7660, 59), (0.8501, 62), (0.9724, 61), (0.7723, 63)],
                start=3,
            )
        },
        **{
            (8, n): each
            for n, each in enumerate(
                [(0.5723, 56), (0.6360, 51), (0.6525, 54), (0.6872, 55), (0.7417, 55), (0.8436, 59), (0.9610, 59)],
                start=3,
            )
        },
        **{
            (7, n): each
            for n, each in enumerate([(0.7331, 58), (0.8065, 60), (0.8393, 58), (0.8805, 59), (0.9754, 58)], start=3)
        },
        **{(6, n): each for n, each in enumerate([(0.8513, 58), (0.9066, 58), (0.9351, 56), (0.9663, 58)], start=3)},
        (5, 3): (0.8930, 64),
    }
)
"""Real-time factor and similarity in % by step m and number of best states n (RTS Tables 3.1 and 3.2)."""


def told(scores: Scores) -> str:
    """The tables, with the papers' scores beside ours."""
    return "\n".join(_lines(scores)) + "\n"


def _lines(scores: Scores) -> Iterator[str]:
    heard = f"{scores.recordings} recordings, {scores.minutes:.1f} min"
    yield f"{heard}; a {scores.left_out} is moved by a model of the others"
    yield "correlations: first canonical ones (deviation; chance: the same moved in time), by recording; together"
    yield "divergences: symmetric Kullback-Leibler, nats"
    yield ""
    yield "features  movement: theirs, ours; together        kinds: theirs, ours  durations: theirs, ours, kind by kind"
    for name, each in scores.features.items():
        theirs = THEIR_FEATURES.get(name)
        a, b, c = (f"{value:.2f}" for value in theirs) if theirs else ("–",) * 3
        own = each.movement
        yield (
            f"{NAMES[name]:8}  {a:>4}  {own.mean:.3f} ({own.deviation:.3f}; {own.chance:.3f}); {_together(own)}  "
            f"{b:>4}  {each.kinds:5.2f}          {c:>4}  {each.durations:5.2f}  {each.durations_by_kind:5.2f}"
        )
    yield ""
    yield f"kinetic energy of the arms, rad²/s²: recorded {scores.energy:.2f}"
    heading = "scenario  energy  difference  movement: theirs, ours (chance); together"
    yield f"{heading}  activation  valence  dominance: theirs/ours (chance)"
    for name, moved in scores.scenarios.items():
        known = THEIR_SCENARIOS.get(name)
        parts = [f"{value:.3f}" for value in known] if known else ["–"] * 4
        felt = "  ".join(
            f"{there}/{each.mean:.3f} ({each.chance:.3f})"
            for there, each in zip(parts[1:], moved.affect.values(), strict=True)
        )
        movement = f"{moved.movement.mean:.3f} ({moved.movement.chance:.3f}); {_together(moved.movement)}"
        yield (f"{name:8}  {moved.energy:6.2f}  {moved.energy_difference:10.2f}  {parts[0]:>5}  {movement}  {felt}")
    if scores.searches:
        yield from _searches(scores)


def _together(found: Correlation) -> str:
    return f"{found.together:.3f} ({found.together_by_chance:.3f})"


def _searches(scores: Scores) -> Iterator[str]:
    yield ""
    yield " m    n  real-time factor: theirs, ours  similarity in %: theirs, ours"
    for each in scores.searches:
        step, best = each.search.step, each.search.best
        there = THEIR_SEARCHES.get((step, best or 0))
        factor, share = (f"{there[0]:.4f}", str(there[1])) if there else ("–", "–")
        own = f"{each.real_time_factor:.4f}"
        yield f"{step:2} {best or 'all':>4}  {factor:>6}  {own}  {share:>20}  {100 * each.similarity:5.1f}"


def draw_scores(scores: Scores) -> bytes:
    """AHG's Figure 4 and Table 4 as bars, with the papers' scores beside ours, and RTS' Figures 3.1 and 3.2 if searches
    were tried, as PNG."""
    from matplotlib.figure import Figure

    rows = 2 if scores.searches else 1
    figure = Figure(figsize=(13, 4 * rows), layout="constrained")
    axes = figure.subplots(rows, 2, squeeze=False)
    _draw_scenarios(axes[0], scores)
    if scores.searches:
        _draw_searches(figure, axes[1], scores)
    content = io.BytesIO()
    figure.savefig(content, format="png")
    return content.getvalue()


def _draw_scenarios(axes: Sequence[Axes], scores: Scores) -> None:
    names, each = list(scores.scenarios), list(scores.scenarios.values())
    places = range(len(names))
    energy, movement = axes
    energy.bar(places, [score.energy_difference for score in each])
    energy.set(title="Difference of kinetic energy (AHG Fig. 4)", ylabel="rad²/s²")
    movement.bar([place - 0.2 for place in places], [score.movement.mean for score in each], 0.4, label="ours")
    theirs = [THEIR_SCENARIOS.get(name, (0.0,))[0] for name in names]
    movement.bar([place + 0.2 for place in places], theirs, 0.4, label="the paper's, on its data")
    movement.plot(places, [score.movement.chance for score in each], "k_", markersize=24, label="ours by chance")
    movement.set(title="Correlation with the original motion (AHG Table 4)", ylim=(0, 1))
    movement.legend(loc="lower right")
    for axis in axes:
        axis.set_xticks(list(places), names)


def _draw_searches(figure: Figure, axes: Sequence[Axes], scores: Scores) -> None:
    tried = scores.searches[1:]
    steps, bests = [each.search.step for each in tried], [each.search.best or 0 for each in tried]
    factors, shares = [each.real_time_factor for each in tried], [100 * each.similarity for each in tried]
    titles = ("Real-time factor (RTS Fig. 3.1)", "Similarity in % (RTS Fig. 3.2)")
    for axis, values, title in zip(axes, (factors, shares), titles, strict=True):
        shown = axis.scatter(steps, bests, c=values, s=260, marker="s", cmap="gray")
        axis.set(title=title, xlabel="step m", ylabel="best states n")
        figure.colorbar(shown, ax=axis)
