// SPDX-License-Identifier: MIT
#include <plumb/broad/grid.h>

#include <algorithm>
#include <cmath>

#include <plumb/broad/detail/sorted_pairs.h>
#include <plumb/math/check.h>

namespace plumb {
namespace {

/// Larger boxes are in no cell, because the cell size has to be finite as well [m].
constexpr double largestSize = 1e300;

/// Up to so many cells from the origin, positions are resolved to a thousandth of a cell.
constexpr double farthestCell = 0x1p40;

double sizeOf(const Aabb& extent) {
    return (extent.upper - extent.lower).maxCoeff();
}

/// A box in its cell.
struct Entry {
    int level;  ///< cells of level k are 2^k times as wide as the finest
    std::int64_t y, x;
    std::uint32_t index;
    friend auto operator<=>(const Entry&, const Entry&) = default;
};

/// The value that this share of the values is below. Reorders the values.
double quantile(std::vector<double>& values, double share) {
    const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), at, values.end());
    return *at;
}

/// Statistics of the boxes in cells by which the grid is laid out; a few boxes that are far away or large do not change
/// them.
struct BoxStatistics {
    Vec2 middle{0, 0};   ///< of the lower corners [m]
    double size = 0;     ///< nine of ten boxes have no larger side [m]
    double spacing = 0;  ///< as if the middle quarter of them were distributed evenly, in a square or in a row [m]
};

BoxStatistics statisticsOf(std::span<const Aabb> extents) {
    BoxStatistics statistics;
    if (extents.empty()) return statistics;
    const auto count = static_cast<double>(extents.size());
    std::vector<double> values(extents.size());
    Vec2 width(0, 0);
    for (const int axis : {0, 1}) {
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = extents[i].lower[axis];
        statistics.middle[axis] = quantile(values, 0.5);
        width[axis] = std::min(quantile(values, 0.75) - quantile(values, 0.25), largestSize);
    }
    const double inSquare = std::sqrt(width.x()) * std::sqrt(width.y()) / std::sqrt(count / 4);
    statistics.spacing = std::max(inSquare, width.maxCoeff() / (count / 2));
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = sizeOf(extents[i]);
    statistics.size = quantile(values, 0.9);
    return statistics;
}

class Grid {
public:
    Grid(const Vec2& origin, double finest) : origin_(origin), finest_(finest) {}

    /// The finest level whose cells are at least twice as wide as the box.
    int levelOf(const Aabb& extent) const {
        const double twice = 2 * sizeOf(extent);
        if (twice <= finest_) return 0;
        int needed = 0, had = 0;
        const double neededPart = std::frexp(twice, &needed), hadPart = std::frexp(finest_, &had);
        return needed - had + (hadPart < neededPart ? 1 : 0);
    }
    Entry cellOf(const Vec2& point, int level) const {
        const double size = std::ldexp(finest_, level);
        const auto cell = [&](int axis) {
            const double cells = std::floor((point[axis] - origin_[axis]) / size);
            return static_cast<std::int64_t>(std::clamp(cells, -farthestCell, farthestCell));
        };
        return {level, cell(1), cell(0), 0};
    }

private:
    Vec2 origin_;
    double finest_;
};

/// Empty cells cost nothing, so wide cells have no advantage: they only hold more boxes. But cells are counted from the
/// middle: of a million boxes in a row, each a million cells from the next, the last is farthestCell away.
constexpr double minSizeOfSpacing = 0x1p-20;

double finestFor(const BoxStatistics& statistics, const GridSettings& settings) {
    if (settings.cellSize > 0) return std::min(settings.cellSize, largestSize);
    const double chosen = std::max(std::min(2 * statistics.size, largestSize), minSizeOfSpacing * statistics.spacing);
    return chosen > 0 ? chosen : 1;
}

