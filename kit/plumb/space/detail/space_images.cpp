// SPDX-License-Identifier: MIT
// Which boxes do the trees of a space that wraps hold? The part of Space that decides.
#include <algorithm>
#include <tuple>

#include <plumb/math/detail/step_list.h>
#include <plumb/space/detail/space.h>

#include <plumb/math/detail/sorting.h>

namespace plumb {

namespace {

/// The box of a very fast shape that extends into more images than this along an axis is stored for these only [-].
constexpr double maxStoredImages = 16;

}  // namespace

Aabb Space::imageBox(ProxyId id) const {
    return shifted(periodic::padded(boxes_[imageRecords_[id].original].box), -wrap_.imageOffset(imageIndexOf(id)));
}

bool Space::hasAllImages(ProxyId id) const {
    if (!wrap_.any()) return true;
    const Aabb& box = boxes_[id].box;
    return (wrap_.imageIndex(box.upper) - wrap_.imageIndex(box.lower)).maxCoeff() < maxStoredImages;
}

/// When a shape has moved, its images have moved as well; images that are no longer needed are removed.
void Space::updateImages(ProxyId id) {
    const Aabb box = boxes_[id].box;
    const Vec2 first = wrap_.imageIndex(box.lower);
    const Vec2 last = (wrap_.imageIndex(periodic::padded(box).upper) - first)
                          .cwiseMin(Vec2(maxStoredImages - 1, maxStoredImages - 1));
    imageRecords_[id].base = first;
    const std::vector<ProxyId>& images = imageRecords_[id].images;
    StepList<ProxyId> old(images.begin(), images.end()), now;
    periodic::forEachImage({0, 0}, last, [&](const Vec2& image) {
        if (image.isZero(0)) return;
        const auto same = [&](ProxyId other) { return imageRecords_[other].image == image; };
        const auto known = std::find_if(old.begin(), old.end(), same);
        const bool isNew = known == old.end();
        const ProxyId member = isNew ? acquire() : *known;
        if (!isNew) old.erase(known);
        if (imageRecords_.size() <= member) imageRecords_.resize(member + std::size_t{1});
        if (isNew) imageRecords_[member] = {id, image, {0, 0}, {}};
        entries_[member].fixed = entries_[id].fixed;
        entries_[member].moved = true;
        moved_.push_back(member);
        now.push_back(member);
    });
    imageRecords_[id].images.assign(old.begin(), old.end());
    removeImages(id);
    imageRecords_[id].images.assign(now.begin(), now.end());
}

void Space::removeImages(ProxyId id) {
    for (const ProxyId image : imageRecords_[id].images) {
        leave(image);
        entries_[image].moved = false;
        free_.push_back(image);
    }
    imageRecords_[id].images.clear();
}

/// Two entries of the trees that may overlap. Each pair of shapes is taken once with each shift: where along each axis
/// one of the two entries is not an image.
void Space::addShiftedPair(ProxyId memberA, ProxyId memberB) {
    const ProxyId a = imageRecords_[memberA].original, b = imageRecords_[memberB].original;
    if (!mayPair(filterKeys_[a], filterKeys_[b])) return;
    if (imageRecords_[memberA].image.cwiseMin(imageRecords_[memberB].image).maxCoeff() > 0) return;
    const bool ordered = a < b;
    const Vec2 inA = imageIndexOf(memberA), inB = imageIndexOf(memberB);
    const ShiftedPair found{{std::min(a, b), std::max(a, b)}, ordered ? Vec2(inA - inB) : Vec2(inB - inA)};
    const Vec2 shift = wrap_.imageOffset(found.image);
    if (!boxesOverlap(found.pair.a, found.pair.b, shift)) return;
    if (!previousBoxesOverlap(found.pair.a, found.pair.b, shift)) shiftedPairs_.push_back(found);
}

void Space::sortShiftedPairs() {
    sortBy(shiftedPairs_, [](const ShiftedPair& found) {
        return std::tuple(found.pair.a, found.pair.b, found.image.y(), found.image.x());
    });
    for (const ShiftedPair& found : shiftedPairs_) {
        pairs_.push_back(found.pair);
        pairShifts_.push_back(wrap_.imageOffset(found.image));
    }
    shiftedPairs_.clear();
}

}  // namespace plumb
