// A coil supply out of a microcontroller and three H-bridges (two inputs each, such as DRV8871, BTS7960 or TB6612):
// labcal's driver `microcontroller` speaks to it. Change the pins, the limit and the sense below, and nothing else.
#include "coil_protocol.h"
#if defined(__AVR__)
#include <avr/wdt.h>
#endif

// What your board is. limit: millionths of full duty; sense: whether SENSE_PIN is wired to a current sensor.
const coil::Identity kWho = {"my-lab", "h-bridge", "0001", "1.0", 3, "ppm", 900000L, 1000UL, true};
const uint8_t FORWARD_PIN[] = {3, 6, 10};   // pins with PWM
const uint8_t BACKWARD_PIN[] = {5, 9, 11};
const uint8_t SENSE_PIN[] = {A0, A1, A2};
const int32_t SENSE_ZERO = 512;             // counts of the converter at 0 A: look with the bridge open
const int32_t SENSE_UA_PER_COUNT = 26400;   // of a sensor of 185 mV/A on 5 V and 10 bits; negative where it is turned

class Board : public coil::Bridges {
public:
    void drive(uint8_t c, int32_t value) override {
        applied_[c] = value;
        uint8_t duty = static_cast<uint8_t>((value < 0 ? -value : value) * 255LL / 1000000L);
        analogWrite(value < 0 ? FORWARD_PIN[c] : BACKWARD_PIN[c], 0);  // one side down before the other goes up
        analogWrite(value < 0 ? BACKWARD_PIN[c] : FORWARD_PIN[c], duty);
    }

    void open(uint8_t c) override {
        applied_[c] = 0;
        digitalWrite(FORWARD_PIN[c], LOW);  // both low: the bridge lets go
        digitalWrite(BACKWARD_PIN[c], LOW);
    }

    int32_t measured(uint8_t c) override {
        if (!kWho.sense) return applied_[c];
        return (analogRead(SENSE_PIN[c]) - SENSE_ZERO) * SENSE_UA_PER_COUNT;
    }

private:
    int32_t applied_[3] = {};
};

Board board;
coil::Protocol protocol(kWho, board);

void setup() {
    for (uint8_t c = 0; c < 3; ++c) {
        digitalWrite(FORWARD_PIN[c], LOW);
        digitalWrite(BACKWARD_PIN[c], LOW);
        pinMode(FORWARD_PIN[c], OUTPUT);
        pinMode(BACKWARD_PIN[c], OUTPUT);
    }
    protocol.begin(millis());
    Serial.begin(115200);
#if defined(__AVR__)
    wdt_enable(WDTO_250MS);  // a loop that hangs resets the board, and a reset opens the bridges
#endif
}

void loop() {
#if defined(__AVR__)
    wdt_reset();
#endif
    protocol.tick(millis());
    if (Serial.available() > 0) {
        const char* reply = protocol.take(static_cast<char>(Serial.read()), millis());
        if (reply) Serial.write(reply);  // at most 140 bytes: 12 ms at 115200 baud
    }
}
