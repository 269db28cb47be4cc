// SPDX-License-Identifier: MIT
// What lies in a box, along a way or near a point of a space that wraps around?
#include <plumb/space/space.h>

#include <algorithm>
#include <limits>

namespace plumb {

namespace {

/// Calls visit(round) for each from one to another, up or down, until visit returns false.
template <class Visit>
void throughRounds(double first, double last, Visit&& visit) {
    const double step = last < first ? -1 : 1;
    const int count = around::countFrom(step * first, step * last);
    for (int i = 0; i < count; ++i)
        if (!visit(first + step * i)) return;
}

}  // namespace

/// A shape is told of with each shift once: in the first round of the box, or as the shape itself and not an image.
void Space::queryAround(std::span<const Crowd> crowds, const Aabb& box, Visit visit) const {
    const Vec2 first = wrap_.roundOf(box.lower);
    const Aabb larger = around::spare(box);
    around::forEachRound(first, lastRound(box), [&](const Vec2& round) {
        const Bounds bounds = BoundsRounding(origin_)(shifted(larger, -wrap_.lengthOf(round)));
        for (const Crowd& crowd : crowds) {
            crowd.tree.query(bounds, [&](std::uint32_t slot) {
                const ProxyId id = crowd.tree.members()[slot], real = rounds_[id].real;
                if (seats_[real].moved || (round - first).cwiseMin(rounds_[id].image).maxCoeff() > 0) return;
                const Vec2 shift = wrap_.lengthOf(round - roundsOf(id));
                if (overlap(shifted(placed_[real].box, shift), box)) visit(real, shift);
            });
        }
    });
    for (const ProxyId id : moved_)
        if (seats_[id].moved) forEachShift(box, placed_[id].box, [&](const Vec2& shift) { visit(id, shift); });
}

/// The part of a way within half a size of a round, along one axis; all of it where the space does not wrap.
RayPart Space::partInRound(const Vec2& halfSize, const Vec2& from, const Vec2& to, int axis, double round) const {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const std::optional<double>& size = axis == 0 ? wrap_.width : wrap_.height;
    if (!size) return {};
    Aabb strip{{-endless, -endless}, {endless, endless}};
    strip.lower[axis] = round * *size - halfSize[axis];
    strip.upper[axis] = (round + 1) * *size + halfSize[axis];
    return clipRay(from, to, strip);
}

/// Column by column of rounds, and in each by those rounds that the way leads through.
void Space::castAround(const Vec2& halfSize, const Vec2& from, const Vec2& to, VisitWhile visit) const {
    double wanted = 1;
    const auto both = [](const RayPart& a, const RayPart& b) {
        return RayPart{std::max(a.first, b.first), std::min(a.last, b.last)};
    };
    const auto castIn = [&](const Vec2& round, const RayPart& part) {
        const Vec2 back = wrap_.lengthOf(round);
        const RayPart met = both(part, partWithin(halfSize, from - back, to - back));
        if (!(met.first <= met.last)) return;
        castTrees(halfSize, from - back, to - back, met, [&](ProxyId id) {
            const ProxyId real = rounds_[id].real;
            if (!seats_[real].moved) wanted = visit(real, wrap_.lengthOf(round - roundsOf(id)));
            return wanted;
        });
    };
    // From the first round that the part's boxes reach into to the last, in the order of the way.
    const auto goThrough = [&](int axis, const RayPart& part, auto&& look) {
        const Vec2 a = from + (to - from) * part.first, b = from + (to - from) * part.last;
        const bool back = to[axis] < from[axis];
        const Vec2 first = wrap_.roundOf(back ? Vec2(a + halfSize) : Vec2(a - halfSize));
        const Vec2 last = wrap_.roundOf(back ? Vec2(b - halfSize) : Vec2(b + halfSize));
        const double one = (axis == 0 ? wrap_.width : wrap_.height) ? 1 : 0;
        const double more = back ? -one : one;  // for roundings
        throughRounds(first[axis] - more, last[axis] + more, [&](double round) {
            const RayPart here = both(part, partInRound(halfSize, from, to, axis, round));
            if (here.first <= here.last && here.first <= wanted) look(round, here);
            return !(here.first > wanted && here.first <= here.last);
        });
    };
    goThrough(0, {}, [&](double x, const RayPart& column) {
        goThrough(1, column, [&](double y, const RayPart& part) { castIn({x, y}, part); });
    });
    for (const ProxyId id : moved_) {
        if (!seats_[id].moved) continue;
        const Aabb way = inflate({from.cwiseMin(to), from.cwiseMax(to)}, halfSize.maxCoeff());
        forEachShift(way, placed_[id].box, [&](const Vec2& shift) {
            const Aabb box = shifted(placed_[id].box, shift);
            const RayPart met = clipRay(from, to, {box.lower - halfSize, box.upper + halfSize});
            if (met.first <= met.last && met.first <= wanted) wanted = visit(id, shift);
        });
    }
}

/// The nearest image of anything is within half a round of the point: in its round, or in one beside it.
void Space::findAround(const Vec2& point, double within, VisitWhile visit) const {
    const Vec2 own = wrap_.roundOf(point);
    const auto probeFrom = [&](const Vec2& round) {
        probe(pointProbe(point - wrap_.lengthOf(round), origin_, lanes_), probeLimit(within), [&](ProxyId id) {
            const ProxyId real = rounds_[id].real;
            if (!seats_[real].moved) within = visit(real, wrap_.lengthOf(round - roundsOf(id)));
            return probeLimit(within);
        });
    };
    const Vec2 one(wrap_.width ? 1 : 0, wrap_.height ? 1 : 0);
    probeFrom(own);
    around::forEachRound(own - one, own + one, [&](const Vec2& round) {
        if (round != own) probeFrom(round);
    });
    constexpr double nearly = 1 - 1e-12, endless = std::numeric_limits<double>::infinity();
    const Vec2 reach(wrap_.width.value_or(endless), wrap_.height.value_or(endless));
    for (const ProxyId id : moved_) {
        if (!seats_[id].moved) continue;
        forEachShift({point - reach, point + reach}, placed_[id].box, [&](const Vec2& shift) {
            const Aabb box = shifted(placed_[id].box, shift);
            const Vec2 away = (box.lower - point).cwiseMax(point - box.upper);
            if (away.maxCoeff() * nearly <= within) within = visit(id, shift);
        });
    }
}

}  // namespace plumb
