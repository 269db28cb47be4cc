// SPDX-License-Identifier: MIT
// Which number identifies the whole state of a game?
#pragma once
#include <bit>
#include <cstdint>
#include <string_view>

namespace plumb::games {

/// FNV-1a over the bytes of the added values, in the order of adding, the lowest byte of each value first.
class Hash {
public:
    Hash& add(std::uint64_t bits) {
        for (int byte = 0; byte < 8; ++byte) value_ = (value_ ^ ((bits >> (8 * byte)) & 255)) * 0x100000001B3u;
        return *this;
    }
    Hash& add(std::int64_t number) { return add(static_cast<std::uint64_t>(number)); }
    Hash& add(int number) { return add(std::int64_t{number}); }
    Hash& add(bool flag) { return add(std::int64_t{flag}); }
    Hash& add(double number) { return add(std::bit_cast<std::uint64_t>(number)); }
    Hash& add(std::string_view text) {
        for (const char letter : text) add(std::uint64_t{static_cast<unsigned char>(letter)});
        return add(static_cast<std::uint64_t>(text.size()));
    }
    std::uint64_t value() const { return value_; }

private:
    std::uint64_t value_ = 0xCBF29CE484222325u;
};

}  // namespace plumb::games
