"""Anchors of props: seats, beds, grips, handles, and edges to lean on. A prop's front is -Y; lengths are metres.

A right hand comes from -X: its palm looks to +X, its fingers to -Y. Every grip has its mirror image for the left.
"""

from __future__ import annotations

from storyblender.memory.asset_sheet import Anchor
from storyblender.memory.base import Vec2, Vec3

Anchors = tuple[Anchor, ...]

FIST: Vec3 = (0.9, 0.9, 0.5)
"""Curl of a hand around a handle."""
PINCH: Vec3 = (0.55, 0.65, 0.6)
"""Curl of a hand that holds something small between thumb and finger."""
WRAP: Vec3 = (0.5, 0.55, 0.35)
"""Curl of a hand around a tumbler."""


def seat(
    location: Vec3,
    size: Vec2,
    direction: Vec3 = (0.0, -1.0, 0.0),
    name: str = "",
    headroom: float | None = None,
) -> Anchor:
    """Return a seat.

    Args:
        location: Middle of its front edge, at sitting height.
        size: Width and depth.
        direction: Where the sitter faces.
        name: Tells the seats of one prop apart.
        headroom: Metres from it to the ceiling above; None in the open.
    """
    return Anchor(kind="seat", name=name, location=location, direction=direction, size=size, clearance=headroom)


def part(name: str, location: Vec3, size: Vec3) -> Anchor:
    """Return a part of a prop that people look at or touch.

    Args:
        name: A key of ``catalog.parts``, such as ``steering_wheel``.
        location: Its middle.
        size: Its width, depth and height.
    """
    (x, y, z), (width, depth, height) = location, size
    return Anchor(kind="part", name=name, location=(x, y, z - height / 2), size=(width, depth), clearance=height)


def panel(name: str, location: Vec3, size: Vec3) -> Anchor:
    """Return a panel that a shot can hide, built under ``MeshBuilder.panel`` of the same name; as ``part``."""
    return part(name, location, size).model_copy(update={"kind": "panel"})


def seats_in_row(count: int, width: float, front: float, height: float, depth: float) -> Anchors:
    """Return seats side by side, all facing -Y, named ``seat_1``, ``seat_2`` ... from -X on.

    Args:
        count: How many.
        width: Of the whole row.
        front: Y of their front edge.
        height: Sitting height.
        depth: Of each seat.
    """
    step = width / count
    places = [(i - (count - 1) / 2) * step for i in range(count)]
    return tuple(seat((x, front, height), (step, depth), name=f"seat_{i + 1}") for i, x in enumerate(places))


def lean(location: Vec3, width: float, direction: Vec3 = (0.0, 1.0, 0.0), name: str = "") -> Anchor:
    """Return a rail or edge to lean on.

    Args:
        location: Its middle.
        width: How long it is.
        direction: Where the leaning person faces.
        name: Tells the edges of one prop apart.
    """
    return Anchor(kind="lean", name=name, location=location, direction=direction, size=(width, 0.0))


def grip(name: str, location: Vec3, fingers: Vec3, palm: Vec3, curl: Vec3) -> Anchor:
    """Return a grip.

    Args:
        name: Ends in ``_r`` or ``_l`` for the hand it is made for; see ``two_hands``.
        location: Palm centre.
        fingers: Direction of the fingers.
        palm: The palm's normal, into the object.
        curl: 0..1 of index, other fingers, thumb.
    """
    return Anchor(kind="grip", name=name, location=location, direction=fingers, normal=palm, curl=curl)


