"""ros://DOMAIN/TOPIC: a ROS 2 topic of sensor_msgs/MagneticField, by Cyclone DDS without ROS; nothing is published.

Which interfaces and peers it hears is said to Cyclone DDS in CYCLONEDDS_URI, as to every other of its programs.
"""

from __future__ import annotations

import errno
import re
import struct
from functools import cache
from importlib import import_module
from typing import Any

from labcal.errors import InputError

HOW = "ros:// needs Cyclone DDS; install it: pip install 'labcal[ros]'"
ADDRESS = re.compile(r"(\d{1,3})/([A-Za-z_]\w*(?:/[A-Za-z_]\w*)*)", re.ASCII)
LAST_DOMAIN = 232  # whose ports are ports
HEAD = struct.Struct(">I")  # of each piece: the length of its message
MOST, KEPT = 256, 4096  # messages of one look, and unread ones


class RosPort:
    """Each piece is one message as CDR, in the little-endian form that its own first bytes state, behind its length.

    It asks for best effort, volatile: what every publisher offers. What nobody reads is lost, the oldest first.
    """

    byte_s = 0.0

    def __init__(self, address: str) -> None:
        found = ADDRESS.fullmatch(address)
        if found is None or int(found[1]) > LAST_DOMAIN:
            raise InputError(f"link 'ros://{address}': expected ros://DOMAIN/TOPIC, such as ros://0/imu/mag")
        try:
            core, kind = import_module("cyclonedds.core"), _magnetic_field()
            domain, topic = import_module("cyclonedds.domain"), import_module("cyclonedds.topic")
            sub = import_module("cyclonedds.sub")
        except ImportError as error:
            raise InputError(f"link 'ros://{address}': {HOW}") from error
        self._fault: Any = core.DDSException
        policy = core.Policy
        wanted = core.Qos(policy.Reliability.BestEffort, policy.Durability.Volatile, policy.History.KeepLast(KEPT))
        try:
            self._participant = domain.DomainParticipant(int(found[1]))
            self._topic = topic.Topic(self._participant, f"rt/{found[2]}", kind)
            self._reader: Any = sub.DataReader(self._participant, self._topic, qos=wanted)
        except self._fault as error:
            raise OSError(errno.ENXIO, str(error)) from error

    def read(self) -> bytes:
        """The messages that have come. Raises OSError where Cyclone DDS fails."""
        try:
            taken = self._reader.take(MOST)
        except self._fault as error:
            raise OSError(errno.EIO, str(error)) from error
        cdr = [bytes(one.serialize()) for one in taken if hasattr(one, "magnetic_field")]  # others say that one left
        return b"".join(HEAD.pack(len(one)) + one for one in cdr)

    def write(self, data: bytes) -> None:
        """Nothing is ever published."""
        raise OSError(errno.EPERM, "labcal only listens to a topic")

    def there(self) -> bool:
        """It is: it is this computer's own."""
        return True

    def close(self) -> None:
        """Let go."""
        self._reader = self._topic = self._participant = None


@cache
def _magnetic_field() -> Any:
    """sensor_msgs/MagneticField by the names that ROS 2 gives it on the wire. Raises ImportError."""
    idl, types = import_module("cyclonedds.idl"), import_module("cyclonedds.idl.types")
    make = idl.make_idl_struct

    def struct_of(package: str, name: str, **fields: Any) -> Any:
        return make(name, f"{package}.msg.dds_.{name}_", fields)

    time = struct_of("builtin_interfaces", "Time", sec=types.int32, nanosec=types.uint32)
    header = struct_of("std_msgs", "Header", stamp=time, frame_id=str)
    vector = struct_of("geometry_msgs", "Vector3", x=types.float64, y=types.float64, z=types.float64)
    covariance = types.array[types.float64, 9]
    return struct_of(
        "sensor_msgs", "MagneticField", header=header, magnetic_field=vector, magnetic_field_covariance=covariance
    )
