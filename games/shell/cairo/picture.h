// SPDX-License-Identifier: MIT
// Where are the pixels of a picture?
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <games/frame/drawing.h>

namespace plumb::games {

/// Pixels that it does not own, row by row from the top: 0xAARRGGBB with red, green and blue multiplied by alpha, as in
/// Cairo's ARGB32.
struct PixelView {
    std::uint32_t* pixels = nullptr;
    PixelSize size;
    int stride = 0;  ///< from one row to the next [bytes]
};

/// A picture that owns its pixels. At first all are transparent.
class Picture {
public:
    explicit Picture(PixelSize size)
        : size_(size), pixels_(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height)) {}

    PixelView view() { return {pixels_.data(), size_, size_.width * 4}; }
    PixelSize size() const { return size_; }
    std::uint32_t at(int x, int y) const {
        return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width) +
                       static_cast<std::size_t>(x)];
    }

    friend bool operator==(const Picture&, const Picture&) = default;

private:
    PixelSize size_;
    std::vector<std::uint32_t> pixels_;
};

/// Throws std::runtime_error when the file cannot be written.
void writePng(const PixelView& picture, const std::string& file);

}  // namespace plumb::games
