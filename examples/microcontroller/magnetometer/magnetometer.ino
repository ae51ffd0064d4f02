// A magnetometer on I2C, as a stream of its counts: labcal's driver `i2c-board` reads it. Choose the chip below.
#include <Wire.h>

#include "mag_chips.h"

class WireBus : public mag::Bus {
public:
    bool put(uint8_t address, uint8_t at, uint8_t value) override {
        Wire.beginTransmission(address);
        Wire.write(at);
        Wire.write(value);
        return Wire.endTransmission() == 0;
    }
    bool get(uint8_t address, uint8_t at, uint8_t* into, uint8_t count) override {
        Wire.beginTransmission(address);
        Wire.write(at);
        if (Wire.endTransmission(false) != 0 || Wire.requestFrom(address, count) != count) return false;
        for (uint8_t k = 0; k < count; ++k) into[k] = static_cast<uint8_t>(Wire.read());
        return true;
    }
    void wait(uint16_t ms) override { delay(ms); }
};

WireBus bus;
mag::Rm3100 chip(bus);  // or mag::Mmc5983, mag::Lis3mdl, mag::Qmc5883, mag::Bmm350; another address: chip(bus, 0x21)
mag::Lines lines;
const uint32_t kPeriodMs = 50;
uint32_t next_ms = 0;
bool there = false;

void setup() {
    Serial.begin(115200);
    Wire.begin();
    Wire.setClock(400000);
}

void loop() {
    uint32_t now = millis();
    if (static_cast<int32_t>(now - next_ms) < 0) return;
    next_ms = now + kPeriodMs;
    there = there || chip.begin();
    const char* line = lines.of(chip, now);
    if (strstr(line, " none*")) there = false;  // plugged in again it is set again
    Serial.println(line);
}
