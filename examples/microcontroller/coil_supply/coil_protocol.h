// labcal-coil/1, the firmware's side: lines in, lines out, and zero when nothing is heard (docs/microcontroller.md).
// Plain C++11, no heap, no floating point: the same text runs on a microcontroller and, for tests, on a computer.
#pragma once
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

namespace coil {

const uint8_t kMostChannels = 6;
const size_t kLongestLine = 48;
const size_t kLongestReply = 160;

struct Identity {
    const char* maker;     // words without blanks
    const char* model;
    const char* serial;
    const char* firmware;
    uint8_t channels;
    const char* unit;      // "uA": the board regulates a current; "ppm": it applies a duty
    int32_t limit;         // beyond it a set-point is refused, in that unit
    uint32_t watchdog_ms;  // after so long without a valid line everything is at zero and open
    bool sense;            // whether measured() really measures, in uA
};

// What the board does with its bridges. Channels count from 0 here, from 1 on the line.
class Bridges {
public:
    virtual void drive(uint8_t channel, int32_t value) = 0;  // signed, in the board's unit
    virtual void open(uint8_t channel) = 0;                  // no current can flow from the supply
    virtual int32_t measured(uint8_t channel) = 0;           // uA; without sense: what it drives
};

inline uint8_t crc8(const char* text, size_t length) {
    uint8_t value = 0;
    for (size_t k = 0; k < length; ++k) {
        value ^= static_cast<uint8_t>(text[k]);
        for (uint8_t bit = 0; bit < 8; ++bit)
            value = static_cast<uint8_t>(value & 0x80 ? (value << 1) ^ 0x07 : value << 1);
    }
    return value;
}

class Protocol {
public:
    Protocol(const Identity& identity, Bridges& bridges) : who_(identity), bridges_(bridges) {}

    // After every reset: all bridges open, before anything else.
    void begin(uint32_t now_ms) {
        for (uint8_t c = 0; c < who_.channels; ++c) rest(c);
        heard_ms_ = now_ms;
    }

    // To be called all the time, and by nothing that communication can hold up.
    void tick(uint32_t now_ms) {
        if (!who_.watchdog_ms || now_ms - heard_ms_ <= who_.watchdog_ms) return;
        for (uint8_t c = 0; c < who_.channels; ++c) {
            tripped_[c] = tripped_[c] || on_[c];
            rest(c);
        }
    }

    // One byte that came. Returns the line to be sent, or nullptr: what is not a whole, valid line has no answer.
    const char* take(char byte, uint32_t now_ms) {
        if (byte != '\n') {
            if (length_ < kLongestLine) line_[length_] = byte;
            if (length_ <= kLongestLine) ++length_;
            return nullptr;
        }
        size_t length = length_;
        length_ = 0;
        if (length > kLongestLine) return nullptr;
        if (length && line_[length - 1] == '\r') --length;
        return answer(length, now_ms);
    }

private:
    static bool digit(char c) { return c >= '0' && c <= '9'; }

    static bool blank(const char*& at) { return *at == ' ' ? (++at, true) : false; }

    // A whole number of at most `most` digits; false where none stands there.
    static bool number(const char*& at, uint8_t most, bool sign, int32_t& value) {
        const char* from = at;
        bool minus = sign && *from == '-';
        if (minus) ++from;
        uint8_t digits = 0;
        int32_t found = 0;
        for (; digit(*from) && digits < most; ++from, ++digits) found = found * 10 + (*from - '0');
        if (!digits || digit(*from)) return false;
        value = minus ? -found : found;
        at = from;
        return true;
    }

