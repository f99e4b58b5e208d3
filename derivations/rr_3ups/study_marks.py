"""Curves upon maps: places, and branches of a set of zeros."""

import numpy as np


def crosses(x, y, width, height):
    """Places as small crosses, in one curve with gaps."""
    strokes_x, strokes_y = [], []
    for a, b in zip(x, y, strict=True):
        strokes_x += [a - width, a + width, np.nan, a, a, np.nan]
        strokes_y += [b, b, np.nan, b - height, b + height, np.nan]
    return np.array(strokes_x), np.array(strokes_y)


def branches(values, x, y):
    """Places along each row at which values change sign, joined from row to row, with gaps.

    Args:
        values: a row of numbers for each of y.
    """
    rows = [zeros(row, x) for row in values]
    most = max(len(row) for row in rows)
    along, up = [], []
    for k in range(most):
        for count, row, at in zip([len(rows[0]), *map(len, rows)], rows, y, strict=False):
            # Where the number of zeros changes, the k-th of them is another branch.
            whole = k < len(row) == count
            along.append(row[k] if whole else np.nan)
            up.append(at if whole else np.nan)
        along.append(np.nan)
        up.append(np.nan)
    return np.array(along), np.array(up)


def zeros(row, x):
    """Places of the changes of sign in a row."""
    found = np.flatnonzero(np.sign(row[1:]) != np.sign(row[:-1]))
    share = row[found] / (row[found] - row[found + 1])
    return x[found] + share * (x[found + 1] - x[found])


def covering(levels, values):
    """Levels of a map, with ends added where its values go beyond them."""
    low, high = float(np.min(values)), float(np.max(values))
    ends = [beyond(end) for end in (low, high)]
    below = [ends[0]] if low < levels[0] else []
    return [*below, *levels, *([ends[1]] if high > levels[-1] else [])]


def beyond(value):
    """The next number of two digits away from 0."""
    unit = 10.0 ** (np.floor(np.log10(abs(value))) - 1)
    return float(np.copysign(np.ceil(abs(value) / unit) * unit, value))
