"""Lengths in kit files: a number, or sums such as ``-x + 0.6`` in which x, y and h are the size of the place."""

from __future__ import annotations

import ast
import operator
from collections.abc import Callable, Mapping
from typing import Annotated

from pydantic import AfterValidator

_OPERATORS: Mapping[type[ast.AST], Callable[[float, float], float]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
}
NAMES = ("x", "y", "h", "n")
"""Variables: half the width, half the depth, the ceiling height, and the index of the copy, from 0."""


def value_of(term: float | str, names: Mapping[str, float]) -> float:
    """Evaluate a term.

    Args:
        term: A number, or an expression with + - * / and brackets.
        names: Values of the variables.

    Raises:
        ValueError: The term is not a valid expression.
    """
    if not isinstance(term, str):
        return float(term)
    try:
        return round(_value(ast.parse(term, mode="eval").body, names), 4)
    except (SyntaxError, ZeroDivisionError, RecursionError) as error:
        raise ValueError(f"{term!r} is no sum of numbers and {', '.join(names)}") from error


def _value(node: ast.expr, names: Mapping[str, float]) -> float:
    """Return the value of an expression's node. Raises ValueError for anything but + - * /, numbers and known names."""
    match node:
        case ast.Constant(value=int() | float() as number):
            return float(number)
        case ast.Name(id=name) if name in names:
            return names[name]
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return -_value(operand, names)
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
            return _OPERATORS[type(op)](_value(left, names), _value(right, names))
    raise ValueError(f"{ast.unparse(node)!r} is neither a number nor one of {', '.join(names)}")


def _checked(term: float | str) -> float | str:
    """Return a term unchanged. Raises ValueError if it cannot be evaluated."""
    value_of(term, dict.fromkeys(NAMES, 1.37))
    return term


Term = Annotated[float | str, AfterValidator(_checked)]
"""A length in metres or an angle in degrees, checked when the file is read."""
