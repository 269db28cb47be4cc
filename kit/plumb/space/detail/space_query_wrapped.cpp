// SPDX-License-Identifier: MIT
// Which shapes are in a box, along a ray or near a point of a space that wraps around?
#include <plumb/space/detail/space.h>

#include <algorithm>
#include <limits>

namespace plumb {

namespace {

/// Calls visit(index) for whole numbers from first to last, upwards or downwards, until visit returns false.
template <class Visit>
void forEachIndex(double first, double last, Visit&& visit) {
    const double step = last < first ? -1 : 1;
    const int count = periodic::countFrom(step * first, step * last);
    for (int i = 0; i < count; ++i)
        if (!visit(first + step * i)) return;
}

}  // namespace

/// Each shift of a shape is reported once: in the first periodic image of the box, or as the shape itself rather than
/// an image of it.
void Space::queryWrapped(std::span<const Partition> partitions, const Aabb& box, Visit visit) const {
    const Vec2 first = wrap_.imageIndex(box.lower);
    const Aabb larger = periodic::padded(box);
    periodic::forEachImage(first, lastImage(box), [&](const Vec2& image) {
        const Bounds bounds = BoundsRounding(origin_)(shifted(larger, -wrap_.imageOffset(image)));
        for (const Partition& partition : partitions) {
            partition.tree.query(bounds, [&](std::uint32_t slot) {
                const ProxyId id = partition.tree.members()[slot], original = imageRecords_[id].original;
                if (entries_[original].moved || (image - first).cwiseMin(imageRecords_[id].image).maxCoeff() > 0)
                    return;
                const Vec2 shift = wrap_.imageOffset(image - imageIndexOf(id));
                if (overlap(shifted(boxes_[original].box, shift), box)) visit(original, shift);
            });
        }
    });
    for (const ProxyId id : moved_)
        if (entries_[id].moved) forEachShift(box, boxes_[id].box, [&](const Vec2& shift) { visit(id, shift); });
}

/// The part of a ray within half a size of one periodic image, along one axis; all of it where the space does not wrap.
RayPart Space::partInImage(const Vec2& halfSize, const Vec2& from, const Vec2& to, int axis, double image) const {
    constexpr double endless = std::numeric_limits<double>::infinity();
    const std::optional<double>& size = axis == 0 ? wrap_.width : wrap_.height;
    if (!size) return {};
    Aabb strip{{-endless, -endless}, {endless, endless}};
    strip.lower[axis] = image * *size - halfSize[axis];
    strip.upper[axis] = (image + 1) * *size + halfSize[axis];
    return clipRay(from, to, strip);
}

/// Column by column of periodic images, and in each column those images that the ray passes through.
void Space::castWrapped(const Vec2& halfSize, const Vec2& from, const Vec2& to, VisitWhile visit) const {
    double wanted = 1;
    const auto both = [](const RayPart& a, const RayPart& b) {
        return RayPart{std::max(a.first, b.first), std::min(a.last, b.last)};
    };
    const auto castIn = [&](const Vec2& image, const RayPart& part) {
        const Vec2 back = wrap_.imageOffset(image);
        const RayPart met = both(part, clipToBounds(halfSize, from - back, to - back));
        if (!(met.first <= met.last)) return;
        castTrees(halfSize, from - back, to - back, met, [&](ProxyId id) {
            const ProxyId original = imageRecords_[id].original;
            if (!entries_[original].moved) wanted = visit(original, wrap_.imageOffset(image - imageIndexOf(id)));
            return wanted;
        });
    };
    // From the first image that the boxes of this part extend into to the last, in the order of the ray.
    const auto castThrough = [&](int axis, const RayPart& part, auto&& visitor) {
        const Vec2 a = from + (to - from) * part.first, b = from + (to - from) * part.last;
        const bool back = to[axis] < from[axis];
        const Vec2 first = wrap_.imageIndex(back ? Vec2(a + halfSize) : Vec2(a - halfSize));
        const Vec2 last = wrap_.imageIndex(back ? Vec2(b - halfSize) : Vec2(b + halfSize));
        const double one = (axis == 0 ? wrap_.width : wrap_.height) ? 1 : 0;
        const double more = back ? -one : one;  // for rounding
        forEachIndex(first[axis] - more, last[axis] + more, [&](double image) {
            const RayPart here = both(part, partInImage(halfSize, from, to, axis, image));
            if (here.first <= here.last && here.first <= wanted) visitor(image, here);
            return !(here.first > wanted && here.first <= here.last);
        });
    };
    castThrough(0, {}, [&](double x, const RayPart& column) {
        castThrough(1, column, [&](double y, const RayPart& part) { castIn({x, y}, part); });
    });
    for (const ProxyId id : moved_) {
        if (!entries_[id].moved) continue;
        const Aabb path = inflate({from.cwiseMin(to), from.cwiseMax(to)}, halfSize.maxCoeff());
        forEachShift(path, boxes_[id].box, [&](const Vec2& shift) {
            const Aabb box = shifted(boxes_[id].box, shift);
            const RayPart met = clipRay(from, to, {box.lower - halfSize, box.upper + halfSize});
            if (met.first <= met.last && met.first <= wanted) wanted = visit(id, shift);
        });
    }
}

/// The nearest image of any shape is within half a period of the point: in the point's own image, or in one beside it.
void Space::findNearWrapped(const Vec2& point, double within, VisitWhile visit) const {
    const Vec2 own = wrap_.imageIndex(point);
    const auto probeFrom = [&](const Vec2& image) {
        probe(pointProbe(point - wrap_.imageOffset(image), origin_, lanes_), probeLimit(within), [&](ProxyId id) {
            const ProxyId original = imageRecords_[id].original;
            if (!entries_[original].moved) within = visit(original, wrap_.imageOffset(image - imageIndexOf(id)));
            return probeLimit(within);
        });
    };
    const Vec2 one(wrap_.width ? 1 : 0, wrap_.height ? 1 : 0);
    probeFrom(own);
    periodic::forEachImage(own - one, own + one, [&](const Vec2& image) {
        if (image != own) probeFrom(image);
    });
    constexpr double nearly = 1 - 1e-12, endless = std::numeric_limits<double>::infinity();
    const Vec2 period(wrap_.width.value_or(endless), wrap_.height.value_or(endless));
    for (const ProxyId id : moved_) {
        if (!entries_[id].moved) continue;
        forEachShift({point - period, point + period}, boxes_[id].box, [&](const Vec2& shift) {
            const Aabb box = shifted(boxes_[id].box, shift);
            const Vec2 away = (box.lower - point).cwiseMax(point - box.upper);
            if (away.maxCoeff() * nearly <= within) within = visit(id, shift);
        });
    }
}

}  // namespace plumb
