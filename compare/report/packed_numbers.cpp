// SPDX-License-Identifier: MIT
#include <compare/report/packed_numbers.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <string_view>
#include <vector>

namespace plumb::compare {
namespace {

template <typename Bits>
void appendLittleEndian(std::vector<std::uint8_t>& bytes, Bits bits) {
    for (std::size_t i = 0; i < sizeof(Bits); ++i)
        bytes.push_back(static_cast<std::uint8_t>((bits >> (8 * i)) & 0xFFu));
}

/// A conversion to float is undefined beyond float's range, and a run that blew up has such numbers.
float toFloat(double number) {
    constexpr double largest = std::numeric_limits<float>::max();
    if (std::abs(number) > largest)
        return std::copysign(std::numeric_limits<float>::infinity(), number < 0 ? -1.0f : 1.0f);
    return static_cast<float>(number);
}

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
        std::uint32_t group = 0;
        for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < count ? bytes[i + k] : 0u);
        for (std::size_t k = 0; k < 4; ++k) text += k <= count ? digits[group >> (18 - 6 * k) & 63u] : '=';
    }
    return text;
}

std::string packNumbers(std::span<const double> numbers, NumberWidth width) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(numbers.size() * static_cast<std::size_t>(width));
    for (const double number : numbers) {
        if (width == NumberWidth::Float64) {
            appendLittleEndian(bytes, std::bit_cast<std::uint64_t>(number));
        } else {
            appendLittleEndian(bytes, std::bit_cast<std::uint32_t>(toFloat(number)));
        }
    }
    return base64(bytes);
}

}  // namespace plumb::compare
