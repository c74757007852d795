"""The Asset Formatter: checks what was built against what was wanted, and says how to scale it.

The turning itself (which way is up, which way is front) is geometry and is done where the mesh is:
``geometry.canonical``, applied by ``blender.props.imported``. Here the measured asset is judged.
"""

from __future__ import annotations

from dataclasses import dataclass

from storyblender.geometry.canonical import unit_for
from storyblender.memory.asset_sheet import AssetDimension
from storyblender.memory.measure import AssetMeasure
from storyblender.reflection import Critique, Fault

OFF = 1.15
"""A dimension may be this many times too large or too small."""
MOST_FACES = 60_000
"""More slow every render and every key down."""


@dataclass(frozen=True)
class FormatView:
    """One built asset and the size it was wanted in."""

    measure: AssetMeasure
    wanted: AssetDimension | None = None


class Formatter:
    """The policy that mends size; a draft is the dimension to build to, None leaves the model as it is."""

    def propose(self, view: FormatView) -> AssetDimension | None:
        """Return the wanted dimension."""
        return view.wanted

    def refine(self, draft: AssetDimension | None, critique: Critique, view: FormatView) -> AssetDimension | None:
        """Return the dimension with the critic's numeric fix applied."""
        for fault in critique.faults:
            if "height" in fault.fix:
                return AssetDimension(height=float(fault.fix["height"]))
        return draft


class FormatCritic:
    """Judges a built asset: is it empty, of another unit, too heavy?"""

    def judge(self, draft: AssetDimension | None, view: FormatView) -> Critique:
        """Score the asset, with the fix for a wrong unit."""
        measure, faults = view.measure, []
        if measure.faces == 0 or max(measure.dimensions) <= 0:
            faults.append(Fault(kind="empty", message=f"{measure.asset_id} has no geometry", severity=9.0))
        elif draft is not None:
            faults += _size_faults(draft, measure)
        elif not 0.002 <= max(measure.dimensions) <= 120:
            height = measure.dimensions[2] * unit_for(max(measure.dimensions), 1.0)[1]
            faults.append(
                Fault(
                    kind="unit",
                    message=f"{measure.asset_id} is {max(measure.dimensions):.4g} m long: another unit was meant",
                    severity=4.0,
                    fix={"height": height},
                )
            )
        if measure.faces > MOST_FACES:
            faults.append(Fault(kind="heavy", message=f"{measure.asset_id} has {measure.faces} faces", severity=1.0))
        return Critique.of(tuple(faults))


def _size_faults(wanted: AssetDimension, measure: AssetMeasure) -> list[Fault]:
    goals = (("width", wanted.width), ("depth", wanted.depth), ("height", wanted.height))
    faults = []
    for (side, goal), size in zip(goals, measure.dimensions, strict=True):
        if goal is not None and not 1 / OFF <= size / goal <= OFF:
            message = f"{measure.asset_id} has a {side} of {size:.2f} m where {goal:.2f} m was wanted"
            height = measure.dimensions[2] * goal / max(size, 1e-6)
            faults.append(Fault(kind="size", message=message, severity=3.0, fix={"height": height}))
    return faults