def two_hands(location: Vec3, fingers: Vec3, palm: Vec3, curl: Vec3, name: str = "grip") -> Anchors:
    """Return a grip for the right hand and its mirror image for the left.

    Args:
        location: Palm centre of the right hand.
        fingers: Direction of its fingers.
        palm: Its palm's normal, into the object.
        curl: 0..1 of index, other fingers, thumb.
        name: The grips are called ``<name>_r`` and ``<name>_l``.
    """

    def mirrored(vector: Vec3) -> Vec3:
        """Return a vector with its X negated."""
        return (-vector[0], vector[1], vector[2])

    return (
        grip(f"{name}_r", location, fingers, palm, curl),
        grip(f"{name}_l", mirrored(location), mirrored(fingers), mirrored(palm), curl),
    )


def handle(location: Vec3, direction: Vec3 = (0.0, -1.0, 0.0), name: str = "") -> Anchor:
    """Return a place to open or pull a prop by.

    Args:
        location: Where the hand takes hold.
        direction: The way it is pulled.
        name: The part it opens, such as ``door_driver``; empty for the prop itself.
    """
    return Anchor(kind="handle", name=name, location=location, direction=direction)


def bed_anchor(location: Vec3, width: float, length: float, name: str = "") -> Anchor:
    """Return a place to lie on, its head at +Y.

    Args:
        location: Middle of the lying surface.
        width: Along X.
        length: Along Y.
        name: Tells the beds of one prop apart.
    """
    return Anchor(kind="bed", name=name, location=location, direction=(0.0, -1.0, 0.0), size=(width, length))


def boarding_place(x: float, y: float, name: str = "driver") -> Anchor:
    """Return the floor point beside a vehicle where a person gets in, facing the vehicle.

    Args:
        x: Metres from the vehicle's middle line; the sign tells the side.
        y: Metres behind its middle.
        name: Seat that is reached from there.
    """
    return Anchor(kind="door", name=name, location=(x, y, 0.0), direction=(-1.0 if x > 0 else 1.0, 0.0, 0.0))


def grips_around(radius: float, height: float, curl: Vec3 = WRAP) -> Anchors:
    """Return the grips of a hand that closes around an upright round thing.

    Args:
        radius: Of the thing where it is held.
        height: Of the palm above the thing's foot.
        curl: 0..1 of index, other fingers, thumb.
    """
    return two_hands((-radius, 0.012, height), (0.25, -1, 0), (1, 0.2, 0), curl)


def grips_under(depth: float, curl: Vec3 = (0.12, 0.15, 0.0)) -> Anchors:
    """Return the grips of hands that carry a flat thing from below, by its near and by its far edge.

    Args:
        depth: Metres from the thing's middle to the palm.
        curl: 0..1 of index, other fingers, thumb.
    """
    near = two_hands((-0.01, depth, -0.012), (0, -1, 0), (0, 0, 1), curl)
    return near + two_hands((-0.01, -depth, -0.012), (0, 1, 0), (0, 0, 1), curl, "far")


def grips_at_side(x: float, z: float) -> Anchors:
    """Return the grips of hands flat against the sides of a thing.

    Args:
        x: Of its side at -X, metres.
        z: Height of the palms, metres.
    """
    return two_hands((x, 0.0, z), (0.1, -0.8, -0.5), (1, 0.1, 0.1), (0.3, 0.35, 0.25))


def grips_pinching(y: float, z: float) -> Anchors:
    """Return the grips of fingertips on a small thing, on its middle line.

    Args:
        y: Metres behind the middle of the thing.
        z: Height above its foot, metres.
    """
    return two_hands((-0.03, y + 0.03, z + 0.01), (0.5, -0.85, -0.15), (0.8, 0.4, -0.4), PINCH)


def grips_on_shaft(height: float) -> Anchors:
    """Return the grips of a fist around an upright shaft at ``height``."""
    return two_hands((-0.02, 0.006, height), (0.2, -1, 0), (1, 0.15, 0), FIST)


def grips_hanging(height: float) -> Anchors:
    """Return the grips of a hand that carries a thing by the handle along X on its top, at ``height``."""
    return two_hands((0.0, 0.0, height + 0.004), (0, -0.35, -0.94), (0, -0.94, 0.35), FIST)
