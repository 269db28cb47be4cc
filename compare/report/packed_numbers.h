// SPDX-License-Identifier: MIT
// How do many numbers travel in a page?
#pragma once
#include <cstdint>
#include <span>
#include <string>

namespace plumb::compare {

/// RFC 4648 section 4, with padding.
std::string base64(std::span<const std::uint8_t> bytes);

enum class NumberWidth {
    Float32 = 4,  ///< 7 digits; beyond its range, infinite
    Float64 = 8,  ///< as they are
};

/// The numbers as IEEE 754, least significant byte first, in base64: a page reads them as a typed array.
std::string packNumbers(std::span<const double> numbers, NumberWidth width);

}  // namespace plumb::compare
