"""The rhythm of travelling: when steps fall, and how strongly pelvis, trunk and arms swing with them."""

from __future__ import annotations

from dataclasses import dataclass

from storyblender.blender.motion.channel import clamp, smooth


@dataclass(frozen=True)
class Gait:
    """The rhythm of a walk or run, for pelvis, trunk and arms.

    Attributes:
        start: Seconds.
        end: Seconds.
        step: Seconds of one step.
        amplitude: Strength of the swing, about 1.
        running: True for a run.
        offset: Stride phase at ``start``; 0 is the landing of the left foot.
        stoop: Degrees of bent trunk (sneaking).
    """

    start: float
    end: float
    step: float
    amplitude: float
    running: bool
    offset: float
    stoop: float = 0.0

    def phase(self, t: float) -> float:
        """Return the stride phase 0..1."""
        return ((t - self.start) / (2 * self.step) + self.offset) % 1

    def strength(self, t: float) -> float:
        """Return 0..amplitude: swings grow with the first step and die with the last."""
        grow = clamp((t - self.start) / self.step) * clamp((self.end - t) / (1.2 * self.step))
        return smooth(grow) * self.amplitude
