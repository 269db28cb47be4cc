// SPDX-License-Identifier: MIT
// How is a colour described?
#pragma once
#include <cstdint>

namespace plumb::games {

/// Red, green and blue as a screen shows them, and alpha, each 0 to 1 [-]. An alpha of 1 hides everything behind it.
struct Color {
    double red = 0, green = 0, blue = 0;
    double alpha = 1;

    /// 0xrrggbb.
    static constexpr Color hex(std::uint32_t rgb) {
        return {((rgb >> 16) & 255) / 255.0, ((rgb >> 8) & 255) / 255.0, (rgb & 255) / 255.0, 1};
    }
    /// The same colour with its alpha multiplied by share.
    constexpr Color faded(double share) const { return {red, green, blue, alpha * share}; }

    friend bool operator==(const Color&, const Color&) = default;
};

/// a at share 0, b at share 1, linear in between.
constexpr Color mix(const Color& a, const Color& b, double share) {
    const auto part = [share](double from, double to) { return from + (to - from) * share; };
    return {part(a.red, b.red), part(a.green, b.green), part(a.blue, b.blue), part(a.alpha, b.alpha)};
}
constexpr Color lighter(const Color& color, double share) {
    return mix(color, Color{1, 1, 1, color.alpha}, share);
}
constexpr Color darker(const Color& color, double share) {
    return mix(color, Color{0, 0, 0, color.alpha}, share);
}

}  // namespace plumb::games
