"""What no instrument of such a lab can make or say: a larger number is a slip of the pen, or meant to do harm."""

LARGEST_FIELD_nT = 1e9  # 1 T
LARGEST_CURRENT_A = 1e4
LARGEST_NUMBER = 1e30  # its square is still a number
LARGEST_OF = {"_nT": LARGEST_FIELD_nT, "_A": LARGEST_CURRENT_A}  # by how a name ends; without unit LARGEST_NUMBER


def largest(name: str) -> float:
    """The largest magnitude that a number called `name` may have, by the unit that its name ends with."""
    return next((most for end, most in LARGEST_OF.items() if name.endswith(end)), LARGEST_NUMBER)
