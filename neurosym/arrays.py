"""Arrays in annotations: what they hold, and along which axes, as in `Float[np.ndarray, "N 4"]`.

Type checkers and tests read these as jaxtyping's. Who has not imported jaxtyping checks no shapes, and gets
the plain type: making the others would take half as long as importing numpy.
"""

import sys
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING or "jaxtyping" in sys.modules:
    from jaxtyping import Bool as Bool
    from jaxtyping import Float as Float
    from jaxtyping import Int as Int
    from jaxtyping import UInt8 as UInt8
else:

    class Bool:
        """An array as its plain type."""

        def __class_getitem__(cls, told: tuple[Any, str]) -> Any:
            return told[0]

    Float = Int = UInt8 = Bool
