import numpy as np

from labcal.gui.viewmodels.ring_buffer import RingBuffer


def test_the_newest_rows_stay_in_order_across_the_wrap():
    ring = RingBuffer(columns=3, size=10)
    for start in range(0, 25, 5):
        t = np.arange(start, start + 5, dtype=float)
        ring.push(t, np.column_stack([t, 2 * t, 3 * t]))
    np.testing.assert_array_equal(ring.rows()[:, 0], np.arange(15, 25))
    np.testing.assert_array_equal(ring.rows()[:, 3], 3 * np.arange(15, 25))


def test_a_block_larger_than_the_ring_keeps_its_end():
    ring = RingBuffer(columns=1, size=4)
    ring.push(np.arange(9.0), np.arange(9.0)[:, None])
    np.testing.assert_array_equal(ring.rows()[:, 0], [5, 6, 7, 8])
    assert len(ring) == 4


def test_a_ring_not_yet_full_gives_what_it_has():
    ring = RingBuffer(columns=1, size=4)
    ring.push(np.arange(2.0), np.arange(2.0)[:, None])
    assert ring.rows().tolist() == [[0, 0], [1, 1]]
    ring.clear()
    assert len(ring) == 0