/// Tests pairs of boxes, and counts the tests.
class Tester {
public:
    explicit Tester(std::span<const Aabb> boxes) : boxes_(boxes) {}
    void test(std::uint32_t i, std::uint32_t j) {
        ++tests_;
        if (overlap(boxes_[i], boxes_[j])) found_.push_back(pairOf(i, j));
    }
    PairSearch result() const { return {sortPairs(found_, boxes_.size()), tests_}; }

private:
    std::span<const Aabb> boxes_;
    std::vector<Pair> found_;
    std::uint64_t tests_ = 0;
};

using Entries = std::vector<Entry>;

/// Each box against the boxes after it in its own cell and the next, and in the three cells of the row above: the boxes
/// before it have been tested against it. The range in the row above advances with it, as both are sorted.
void testWithinLevels(const Entries& entries, Tester& tester) {
    std::size_t above = 0;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const Entry& at = entries[i];
        const auto isBy = [&](std::size_t j, std::int64_t y) {
            return j < entries.size() && entries[j].level == at.level && entries[j].y == y && entries[j].x <= at.x + 1;
        };
        for (std::size_t j = i + 1; isBy(j, at.y); ++j) tester.test(at.index, entries[j].index);
        while (above < entries.size() && entries[above] < Entry{at.level, at.y + 1, at.x - 1, 0}) ++above;
        for (std::size_t j = above; isBy(j, at.y + 1); ++j) tester.test(at.index, entries[j].index);
    }
}

/// Each box against the boxes of coarser levels: in the cells that it lies in, and in the cells before them from which
/// a box may extend into them.
void testAcrossLevels(const Entries& entries, std::span<const Aabb> extents, const Grid& grid, Tester& tester) {
    std::vector<Entries::const_iterator> starts;  // of the levels
    for (auto it = entries.begin(); it != entries.end(); ++it)
        if (it == entries.begin() || it->level != (it - 1)->level) starts.push_back(it);
    for (const Entry& at : entries) {
        for (const auto start : starts) {
            const int level = start->level;
            if (level <= at.level) continue;
            const Entry low = grid.cellOf(extents[at.index].lower, level);
            const Entry high = grid.cellOf(extents[at.index].upper, level);
            for (std::int64_t y = low.y - 1; y <= high.y; ++y)
                for (auto it = std::lower_bound(start, entries.end(), Entry{level, y, low.x - 1, 0});
                     it != entries.end() && it->level == level && it->y == y && it->x <= high.x; ++it)
                    tester.test(at.index, it->index);
        }
    }
}

}  // namespace

PairSearch gridPairs(std::span<const Aabb> boxes, const GridSettings& settings) {
    requireNotNegative(settings.cellSize, "GridSettings.cellSize");
    std::vector<Aabb> extents(boxes.size()), inCells;
    std::vector<std::uint32_t> cells, others;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (hasNaN(boxes[i])) continue;
        extents[i] = ordered(boxes[i]);
        const bool isInCell = extents[i].lower.allFinite() && sizeOf(extents[i]) <= largestSize;
        if (isInCell) inCells.push_back(extents[i]);
        (isInCell ? cells : others).push_back(i);
    }
    const BoxStatistics statistics = statisticsOf(inCells);
    const Grid grid(statistics.middle, finestFor(statistics, settings));
    Entries entries;
    entries.reserve(cells.size());
    for (const std::uint32_t i : cells) {
        entries.push_back(grid.cellOf(extents[i].lower, grid.levelOf(extents[i])));
        entries.back().index = i;
    }
    std::sort(entries.begin(), entries.end());

    Tester tester(boxes);
    testWithinLevels(entries, tester);
    testAcrossLevels(entries, extents, grid, tester);
    for (std::size_t k = 0; k < others.size(); ++k) {
        for (const std::uint32_t i : cells) tester.test(others[k], i);
        for (std::size_t m = k + 1; m < others.size(); ++m) tester.test(others[k], others[m]);
    }
    return tester.result();
}

}  // namespace plumb
