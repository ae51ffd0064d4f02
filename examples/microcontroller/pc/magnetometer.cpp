// The same chips on a computer, for tests: registers are asked for on standard output and answered on standard input.
// c++ -std=c++11 -O1 -o chips magnetometer.cpp && ./chips rm3100 3     prints as many lines of that chip
#include "../magnetometer/mag_chips.h"

#include <stdlib.h>

class Asked : public mag::Bus {
public:
    bool put(uint8_t address, uint8_t at, uint8_t value) override {
        printf("put %u %u %u\n", address, at, value);
        return answered(nullptr, 0);
    }
    bool get(uint8_t address, uint8_t at, uint8_t* into, uint8_t count) override {
        printf("get %u %u %u\n", address, at, count);
        return answered(into, count);
    }
    void wait(uint16_t) override {}

private:
    bool answered(uint8_t* into, uint8_t count) {
        unsigned byte = 0;
        int there = 0;
        fflush(stdout);
        if (scanf("%d", &there) != 1) exit(2);
        for (uint8_t k = 0; there && k < count; ++k) {
            if (scanf("%u", &byte) != 1) exit(2);
            into[k] = static_cast<uint8_t>(byte);
        }
        return there != 0;
    }
};

int main(int, char** said) {
    Asked bus;
    mag::Rm3100 a(bus);
    mag::Mmc5983 b(bus);
    mag::Lis3mdl c(bus);
    mag::Qmc5883 d(bus);
    mag::Bmm350 e(bus);
    mag::Chip* chips[] = {&a, &b, &c, &d, &e};
    for (mag::Chip* chip : chips) {
        if (strcmp(chip->name, said[1])) continue;
        mag::Lines lines;
        printf("begin %d\n", chip->begin());
        for (int k = 0; k < atoi(said[2]); ++k) printf("line %s\n", lines.of(*chip, 50 * k));
    }
    return 0;
}
