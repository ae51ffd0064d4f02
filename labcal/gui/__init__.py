"""The technician's window, over worker processes."""

import os

# Pages are imported by a thread while the window lives. PySide makes its types when they are first asked for, and two
# threads that ask at once end in a segmentation fault; made at once they cost no time that can be measured.
os.environ.setdefault("PYSIDE6_OPTION_LAZY", "0")
