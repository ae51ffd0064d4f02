// The same firmware on a computer, for tests: a board behind a pty, with three coils that follow at once.
// c++ -std=c++11 -O1 -o board main.cpp && ./board [watchdog_ms]     prints the name of its terminal
#include <fcntl.h>
#include <poll.h>
#include <termios.h>
#include <time.h>
#include <unistd.h>

#include "../coil_supply/coil_protocol.h"

class Board : public coil::Bridges {
public:
    void drive(uint8_t c, int32_t value) override { flows_[c] = value; }
    void open(uint8_t c) override { flows_[c] = 0; }
    int32_t measured(uint8_t c) override { return flows_[c]; }

private:
    int32_t flows_[3] = {};
};

static uint32_t now_ms() {
    timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return static_cast<uint32_t>(now.tv_sec * 1000LL + now.tv_nsec / 1000000L);
}

int main(int argc, char** argv) {
    const uint32_t watchdog_ms = argc > 1 ? static_cast<uint32_t>(atol(argv[1])) : 1000;
    const coil::Identity who = {"labcal", "pc-board", "0001", "1.0", 3, "uA", 3000000L, watchdog_ms, true};
    Board board;
    coil::Protocol protocol(who, board);
    int master = posix_openpt(O_RDWR | O_NOCTTY);
    if (master < 0 || grantpt(master) || unlockpt(master)) return 1;
    int slave = open(ptsname(master), O_RDWR | O_NOCTTY);  // kept open: hosts come and go
    termios raw;
    if (slave < 0 || tcgetattr(slave, &raw)) return 1;
    cfmakeraw(&raw);
    cfsetspeed(&raw, B115200);
    if (tcsetattr(slave, TCSANOW, &raw)) return 1;
    protocol.begin(now_ms());
    printf("%s\n", ptsname(master));
    fflush(stdout);
    pollfd ends[] = {{master, POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}};
    for (;;) {
        poll(ends, 2, 5);
        protocol.tick(now_ms());
        if (ends[1].revents) return 0;  // whoever started it has closed its standard input
        char data[256];
        ssize_t came = ends[0].revents & POLLIN ? read(master, data, sizeof data) : 0;
        for (ssize_t k = 0; k < came; ++k) {
            const char* reply = protocol.take(data[k], now_ms());
            if (reply && write(master, reply, strlen(reply)) < 0) return 1;
        }
    }
}
