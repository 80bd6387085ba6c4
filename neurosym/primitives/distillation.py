"""Distillation: from the symbol of an action back to parameters that can be performed.

After the section "Distilling Parameters" of the paper: the encoder is frozen, and gradient descent moves the
parameters of actions until their embedding is the +-1 code of the symbol. It starts from actions of the data
that already have the symbol: some of every kind of outcome they had, since rare ones are worth knowing, too.
"""

import numpy as np
import torch

from neurosym.checks import Float, check_count, check_kind, check_seed
from neurosym.data.interactions import Interactions
from neurosym.errors import InvalidValue, Progress
from neurosym.learning.coclustering import kmeans
from neurosym.learning.network import EffectModel, one_thread, tensor
from neurosym.operators import CONVERGED, Primitive, all_symbols, signs
from neurosym.world import ActionBox

_RATE, _MOMENTUM = 0.05, 0.9  # of a step, where the action box is scaled to [-1, 1]
_KINDS_OF_OUTCOME = 12
_STREAM = 0x6469  # keeps distillation's draws apart from those of other stages


def distill(
    model: EffectModel,
    interactions: Interactions,
    box: ActionBox,
    *,
    seed: int,
    candidates: int = 128,
    steps: int = 300,
    progress: Progress | None = None,
) -> tuple[Primitive, ...]:
    """Find for each action symbol parameters whose embedding is its code: the candidates to choose from.

    A symbol that no action of the data has is not used, and is left out. If no candidate of
    a symbol comes within `CONVERGED` of the code, the nearest one is returned. Where actions are choices, as
    the origin of the data says by `choices`, those of the data are the candidates, as they are.

    Args:
        model: Whose action encoder is inverted.
        interactions: The training data, from whose actions the search starts.
        box: What the parameters must stay inside.
        seed: Decides which of the actions.
        candidates: How many of them are started from, for each symbol; each leads to up to two.
        steps: How many steps of gradient descent.
        progress: Called after each step.

    Returns:
        Candidates in the order of their symbols, the nearest to its code first. Each encodes to its symbol;
        its `code_error` says how far its embedding still is from the code.

    Raises:
        InvalidValue: If something is not what it should be, or model, data and box have not the same widths.
    """
    check_kind("model", model, EffectModel, "an EffectModel, as train returns it in its `model`")
    check_kind("interactions", interactions, Interactions, "Interactions")
    check_kind("box", box, ActionBox, "an ActionBox, like a world's action_box")
    check_seed(seed)
    check_count("candidates", candidates)
    check_count("steps", steps, least=0)
    actions = np.asarray(interactions.actions)
    widths = model.dimensions.actions, actions.shape[1], len(box.low)
    if len(set(widths)) > 1:
        raise InvalidValue(
            f"The model reads {widths[0]} action parameters, the data have {widths[1]} and the box "
            f"{widths[2]}; valid: the same number."
        )
    rng, found = np.random.default_rng([seed, _STREAM]), np.array(model.action_symbols(actions))
    outcomes = np.column_stack([interactions.effects, interactions.peak_heights])
    outcomes = outcomes / np.maximum(outcomes.std(0), 1e-9)
    starts = {
        symbol: draw_of_every_kind(np.flatnonzero(found == symbol), outcomes, candidates, rng)
        for symbol in all_symbols(model.config.action_bits)
    }
    steps = 0 if interactions.origin.get("choices") else steps
    begin = np.concatenate([actions[rows] for rows in starts.values()])
    owners = np.repeat([*starts], [len(rows) for rows in starts.values()])
    ends = np.concatenate(_descend(model, begin, owners, box, steps, progress))
    owners = np.tile(owners, 2)
    errors = code_errors(model, ends, owners)
    errors[np.array(model.action_symbols(ends)) != owners] = np.inf
    return tuple(
        Primitive(symbol, tuple(ends[row].tolist()), float(errors[row]))
        for symbol in starts
        for row in _converged(np.flatnonzero(owners == symbol), errors)
    )


