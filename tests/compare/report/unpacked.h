// SPDX-License-Identifier: MIT
// Which numbers does a page read out of a text?
#pragma once
#include <zlib.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "catch.h"

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

inline std::vector<double> unpackedDoubles(const std::string& text) {
    const std::vector<std::uint8_t> bytes = unpackedBytes(text);
    std::vector<double> numbers;
    for (std::size_t i = 0; i + 8 <= bytes.size(); i += 8) {
        std::uint64_t bits = 0;
        for (std::size_t k = 0; k < 8; ++k) bits |= static_cast<std::uint64_t>(bytes[i + k]) << (8 * k);
        numbers.push_back(std::bit_cast<double>(bits));
    }
    return numbers;
}

/// The words of a block as differences, as packed.js has them.
class UnpackedBlock {
public:
    explicit UnpackedBlock(const std::string& text) {
        const std::vector<std::uint8_t> small = unpackedBytes(text);
        std::vector<std::uint8_t> bytes(1 << 22);
        uLongf size = bytes.size();
        REQUIRE(uncompress(bytes.data(), &size, small.data(), small.size()) == Z_OK);
        const std::size_t count = size / 4;
        for (std::size_t i = 0; i < count; ++i) {
            std::uint32_t folded = 0;
            for (std::size_t k = 0; k < 4; ++k) folded |= static_cast<std::uint32_t>(bytes[k * count + i]) << (8 * k);
            differences_.push_back(folded >> 1 ^ (folded % 2 == 1 ? ~std::uint32_t{0} : 0u));
        }
    }

    std::size_t size() const { return differences_.size(); }

    std::vector<double> floats(std::size_t first, std::size_t count) const {
        std::vector<double> numbers;
        std::uint32_t word = 0;
        for (std::size_t i = first; i < first + count; ++i) {
            word += differences_.at(i);
            numbers.push_back(static_cast<double>(std::bit_cast<float>(word)));
        }
        return numbers;
    }

    /// NaN where there is none.
    std::vector<double> steps(std::size_t first, std::size_t count, double step) const {
        std::vector<double> numbers;
        std::uint32_t word = 0;
        std::uint32_t change = 0;
        for (std::size_t i = first; i < first + count; ++i) {
            change += differences_.at(i);
            word += change;
            const auto whole = static_cast<std::int32_t>(word);
            const bool isNone = whole == std::numeric_limits<std::int32_t>::min();
            numbers.push_back(isNone ? std::numeric_limits<double>::quiet_NaN() : whole * step);
        }
        return numbers;
    }

private:
    std::vector<std::uint32_t> differences_;
};

}  // namespace plumb::compare
