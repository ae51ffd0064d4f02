"""Effects the affine map lacks, one file each, found through the entry-point group `labcal.effects`.

With a = K m − k, the residual is r = a − Σ e_i − p (contract: calibration). Effects of the rig add to p and so enter
with the same sign. A `Term` is one form that an effect can take (a channel, a time constant, an order); its linear
parameters are left open and `columns` gives d e / d parameter. A `Family` is all that is known about one effect id.
"""

from labcal.model.effects.protocol import Family, Fitted, Scene, Shape, Term
from labcal.model.effects.registry import families, family, load, load_shipped

__all__ = ["Family", "Fitted", "Scene", "Shape", "Term", "families", "family", "load", "load_shipped"]
