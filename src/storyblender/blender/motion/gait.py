"""The rhythm of a walk or run: stride phase, and how strongly pelvis, trunk and arms swing."""

from __future__ import annotations

from dataclasses import dataclass

from storyblender.blender.motion.channel import clamp, smooth


@dataclass(frozen=True)
class Gait:
    """The rhythm of one walk or run.

    Attributes:
        start: Seconds.
        end: Seconds.
        step: Seconds of one step.
        amplitude: Strength of the swing of pelvis, trunk and arms; about 1.
        running: True for a run.
        offset: Stride phase at ``start``; 0 is the landing of the left foot.
        stoop: Degrees by which the trunk is bent forward (sneaking).
    """

    start: float
    end: float
    step: float
    amplitude: float
    running: bool
    offset: float
    stoop: float = 0.0

    def phase(self, t: float) -> float:
        """Return the stride phase at ``t`` seconds, 0..1; one stride is two steps."""
        return ((t - self.start) / (2 * self.step) + self.offset) % 1

    def strength(self, t: float) -> float:
        """Return the strength of the swing at ``t`` seconds, 0..amplitude: it grows, then fades."""
        grow = clamp((t - self.start) / self.step) * clamp((self.end - t) / (1.2 * self.step))
        return smooth(grow) * self.amplitude
