"""Effects the affine map lacks, one file each, found through the entry-point group `labcal.effects`.

With a = K m − k, the residual is r = a − Σ e_i − p (contract: calibration). Effects of the rig add to p and so enter
with the same sign. A `Term` is one form that an effect can take (a channel, a time constant, an order); its linear
parameters are left open and `columns` gives d e / d parameter. A `Shape` is a parameter that does not enter linearly,
its `Kind` how it is searched. A `Family` is all that is known about one effect id.
"""

from labcal.model.effects.protocol import Confounded, Family, Fitted
from labcal.model.effects.registry import (
    families,
    family,
    find,
    load,
    load_shipped,
    of_temperature,
    phrases,
    plainly,
)
from labcal.model.effects.scene import Scene
from labcal.model.effects.shape import (
    ANGLE,
    BEGINNING,
    BEGINNING_ON,
    CARRIED_OFF,
    DELAY,
    FREQUENCY,
    GIVEN,
    LESS_ITSELF,
    LEVEL,
    MOMENT,
    SCALE,
    SECANT,
    THRESHOLD,
    TIME_CONSTANT,
    Kind,
    Shape,
)
from labcal.model.effects.term import Term

__all__ = [
    "ANGLE",
    "BEGINNING",
    "BEGINNING_ON",
    "CARRIED_OFF",
    "DELAY",
    "FREQUENCY",
    "GIVEN",
    "LESS_ITSELF",
    "LEVEL",
    "MOMENT",
    "SCALE",
    "SECANT",
    "THRESHOLD",
    "TIME_CONSTANT",
    "Confounded",
    "Family",
    "Fitted",
    "Kind",
    "Scene",
    "Shape",
    "Term",
    "families",
    "family",
    "find",
    "load",
    "load_shipped",
    "of_temperature",
    "phrases",
    "plainly",
]
