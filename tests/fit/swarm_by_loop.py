"""The fitness of one particle as the paper writes it: (8), (9), Algorithm 3 and (10), an SVD for each locus."""

import numpy as np


def rotation_axis_fitness(particle, loci, axes, magnitude, sign="two-samples", c_f1=1.0, c_f2=4e4):
    """F of (10) at `particle` (12,) for the readings (n_l, 3) of each locus, axes (l, 3) and magnitudes (n,)."""
    K, k = particle[:9].reshape(3, 3), particle[9:]
    f1 = f2 = 0.0
    first = 0
    for readings, axis in zip(loci, axes, strict=True):
        b = readings @ K.T - k
        f1 += np.sum((magnitude[first : first + len(b)] - np.linalg.norm(b, axis=1)) ** 2)
        first += len(b)
        f2 += (1 - plane_normal_of(b, sign) @ -axis) ** 2
    return c_f1 * np.sqrt(f1) / first + c_f2 * np.sqrt(f2) / len(loci)


def plane_normal_of(b, sign):
    """Algorithm 3."""
    centred = b - b.mean(axis=0)
    normal = np.linalg.svd(centred, full_matrices=False)[2][-1]
    if sign == "two-samples":
        return np.sign(normal @ np.cross(b[0], b[len(b) // 4])) * normal
    return np.sign(normal @ np.cross(centred[:-1], centred[1:]).sum(axis=0)) * normal
