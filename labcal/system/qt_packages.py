"""The Debian packages that Qt's own libraries ask of the system: on a screen, and where there is none.

`tools/qt_libraries.py --check` reads them out of the installed Qt again. As a program it prints them.
"""

from __future__ import annotations

# What libQt6Core, Gui, Widgets and DBus and the platform plugins for X and for no screen name and Qt does not bring.
QT_PACKAGES = (
    *("libdbus-1-3", "libegl1", "libfontconfig1", "libfreetype6", "libgl1", "libglib2.0-0", "libx11-6", "libx11-xcb1"),
    *("libxcb-cursor0", "libxcb-icccm4", "libxcb-image0", "libxcb-keysyms1", "libxcb-randr0", "libxcb-render-util0"),
    *("libxcb-render0", "libxcb-shape0", "libxcb-shm0", "libxcb-sync1", "libxcb-util1", "libxcb-xfixes0"),
    *("libxcb-xkb1", "libxcb1", "libxkbcommon-x11-0", "libxkbcommon0"),
)

if __name__ == "__main__":
    print(*QT_PACKAGES)
