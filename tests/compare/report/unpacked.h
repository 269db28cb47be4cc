// SPDX-License-Identifier: MIT
// Which numbers does a page read out of a text?
#pragma once
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace plumb::compare {

inline std::vector<std::uint8_t> unpackedBytes(const std::string& text) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::vector<std::uint8_t> bytes;
    std::uint32_t held = 0;
    int bits = 0;
    for (const char c : text) {
        if (c == '=') break;
        held = held << 6 | static_cast<std::uint32_t>(digits.find(c));
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes.push_back(static_cast<std::uint8_t>(held >> bits & 0xFFu));
    }
    return bytes;
}

/// Number is float or double, Bits an unsigned integer of its size.
template <typename Number, typename Bits>
std::vector<double> unpackedNumbers(const std::string& text) {
    const std::vector<std::uint8_t> bytes = unpackedBytes(text);
    std::vector<double> numbers;
    for (std::size_t i = 0; i + sizeof(Bits) <= bytes.size(); i += sizeof(Bits)) {
        Bits bits = 0;
        for (std::size_t k = 0; k < sizeof(Bits); ++k) bits |= static_cast<Bits>(bytes[i + k]) << (8 * k);
        numbers.push_back(static_cast<double>(std::bit_cast<Number>(bits)));
    }
    return numbers;
}

inline std::vector<double> unpackedDoubles(const std::string& text) {
    return unpackedNumbers<double, std::uint64_t>(text);
}

inline std::vector<double> unpackedFloats(const std::string& text) {
    return unpackedNumbers<float, std::uint32_t>(text);
}

}  // namespace plumb::compare