def _converged(rows: np.ndarray, errors: Float[np.ndarray, "N"]) -> list[int]:
    """Sort the rows by error, and keep those within `CONVERGED`, or else the best one if it is finite."""
    ordered: list[int] = rows[np.argsort(errors[rows], kind="stable")].tolist()
    within = [row for row in ordered if errors[row] < CONVERGED]
    return within or [row for row in ordered[:1] if np.isfinite(errors[row])]


def code_errors(
    model: EffectModel, actions: Float[np.ndarray, "N A"], symbols: np.ndarray
) -> Float[np.ndarray, "N"]:
    """Compute the mean squared error of each action's embedding to the +-1 code of its symbol."""
    targets = np.array([signs(symbol) for symbol in symbols])
    return np.asarray(((model.action_codes(actions) - targets) ** 2).mean(1), dtype=np.float64)


def encoded(model: EffectModel, actions: Float[np.ndarray, "N A"]) -> tuple[Primitive, ...]:
    """Return actions as primitives of the symbols that they have by themselves."""
    symbols = np.array(model.action_symbols(actions))
    rows = zip(symbols.tolist(), actions.tolist(), code_errors(model, actions, symbols).tolist(), strict=True)
    return tuple(Primitive(symbol, tuple(action), error) for symbol, action, error in rows)


def _descend(
    model: EffectModel,
    begin: Float[np.ndarray, "N A"],
    owners: np.ndarray,
    box: ActionBox,
    steps: int,
    progress: Progress | None,
) -> tuple[Float[np.ndarray, "N A"], ...]:
    """Descend the error of every candidate at once, projected into the box.

    Returned are, of each, the first on its way within `CONVERGED`, which so does most nearly what the action
    did that it started from; and the best.
    """
    middle, half = tensor((box.low + box.high) / 2), tensor((box.high - box.low) / 2).clamp(min=1e-9)
    targets = tensor(np.array([signs(symbol) for symbol in owners]))
    scaled = ((tensor(begin) - middle) / half).clamp(-1, 1).requires_grad_()
    optimiser = torch.optim.SGD([scaled], lr=_RATE, momentum=_MOMENTUM)
    best, best_errors = scaled.detach().clone(), torch.full((len(begin),), torch.inf)
    first = best.clone()
    was_training = model.training
    model.eval()
    with one_thread():
        for step in range(steps + 1):
            errors = ((model.embed_actions(middle + half * scaled) - targets) ** 2).mean(1)  # (N,)
            better = errors.detach() < best_errors
            searching = best_errors >= CONVERGED
            first[searching & better] = scaled.detach()[searching & better]
            best[better], best_errors[better] = scaled.detach()[better], errors.detach()[better]
            if step < steps:
                (scaled.grad,) = torch.autograd.grad(errors.sum(), scaled)
                optimiser.step()
                with torch.no_grad():
                    scaled.clamp_(-1, 1)
            if progress is not None:
                progress(step, steps)
    model.train(was_training)
    ends = [(middle + half * found).numpy().astype(np.float64) for found in (first, best)]
    return tuple(np.clip(found, box.low, box.high) for found in ends)


def draw_of_every_kind(
    rows: np.ndarray, outcomes: Float[np.ndarray, "N D"], count: int, rng: np.random.Generator
) -> np.ndarray:
    """Draw some of the rows, equally many of each kind of outcome as far as there are so many.

    Outcomes [on comparable scales] are those of all interactions, rows the numbers of some.
    """
    rows = rng.permutation(rows)
    if len(rows) <= count:
        return rows
    kinds = kmeans(outcomes[rows], _KINDS_OF_OUTCOME, rng)
    turns = np.empty(len(rows), dtype=int)
    for kind in np.unique(kinds):
        turns[kinds == kind] = np.arange(np.sum(kinds == kind))
    return np.asarray(rows[np.argsort(turns, kind="stable")[:count]])