    const char* answer(size_t length, uint32_t now_ms) {
        if (length < 5 || line_[length - 3] != '*') return nullptr;
        char sum[3];
        snprintf(sum, sizeof sum, "%02X", static_cast<unsigned>(crc8(line_, length - 3)));
        if (memcmp(sum, line_ + length - 2, 2) != 0 || memchr(line_, 0, length)) return nullptr;
        line_[length - 3] = 0;
        const char* at = line_;
        int32_t sequence;
        if (!number(at, 3, false, sequence) || !blank(at)) return nullptr;
        tick(now_ms);  // a line that comes too late does not save the current
        uint32_t silent_ms = now_ms - heard_ms_;
        left_ms_ = silent_ms < who_.watchdog_ms ? who_.watchdog_ms - silent_ms : 0;
        heard_ms_ = now_ms;
        text_[0] = 0;
        const char* why = obey(at);
        snprintf(reply_, sizeof reply_ - 4, "%ld %s %s", static_cast<long>(sequence), why ? "ERR" : "OK", why ? why : text_);
        size_t end = strlen(reply_);
        snprintf(reply_ + end, sizeof reply_ - end, "*%02X\n", static_cast<unsigned>(crc8(reply_, end)));
        return reply_;
    }

    // Does what the words say and writes what is answered; returns why not, or nullptr.
    const char* obey(const char* at) {
        const char* begin = at;
        while ((*at >= 'A' && *at <= 'Z') || *at == '?') ++at;
        size_t length = static_cast<size_t>(at - begin);
        const char* const words[] = {"WHO", "BEAT", "SET?", "MEAS?", "OUT?", "TRIP?", "SET", "OUT"};
        const uint8_t needs[] = {0, 0, 1, 1, 1, 1, 2, 2};
        uint8_t word = 0;
        while (word < 8 && (strlen(words[word]) != length || memcmp(words[word], begin, length) != 0)) ++word;
        if (word == 8) return "word";
        int32_t channel = 1, value = 0;
        if (needs[word] > 0 && !(blank(at) && number(at, 1, false, channel))) return "number";
        if (needs[word] > 1 && !(blank(at) && number(at, 9, true, value))) return "number";
        if (*at) return "number";
        if (channel < 1 || channel > who_.channels) return "channel";
        return act(word, static_cast<uint8_t>(channel - 1), value);
    }

    const char* act(uint8_t word, uint8_t c, int32_t value) {
        switch (word) {
            case 0: return tell_who();
            case 1: return beat();
            case 2: return say(value_[c]);
            case 3: return say(bridges_.measured(c));
            case 4: return say(on_[c]);
            case 5: return strcpy(text_, tripped_[c] ? "watchdog" : "none"), nullptr;
            case 6: return set(c, value);
            default: return output(c, value);
        }
    }

    const char* set(uint8_t c, int32_t value) {
        if (value > who_.limit || value < -who_.limit) return "range";
        if (value && !on_[c]) return tripped_[c] ? "watchdog" : "off";
        value_[c] = value;
        if (on_[c]) bridges_.drive(c, value);
        return say(value);
    }

    const char* output(uint8_t c, int32_t value) {
        if (value != 0 && value != 1) return "number";
        if (value) {
            if (!on_[c]) bridges_.drive(c, 0);
            on_[c] = true;
            tripped_[c] = false;
        } else {
            rest(c);
        }
        return say(value);
    }

    const char* beat() {
        for (uint8_t c = 0; c < who_.channels; ++c)
            if (tripped_[c]) return "watchdog";
        return say(static_cast<int32_t>(left_ms_));
    }

    const char* tell_who() {
        snprintf(text_, sizeof text_, "labcal-coil/1 %s %s %s %s channels=%u unit=%s limit=%ld watchdog_ms=%lu sense=%d",
                 who_.maker, who_.model, who_.serial, who_.firmware, static_cast<unsigned>(who_.channels), who_.unit,
                 static_cast<long>(who_.limit), static_cast<unsigned long>(who_.watchdog_ms), who_.sense ? 1 : 0);
        return nullptr;
    }

    const char* say(int32_t value) {
        snprintf(text_, sizeof text_, "%ld", static_cast<long>(value));
        return nullptr;
    }

    void rest(uint8_t c) {
        value_[c] = 0;
        on_[c] = false;
        bridges_.open(c);
    }

    const Identity who_;
    Bridges& bridges_;
    int32_t value_[kMostChannels] = {};
    bool on_[kMostChannels] = {};
    bool tripped_[kMostChannels] = {};
    uint32_t heard_ms_ = 0;
    uint32_t left_ms_ = 0;
    size_t length_ = 0;
    char line_[kLongestLine + 1] = {};
    char text_[kLongestReply - 32] = {};
    char reply_[kLongestReply] = {};
};

}  // namespace coil
