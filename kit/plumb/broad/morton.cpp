// SPDX-License-Identifier: MIT
#include <plumb/broad/morton.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace plumb {
namespace {

constexpr int axisBits = 14;  // two axes and a class of four bits make a key
constexpr double axisCells = 1 << axisBits;
constexpr int topClass = 15;

struct Item {
    std::uint32_t key, index;
};

// 00000000 00000000 abcdefgh ijklmnop -> 0a0b0c0d 0e0f0g0h 0i0j0k0l 0m0n0o0p
std::uint32_t spread(std::uint32_t x) {
    x = (x | x << 8) & 0x00FF00FFu;
    x = (x | x << 4) & 0x0F0F0F0Fu;
    x = (x | x << 2) & 0x33333333u;
    return (x | x << 1) & 0x55555555u;
}

// By key, and where keys are equal in the order given.
class RadixSort {
public:
    void operator()(std::span<Item> items) {
        std::array<std::array<std::uint32_t, 256>, 4> counts{};
        for (const Item& item : items)
            for (unsigned digit = 0; digit < 4; ++digit) ++counts[digit][item.key >> 8 * digit & 255];
        if (other_.size() < items.size()) other_.resize(items.size());
        std::span<Item> from = items;
        std::span<Item> to = std::span(other_).first(items.size());
        for (unsigned digit = 0; digit < 4; ++digit) {
            if (counts[digit][items[0].key >> 8 * digit & 255] == items.size()) continue;
            std::uint32_t sum = 0;
            for (std::uint32_t& count : counts[digit]) sum += std::exchange(count, sum);
            for (const Item& item : from) to[counts[digit][item.key >> 8 * digit & 255]++] = item;
            std::swap(from, to);
        }
        if (from.data() != items.data()) std::copy(from.begin(), from.end(), items.begin());
    }

private:
    std::vector<Item> other_;
};

// The centre, halved so that no sum of finite numbers overflows. Opposite infinities make NaN.
Vec2 halfCenter(const Aabb& box) {
    return 0.25 * box.lower + 0.25 * box.upper;
}

/// One axis of the cells that a range of centres is put into.
struct Axis {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
    double scale = 0;

    void hold(double x) {
        if (!std::isfinite(x)) return;
        low = std::min(low, x);
        high = std::max(high, x);
    }
    bool divides() const { return high - low > 0; }
    void fit() { scale = divides() ? axisCells / (high - low) : 0; }
    // Written so that NaN, from an infinite scale or centre, ends in the first cell.
    std::uint32_t cell(double x) const {
        const double place = (x - low) * scale;
        if (!(place > 0)) return 0;
        return place < axisCells ? static_cast<std::uint32_t>(place) : static_cast<std::uint32_t>(axisCells) - 1;
    }
};

// Gives every item of the range its cell, after the key's class bits; false if all centres are in one place.
bool assignCells(std::span<Item> items, std::span<const Aabb> boxes) {
    Axis x, y;
    for (const Item& item : items) {
        const Vec2 center = halfCenter(boxes[item.index]);
        x.hold(center.x());
        y.hold(center.y());
    }
    if (!x.divides() && !y.divides()) return false;
    x.fit();
    y.fit();
    for (Item& item : items) {
        const Vec2 center = halfCenter(boxes[item.index]);
        item.key =
            (item.key >> 2 * axisBits << 2 * axisBits) | spread(x.cell(center.x())) | spread(y.cell(center.y())) << 1;
    }
    return true;
}

// The power of two at or below the larger side, within those of floats; infinite and NaN count as the largest.
int sizeExponent(const Aabb& box) {
    const double size = std::max(box.upper.x() - box.lower.x(), box.upper.y() - box.lower.y());
    if (!(size < 0x1p127)) return 127;
    return size > 0x1p-126 ? std::ilogb(size) : -126;
}

std::vector<Item> classedItems(std::span<const Aabb> boxes) {
    std::array<std::uint32_t, 256> counts{};
    std::vector<Item> items(boxes.size());
    for (std::uint32_t i = 0; i < items.size(); ++i) {
        const auto exponent = static_cast<std::uint32_t>(sizeExponent(boxes[i]) + 126);
        items[i] = {exponent, i};
        ++counts[exponent];
    }
    std::uint32_t median = 0;
    for (std::size_t below = counts[0]; 2 * below < boxes.size(); below += counts[median]) ++median;
    for (Item& item : items) {
        const int above = static_cast<int>(item.key) - static_cast<int>(median) - 3;
        const int sizeClass = above < 0 ? 0 : std::min(topClass, 1 + above / 4);
        item.key = static_cast<std::uint32_t>(sizeClass) << 2 * axisBits;
    }
    return items;
}

struct Range {
    std::size_t begin, end;
};

}  // namespace

std::vector<std::uint32_t> mortonOrder(std::span<const Aabb> boxes, std::uint32_t runLimit) {
    std::vector<Item> items = classedItems(boxes);
    RadixSort sort;
    std::vector<Range> open;
    if (!items.empty()) open.push_back({0, items.size()});
    while (!open.empty()) {
        const Range range = open.back();
        open.pop_back();
        const std::span<Item> part = std::span(items).subspan(range.begin, range.end - range.begin);
        const bool divided = assignCells(part, boxes);
        if (!divided && range.end - range.begin < items.size()) continue;
        sort(part);
        // The centres farthest apart are in different cells by now, so every run is shorter than the range was.
        for (std::size_t begin = range.begin; divided && begin < range.end;) {
            std::size_t end = begin + 1;
            while (end < range.end && items[end].key == items[begin].key) ++end;
            if (end - begin > runLimit) open.push_back({begin, end});
            begin = end;
        }
    }
    std::vector<std::uint32_t> order(items.size());
    for (std::size_t i = 0; i < items.size(); ++i) order[i] = items[i].index;
    return order;
}

}  // namespace plumb
