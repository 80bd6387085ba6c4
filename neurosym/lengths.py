"""Distances in words."""


def in_millimetres(distance: float, allowed: float) -> str:
    """Return a distance in whole mm, with decimals where it would look allowed and is not.

    Args:
        distance: The distance [m].
        allowed: The greatest that is allowed [m].
    """
    text = ""
    for digits in range(10):
        text = f"{1000 * distance:.{digits}f}"
        if distance <= allowed or float(text) > 1000 * allowed:
            break
    return f"{text} mm"
