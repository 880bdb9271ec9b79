"""What is to be drawn: names of quantities, with patterns and `y vs x`, turned into curves."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from physsim.analysis.names import expanded
from physsim.recording import NotInFile, Trajectory
from physsim.recording.views import columns_of

Floats = NDArray[np.float64]
LEDGER = "energy"


@dataclass(frozen=True)
class Wish:
    """One thing to draw: a quantity over time, over another quantity (`over`), or the ledger of energies."""

    quantity: str
    over: str | None = None

    @property
    def is_ledger(self) -> bool:
        return self.quantity == LEDGER and self.over is None


@dataclass(frozen=True)
class Curve:
    """Numbers over numbers, with what stands at the axes.

    field: what the quantity is (`position`), owner: whose (`ball`), "" for the scene's.
    """

    label: str
    field: str
    unit: str
    kind: str
    x: Floats
    y: Floats
    owner: str = ""


def read_wishes(words: Sequence[str]) -> list[Wish]:
    """`["energy", "bodies.a.speed", "vs", "time"]` -> the ledger, and the speed over time.

    `y vs x` may be one word or three. Raises NotInFile for a `vs` without two sides.
    """
    text = "\n".join(word.strip() for word in words)
    text = re.sub(r"\s+vs\s+", "\0", text)
    wishes = []
    for part in text.split("\n"):
        sides = [side.strip() for side in part.split("\0")]
        if len(sides) > 2 or not all(sides) or "vs" in sides:
            raise NotInFile(f"{' vs '.join(sides)}: wants one quantity on each side of vs")
        wishes.append(Wish(*sides))
    return wishes


def curves_of(trajectory: Trajectory, wish: Wish, frames: slice) -> list[Curve]:
    """The curves of one wish: one per number and per body, joint or spring that a `*` stands for.

    Raises NotInFile for what the trajectory does not have; `y vs x` needs one number on each side.
    """
    if wish.over is None:
        return [
            curve
            for name in expanded(trajectory, wish.quantity)
            for curve in _over_time(trajectory, name, frames)
        ]
    sides = [_single(trajectory, name) for name in (wish.quantity, wish.over)]
    y, x = (trajectory.quantity(name, frames) for name in sides)
    found = [trajectory.find_quantity(name) for name in sides]
    labels = [
        f"{axis_word(each.text)} [{pretty(each.kind.unit)}]" if each.kind.unit else each.text
        for each in found
    ]
    return [
        Curve(wish.quantity, labels[0], "", labels[1], np.asarray(x, np.float64), np.asarray(y, np.float64))
    ]


def _single(trajectory: Trajectory, name: str) -> str:
    (found, *more) = expanded(trajectory, name)
    quantity = trajectory.find_quantity(found)
    if more or not quantity.is_scalar:
        parts = ", ".join(f"{name}.{part}" for part in quantity.components)
        hint = f" (one of {parts})" if quantity.components else ""
        raise NotInFile(f"{name}: vs needs one number on each side{hint}")
    return found


def _over_time(trajectory: Trajectory, name: str, frames: slice) -> Iterator[Curve]:
    quantity = trajectory.find_quantity(name)
    time = np.asarray(trajectory.time[frames], np.float64)
    owner = quantity.name or ""
    for text, values in columns_of(quantity, trajectory.quantity(name, frames)).items():
        part = text.rpartition(".")[2] if quantity.components else ""
        label = " ".join(word for word in (owner, quantity.field.replace("_", " "), part) if word)
        field = quantity.field.replace("_", " ")
        yield Curve(
            label, field, quantity.kind.unit, quantity.kind.name, time, np.asarray(values, np.float64), owner
        )


def axis_word(name: str) -> str:
    """`bodies.ball.position.z` -> `ball position z`."""
    return name.partition(".")[2].replace(".", " ").replace("_", " ") or name


def pretty(unit: str) -> str:
    """`kg*m^2/s` -> `kg·m²/s`."""
    return unit.replace("*", "·").replace("^2", "²").replace("^3", "³")
