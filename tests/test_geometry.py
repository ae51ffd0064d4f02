import numpy as np
import pytest

from labcal.geometry import plane_normal, rotate, rotation, rotation_vector, shortest_rotation, skew, unit

RNG = np.random.default_rng(7)


def test_a_positive_angle_turns_right_handed():
    np.testing.assert_allclose(rotation([0, 0, 1], np.pi / 2) @ [1, 0, 0], [0, 1, 0], atol=1e-15)


def test_rotate_agrees_with_the_matrices():
    axis, angle, v = unit(RNG.normal(size=3)), RNG.uniform(-7, 7, 20), RNG.normal(size=(20, 3))
    np.testing.assert_allclose(rotate(axis, angle, v), np.einsum("nij,nj->ni", rotation(axis, angle), v), atol=1e-13)


def test_rotations_are_proper():
    R = rotation(unit(RNG.normal(size=(50, 3))), RNG.uniform(-9, 9, 50))
    np.testing.assert_allclose(R @ np.swapaxes(R, -1, -2), np.broadcast_to(np.eye(3), R.shape), atol=1e-13)
    np.testing.assert_allclose(np.linalg.det(R), 1, atol=1e-13)


def test_rotation_vector_is_the_exponential_of_skew():
    from scipy.linalg import expm

    w = RNG.normal(size=3)
    np.testing.assert_allclose(rotation_vector(w), expm(skew(w)), atol=1e-13)
    np.testing.assert_array_equal(rotation_vector([0, 0, 0]), np.eye(3))


@pytest.mark.parametrize("b", [[0, 0, 1], [0, 0, -1], [1, 0, 0], [0.3, -0.5, 0.1], [1e-9, 0, -1]])
def test_shortest_rotation_carries_one_direction_onto_the_other(b):
    a = np.array([0.0, 0.0, 1.0])
    R = shortest_rotation(a, b)
    np.testing.assert_allclose(R @ a, unit(b), atol=1e-8)
    np.testing.assert_allclose(R @ R.T, np.eye(3), atol=1e-8)


def test_plane_normal_of_a_tilted_circle():
    normal = unit([1, 2, 3])
    across = unit(np.cross(normal, [1, 0, 0]))
    circle = rotate(normal, np.linspace(0, 6, 40), across) + [5, 6, 7]
    found, centroid = plane_normal(circle)
    assert abs(abs(found @ normal) - 1) < 1e-12
    assert abs((centroid - [5, 6, 7]) @ normal) < 1e-12


def test_a_zero_vector_has_no_direction():
    with pytest.raises(ValueError, match="zero length"):
        unit([0, 0, 0])
