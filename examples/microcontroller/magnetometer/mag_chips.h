// labcal-mag/1, the firmware's side: five magnetometers on I2C, each reading a line of its counts (docs/microcontroller.md).
// Plain C++11, no heap, no floating point: the same text runs on a microcontroller and, for tests, on a computer.
#pragma once
#include <stdint.h>
#include <stdio.h>
#include <string.h>

namespace mag {

// Registers of the chip at an I2C address. false: it did not acknowledge.
class Bus {
public:
    virtual bool put(uint8_t address, uint8_t at, uint8_t value) = 0;
    virtual bool get(uint8_t address, uint8_t at, uint8_t* into, uint8_t count) = 0;
    virtual void wait(uint16_t ms) = 0;
};

enum Found { NONE, FULL, FINE };  // it does not answer; its converter is at its end; counts

inline int32_t signed_of(uint32_t value, uint8_t bits) {
    return value >> (bits - 1) ? static_cast<int32_t>(value) - (1L << bits) : static_cast<int32_t>(value);
}

class Chip {
public:
    Chip(Bus& bus, uint8_t address, const char* name) : name(name), bus_(bus), at_(address) {}
    virtual bool begin() = 0;                // true: it is that chip, and was set
    virtual Found read(int32_t* counts) = 0;  // x, y, z in its own axes
    const char* const name;

protected:
    bool put(uint8_t reg, uint8_t value) { return bus_.put(at_, reg, value); }
    bool get(uint8_t reg, uint8_t* into, uint8_t count) { return bus_.get(at_, reg, into, count); }
    bool is(uint8_t reg, uint8_t value) {
        uint8_t held = 0;
        return get(reg, &held, 1) && held == value;
    }
    bool ready(uint8_t reg, uint8_t bit, uint8_t tries) {
        for (uint8_t status = 0; tries && get(reg, &status, 1); --tries) {
            if (status & bit) return true;
            bus_.wait(1);
        }
        return false;
    }
    Bus& bus_;
    const uint8_t at_;
};

inline Found within(const int32_t* counts, int32_t least, int32_t most) {
    for (uint8_t k = 0; k < 3; ++k)
        if (counts[k] <= least || counts[k] >= most) return FULL;
    return FINE;
}

// PNI RM3100: 24 bits, high byte first; its scale goes with the cycle count.
class Rm3100 : public Chip {
public:
    explicit Rm3100(Bus& bus, uint8_t address = 0x20) : Chip(bus, address, "rm3100") {}
    bool begin() override {
        bool set = is(0x36, 0x22);
        for (uint8_t reg = 0x04; reg < 0x0A; ++reg) set = set && put(reg, reg & 1 ? kCycles : 0);
        return set;
    }
    Found read(int32_t* counts) override {
        uint8_t raw[9];
        if (!put(0x00, 0x70) || !ready(0x34, 0x80, 60) || !get(0x24, raw, 9)) return NONE;
        for (uint8_t k = 0; k < 3; ++k)
            counts[k] = signed_of((uint32_t)raw[3 * k] << 16 | (uint32_t)raw[3 * k + 1] << 8 | raw[3 * k + 2], 24);
        return within(counts, -8388608L, 8388607L);
    }
    static const uint8_t kCycles = 200;
};

// MEMSIC MMC5983MA: 18 bits; what is sent is the reading after SET less that after RESET, so its bridge's offset is out.
class Mmc5983 : public Chip {
public:
    explicit Mmc5983(Bus& bus, uint8_t address = 0x30) : Chip(bus, address, "mmc5983") {}
    bool begin() override { return is(0x2F, 0x30) && put(0x0A, 0x00); }
    Found read(int32_t* counts) override {
        int32_t after[2][3];
        Found worst = FINE;
        for (uint8_t k = 0; k < 2; ++k) {
            if (!put(0x09, k ? 0x10 : 0x08)) return NONE;  // RESET, SET
            bus_.wait(1);
            uint8_t raw[7];
            if (!put(0x09, 0x01) || !ready(0x08, 0x01, 30) || !get(0x00, raw, 7)) return NONE;
            for (uint8_t axis = 0; axis < 3; ++axis)
                after[k][axis] = (uint32_t)raw[2 * axis] << 10 | (uint32_t)raw[2 * axis + 1] << 2 |
                                 (raw[6] >> (6 - 2 * axis) & 3);
            if (within(after[k], 0, 262143L) == FULL) worst = FULL;
        }
        for (uint8_t axis = 0; axis < 3; ++axis) counts[axis] = after[0][axis] - after[1][axis];
        return worst;
    }
};

// 16 bits, low byte first, of chips that measure by themselves.
inline void low_first(const uint8_t* raw, int32_t* counts) {
    for (uint8_t k = 0; k < 3; ++k) counts[k] = signed_of((uint32_t)raw[2 * k + 1] << 8 | raw[2 * k], 16);
}

// ST LIS3MDL at +-4 gauss and 20 Hz, its finest performance on all axes.
class Lis3mdl : public Chip {
public:
    explicit Lis3mdl(Bus& bus, uint8_t address = 0x1C) : Chip(bus, address, "lis3mdl") {}
    bool begin() override {
        return is(0x0F, 0x3D) && put(0x20, 0x74) && put(0x21, 0x00) && put(0x23, 0x0C) && put(0x24, 0x40) &&
               put(0x22, 0x00);
    }
    Found read(int32_t* counts) override {
        uint8_t raw[6];
        if (!ready(0x27, 0x08, 100) || !get(0xA8, raw, 6)) return NONE;  // 28h, counted on
        low_first(raw, counts);
        return within(counts, -32768L, 32767L);
    }
};

// QST QMC5883L (not its pin-compatible forerunner HMC5883L, nor a QMC5883P) at +-2 gauss and 50 Hz.
class Qmc5883 : public Chip {
public:
    explicit Qmc5883(Bus& bus, uint8_t address = 0x0D) : Chip(bus, address, "qmc5883") {}
    bool begin() override { return is(0x0D, 0xFF) && put(0x0B, 0x01) && put(0x09, 0x05); }
    Found read(int32_t* counts) override {
        uint8_t raw[7];
        if (!ready(0x06, 0x01, 60) || !get(0x00, raw, 7)) return NONE;
        low_first(raw, counts);
        return raw[6] & 0x02 ? FULL : within(counts, -32768L, 32767L);
    }
};

// Bosch BMM350 at 25 Hz: 24 bits, low byte first, as they are before the corrections that its memory holds.
class Bmm350 : public Chip {
public:
    explicit Bmm350(Bus& bus, uint8_t address = 0x14) : Chip(bus, address, "bmm350") {}
    bool begin() override {
        uint8_t raw[3];
        if (!get(0x00, raw, 3) || raw[2] != 0x33 || !put(0x50, 0x80)) return false;  // two bytes come before each answer
        const uint8_t words[][2] = {{0x06, 0x07}, {0x06, 0x05}, {0x04, 0x26}, {0x06, 0x02}, {0x05, 0x07}, {0x06, 0x01}};
        for (uint8_t k = 0; k < 6; ++k) {  // its magnetic reset, the rate, three axes, on
            if (!put(words[k][0], words[k][1])) return false;
            bus_.wait(40);
        }
        return true;
    }
    Found read(int32_t* counts) override {
        uint8_t raw[11];
        for (uint8_t tries = 60; !(get(0x30, raw, 3) && raw[2] & 0x04); --tries) {
            if (!tries) return NONE;
            bus_.wait(1);
        }
        if (!get(0x31, raw, 11)) return NONE;
        for (uint8_t k = 0; k < 3; ++k)
            counts[k] = signed_of((uint32_t)raw[3 * k + 4] << 16 | (uint32_t)raw[3 * k + 3] << 8 | raw[3 * k + 2], 24);
        return within(counts, -8388608L, 8388607L);
    }
};

// CRC-16 with polynomial 1021h from FFFFh, not reflected: 29B1h for "123456789".
inline uint16_t crc16(const char* text) {
    uint16_t value = 0xFFFF;
    for (; *text; ++text) {
        value ^= static_cast<uint16_t>(static_cast<uint8_t>(*text)) << 8;
        for (uint8_t bit = 0; bit < 8; ++bit)
            value = static_cast<uint16_t>(value & 0x8000 ? (value << 1) ^ 0x1021 : value << 1);
    }
    return value;
}

const uint8_t kLine = 64;

// The next line of a chip, without its end: NUMBER CHIP MS X Y Z*HHHH, or NUMBER CHIP MS full*HHHH, … none*HHHH.
class Lines {
public:
    const char* of(Chip& chip, uint32_t now_ms) {
        int32_t c[3];
        Found found = chip.read(c);
        int length = snprintf(line_, kLine, "%u %s %lu ", number_, chip.name, static_cast<unsigned long>(now_ms));
        if (found == FINE)
            snprintf(line_ + length, kLine - length, "%ld %ld %ld", (long)c[0], (long)c[1], (long)c[2]);
        else
            snprintf(line_ + length, kLine - length, found == FULL ? "full" : "none");
        size_t end = strlen(line_);
        snprintf(line_ + end, kLine - end, "*%04X", crc16(line_));
        number_ = (number_ + 1) % 1000;
        return line_;
    }

private:
    char line_[kLine];
    uint16_t number_ = 0;
};

}  // namespace mag
