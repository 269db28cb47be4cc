// SPDX-License-Identifier: MIT
#include <compare/report/packed_numbers.h>

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

namespace plumb::compare {
namespace {

/// 0, -1, 1, -2, ... become 0, 1, 2, 3, ...: a number of small size then has high bytes 0, whatever its sign.
std::uint32_t folded(std::uint32_t difference) {
    return difference << 1 ^ (difference >> 31 != 0 ? ~std::uint32_t{0} : 0u);
}

constexpr auto noSteps = std::numeric_limits<std::int32_t>::min();

std::uint32_t wholeSteps(double number, double step) {
    const double steps = std::round(number / step);
    constexpr double most = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::uint32_t>(std::abs(steps) <= most ? static_cast<std::int32_t>(steps) : noSteps);
}

/// Conversion to float is undefined for numbers beyond float's range, which a run that blew up has.
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

std::string packNumbers(std::span<const double> numbers) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(numbers.size() * 8);
    for (const double number : numbers) {
        const auto bits = std::bit_cast<std::uint64_t>(number);
        for (std::size_t i = 0; i < 8; ++i) bytes.push_back(static_cast<std::uint8_t>(bits >> (8 * i) & 0xFFu));
    }
    return base64(bytes);
}

PackedPart PackedBlock::addFloats(std::span<const double> numbers) {
    const PackedPart part{words_.size(), numbers.size()};
    std::uint32_t before = 0;
    for (const double number : numbers) {
        const auto word = std::bit_cast<std::uint32_t>(toFloat(number));
        words_.push_back(folded(word - before));
        before = word;
    }
    return part;
}

PackedPart PackedBlock::addSteps(std::span<const double> numbers, double step) {
    const PackedPart part{words_.size(), numbers.size()};
    std::uint32_t before = 0;
    std::uint32_t change = 0;
    for (const double number : numbers) {
        const std::uint32_t word = wholeSteps(number, step);
        words_.push_back(folded(word - before - change));
        change = word - before;
        before = word;
    }
    return part;
}

std::string PackedBlock::text() const {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * words_.size());
    for (unsigned shift = 0; shift < 32; shift += 8)
        for (const std::uint32_t word : words_) bytes.push_back(static_cast<std::uint8_t>(word >> shift & 0xFFu));
    uLongf size = compressBound(static_cast<uLong>(bytes.size()));
    std::vector<std::uint8_t> small(size);
    const int state =
        compress2(small.data(), &size, bytes.data(), static_cast<uLong>(bytes.size()), Z_BEST_COMPRESSION);
    if (state != Z_OK) throw std::runtime_error("zlib did not compress: error " + std::to_string(state));
    small.resize(size);
    return base64(small);
}

}  // namespace plumb::compare
