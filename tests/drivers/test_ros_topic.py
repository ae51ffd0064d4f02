"""A ROS 2 topic: CDR by hand and by rosbags, what is no good, and a publisher of Cyclone DDS's own, live."""

from __future__ import annotations

import struct
import sys
import time
from contextlib import closing
from importlib import import_module
from typing import Any

import numpy as np
import pytest
from listening import heard, listening
from rosbags.typesys import Stores, get_typestore

from drivers.framing import ros
from drivers.ros_topic import RosTopic, Settings
from labcal.bench.clock import RealClock
from labcal.bench.links import open_link
from labcal.bench.links.rostopic import HEAD
from labcal.errors import InputError, InstrumentError

LO = """<CycloneDDS><Domain><General><Interfaces><NetworkInterface name="lo" multicast="false"/></Interfaces>
<AllowMulticast>false</AllowMulticast></General><Discovery><ParticipantIndex>auto</ParticipantIndex>
<Peers><Peer address="127.0.0.1"/></Peers></Discovery></Domain></CycloneDDS>"""
FIELD_T = (21.5e-6, -1.25e-6, 43.75e-6)
LONG_S = 30.0  # a busy machine finds its peers by then


def cdr(stamp_s: float = 5.0, frame: str = "imu", xyz_T: tuple[float, float, float] = FIELD_T) -> bytes:
    return ros.build(ros.Message(stamp_s, frame, xyz_T))


def piece(message: bytes) -> bytes:
    return HEAD.pack(len(message)) + message


@pytest.mark.parametrize(("order", "begins"), [("<", "0001"), (">", "0000")])
@pytest.mark.parametrize("frame", ["", "imu", "imu_link", "a/frame/of/28/signs/and/more"])
def test_a_message_by_hand_in_both_orders(order: str, begins: str, frame: str) -> None:
    name = frame.encode() + b"\0"
    body = struct.pack(f"{order}iII", 1767225600, 250_000_000, len(name)) + name
    body += b"\0" * ((8 - len(body)) % 8) + struct.pack(f"{order}12d", *FIELD_T, *range(9))
    read = ros.parse(bytes.fromhex(begins + "0000") + body)
    assert read == ros.Message(1767225600.25, frame, FIELD_T)


def test_rosbags_reads_what_is_built_here_and_the_other_way() -> None:
    store = get_typestore(Stores.ROS2_HUMBLE)
    theirs: Any = store.deserialize_cdr(cdr(12.5, "imu_link"), "sensor_msgs/msg/MagneticField")
    assert (theirs.header.stamp.sec, theirs.header.stamp.nanosec, theirs.header.frame_id) == (
        12,
        500_000_000,
        "imu_link",
    )
    assert (theirs.magnetic_field.x, theirs.magnetic_field.y, theirs.magnetic_field.z) == FIELD_T
    again = bytes(store.serialize_cdr(theirs, "sensor_msgs/msg/MagneticField"))
    assert ros.parse(again) == ros.Message(12.5, "imu_link", FIELD_T)


def test_readings_are_in_nanotesla_at_their_arrival_or_their_own_stamp() -> None:
    pieces = [(1.0, piece(cdr(7.00)) + piece(cdr(7.01))), (1.3, piece(cdr(7.02)))]
    ((block,), lost) = heard(RosTopic, pieces, delay_s=0.1)
    np.testing.assert_allclose(block.values, [[21_500.0, -1_250.0, 43_750.0]] * 3)
    np.testing.assert_allclose(block.t_s, [0.9, 0.9, 1.2])
    ((block,), _) = heard(RosTopic, pieces, stamp="device")
    np.testing.assert_allclose(np.diff(block.t_s), 0.01, atol=1e-9)
    assert (block.raw, lost) == (pieces[0][1] + pieces[1][1], {})


@pytest.mark.parametrize(
    ("bad", "fault"),
    [
        (piece(cdr())[:-1], "bad frame"),
        (b"\0\0", "bad frame"),
        (piece(cdr(6.0, xyz_T=(float("nan"), 0.0, 0.0))), "bad frame"),
        (piece(b"\0\7" + cdr()[2:]), "bad frame"),  # an encoding of another kind
        (piece(cdr(5.0)), "late"),  # the one before again
    ],
)
def test_what_is_no_good_is_noted_and_gives_none(bad: bytes, fault: str) -> None:
    ((block,), lost) = heard(RosTopic, [(1.0, piece(cdr(5.0))), (1.1, bad), (1.2, piece(cdr(5.2)))])
    assert len(block) == 2
    assert lost == {fault: 1}


def test_two_nodes_on_one_topic_are_refused() -> None:
    driver = listening(RosTopic, [(0.1, piece(cdr(1.0, "imu")) + piece(cdr(1.1, "gps")))])
    with pytest.raises(InstrumentError, match="frame 'gps' came, not of 'imu'"):
        driver.identify()


@pytest.mark.parametrize("url", ["ros://imu", "ros://0/", "ros://233/imu", "ros://0/imu//mag", "ros://0/9"])
def test_a_link_that_names_no_topic_is_refused(url: str) -> None:
    with pytest.raises(InputError, match="expected ros://DOMAIN/TOPIC"):
        open_link(url, RealClock())


def test_without_the_library_the_refusal_says_how_to_install_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "cyclonedds.core", None)
    with pytest.raises(InputError, match=r"labcal\[ros\]"):
        open_link("ros://0/imu/mag", RealClock())


def test_a_live_publisher_is_heard(monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("cyclonedds")
    monkeypatch.setenv("CYCLONEDDS_URI", LO)
    idl, types = import_module("cyclonedds.idl"), import_module("cyclonedds.idl.types")
    time_ = idl.make_idl_struct(
        "Time_", "builtin_interfaces.msg.dds_.Time_", {"sec": types.int32, "nanosec": types.uint32}
    )
    header = idl.make_idl_struct("Header_", "std_msgs.msg.dds_.Header_", {"stamp": time_, "frame_id": str})
    vector = idl.make_idl_struct("Vector3_", "geometry_msgs.msg.dds_.Vector3_", dict.fromkeys("xyz", types.float64))
    fields = {"header": header, "magnetic_field": vector, "magnetic_field_covariance": types.array[types.float64, 9]}
    kind = idl.make_idl_struct("MagneticField_", "sensor_msgs.msg.dds_.MagneticField_", fields)
    participant = import_module("cyclonedds.domain").DomainParticipant(42)
    topic = import_module("cyclonedds.topic").Topic(participant, "rt/imu/mag", kind)
    core = import_module("cyclonedds.core")
    offered = core.Qos(core.Policy.Reliability.BestEffort)  # as a sensor's publisher in ROS 2 does
    writer, clock = import_module("cyclonedds.pub").DataWriter(participant, topic, qos=offered), RealClock()
    with closing(open_link("ros://42/imu/mag", clock)) as link:
        driver, sent, read = RosTopic("dut", link, clock, Settings()), 0, 0
        driver.start()
        until = time.monotonic() + LONG_S
        while read < 20 and time.monotonic() < until:
            sent += 1
            stamp = time_(sec=100, nanosec=sent * 10_000_000 % 1_000_000_000)
            writer.write(kind(header(stamp, "imu"), vector(*FIELD_T), [0.0] * 9))
            for block in driver.read_until(clock.now() + 0.01):
                np.testing.assert_allclose(block.values, [[21_500.0, -1_250.0, 43_750.0]] * len(block), rtol=1e-12)
                read += len(block)
        assert read >= 20
        with pytest.raises(InstrumentError):
            link.send(b"x")
