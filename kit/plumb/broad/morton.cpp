// SPDX-License-Identifier: MIT
#include <plumb/broad/morton.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <plumb/broad/radix_sort.h>
#include <plumb/math/detail/arrays.h>

namespace plumb {
namespace {

constexpr unsigned cellBits = 28;  // and a size class of four bits make a key
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

// The centre, halved so that no sum of finite numbers overflows. Opposite infinities make NaN.
Vec2 halfCenter(const Aabb& box) {
    return 0.25 * box.lower + 0.25 * box.upper;
}

/// One axis of the cells that divide a range of centres.
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
    void fit(double cells) { scale = divides() ? cells / (high - low) : 0; }
    // Written so that NaN, from an infinite scale or centre, gives the first cell.
    std::uint32_t cell(double x, double cells) const {
        const double place = (x - low) * scale;
        if (!(place > 0)) return 0;
        return place < cells ? static_cast<std::uint32_t>(place) : static_cast<std::uint32_t>(cells) - 1;
    }
};

// The power of two at or below a length, within the range of float; infinity and NaN count as the largest.
int exponentOf(double length) {
    if (!(length < 0x1p127)) return 127;
    if (!(length > 0x1p-126)) return -126;
    std::uint64_t bits = 0;  // the upper bits are the exponent, because the number is positive
    std::memcpy(&bits, &length, sizeof bits);
    return static_cast<int>(bits >> 52) - 1023;
}

/// How many bits of a key are used for each axis: so many that few of evenly distributed boxes share a cell, as more
/// bits would only cost sorting time; the longer axis has more, so that cells are about as wide as high.
struct CellBits {
    unsigned x, y;

    CellBits(std::size_t count, double width, double height) {
        const int all = std::min(static_cast<int>(std::bit_width(count)) + 5, static_cast<int>(cellBits));
        const int wider = exponentOf(width) - exponentOf(height);
        x = static_cast<unsigned>(std::clamp((all + wider) / 2, 0, std::min(all, 16)));
        y = static_cast<unsigned>(std::min(all - static_cast<int>(x), 16));
    }
    /// The lower bits of both interleaved, above them the additional bits of the longer axis.
    std::uint32_t key(std::uint32_t cellX, std::uint32_t cellY) const {
        const unsigned shared = std::min(x, y);
        const std::uint32_t low = (1u << shared) - 1;
        const std::uint32_t rest = x > y ? cellX >> shared : cellY >> shared;
        return spread(cellX & low) | spread(cellY & low) << 1 | rest << 2 * shared;
    }
};

// Gives every item of the range its cell, below the key's class bits; false if all centres are equal.
bool assignCells(std::span<Item> items, std::span<const Aabb> boxes) {
    Axis x, y;
    for (const Item& item : items) {
        const Vec2 center = halfCenter(boxes[item.index]);
        x.hold(center.x());
        y.hold(center.y());
    }
    if (!x.divides() && !y.divides()) return false;
    const CellBits bits(items.size(), x.high - x.low, y.high - y.low);
    const double cellsX = 1 << bits.x;
    const double cellsY = 1 << bits.y;
    x.fit(cellsX);
    y.fit(cellsY);
    for (Item& item : items) {
        const Vec2 center = halfCenter(boxes[item.index]);
        item.key =
            (item.key >> cellBits << cellBits) | bits.key(x.cell(center.x(), cellsX), y.cell(center.y(), cellsY));
    }
    return true;
}

// As a power of two, at or below the larger side.
int sizeExponent(const Aabb& box) {
    return exponentOf(std::max(box.upper.x() - box.lower.x(), box.upper.y() - box.lower.y()));
}

struct Range {
    std::size_t begin, end;
};

}  // namespace

struct MortonSort::Memory {
    std::vector<Item> items;
    std::vector<Range> open;
    std::vector<std::uint32_t> order;
    RadixSort<Item, 4> sort;

    void classify(std::span<const Aabb> boxes);
    void divide(const Range& range, std::span<const Aabb> boxes, std::uint32_t runLimit);
};

void MortonSort::Memory::classify(std::span<const Aabb> boxes) {
    std::array<std::uint32_t, 256> counts{};
    items.resize(boxes.size());
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
        item.key = static_cast<std::uint32_t>(sizeClass) << cellBits;
    }
}

void MortonSort::Memory::divide(const Range& range, std::span<const Aabb> boxes, std::uint32_t runLimit) {
    const std::span<Item> part = std::span(items).subspan(range.begin, range.end - range.begin);
    const bool divided = assignCells(part, boxes);
    if (!divided && part.size() < items.size()) return;
    sort(part, [](const Item& item) { return item.key; });
    // The two most distant centres are in different cells by now, so every run is shorter than the range was.
    for (std::size_t begin = range.begin; divided && begin < range.end;) {
        std::size_t end = begin + 1;
        while (end < range.end && items[end].key == items[begin].key) ++end;
        if (end - begin > runLimit) open.push_back({begin, end});
        begin = end;
    }
}

MortonSort::MortonSort() : memory_(std::make_unique<Memory>()) {}
MortonSort::MortonSort(const MortonSort&) : MortonSort() {}
MortonSort& MortonSort::operator=(const MortonSort&) {
    return *this;  // it holds no data between calls
}
MortonSort::MortonSort(MortonSort&&) noexcept = default;
MortonSort& MortonSort::operator=(MortonSort&&) noexcept = default;
MortonSort::~MortonSort() = default;

std::span<const std::uint32_t> MortonSort::operator()(std::span<const Aabb> boxes, std::uint32_t runLimit) {
    Memory& memory = *memory_;
    memory.classify(boxes);
    memory.open.clear();
    if (!boxes.empty()) memory.open.push_back({0, boxes.size()});
    while (!memory.open.empty()) {
        const Range range = memory.open.back();
        memory.open.pop_back();
        memory.divide(range, boxes, runLimit);
    }
    memory.order.resize(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) memory.order[i] = memory.items[i].index;
    return memory.order;
}

std::vector<std::uint32_t> mortonOrder(std::span<const Aabb> boxes, std::uint32_t runLimit) {
    MortonSort sort;
    const std::span<const std::uint32_t> order = sort(boxes, runLimit);
    return {order.begin(), order.end()};
}

std::size_t MortonSort::bytes() const {
    const Memory& m = *memory_;
    return sizeof m + bytesOf(m.items) + bytesOf(m.open) + bytesOf(m.order) + m.sort.bytes();
}

}  // namespace plumb
