// SPDX-License-Identifier: MIT
#include <plumb/collide/overlap.h>

#include <plumb/collide/distance.h>
#include <plumb/shapes/aabb.h>
#include <plumb/shapes/chain.h>

namespace plumb {

namespace {

/// For shapes whose boxes overlap: the deeper of this overlap and the one found before.
std::optional<Overlap> deeperOf(const std::optional<Overlap>& before, const Shape& a, const Transform& poseA,
                                const Shape& b, const Transform& poseB) {
    const Distance d = distance(a, poseA, b, poseB);
    if (!(d.separation <= 0) || (before && before->depth >= -d.separation)) return before;
    return Overlap{-d.separation, d.normal, d.pointA, d.pointB};
}

}  // namespace

std::optional<Overlap> overlap(const Shape& a, const Transform& poseA, const Shape& b, const Transform& poseB) {
    validate(a, "overlap.a");
    validate(b, "overlap.b");
    const Aabb boxA = aabbOf(a, poseA), boxB = aabbOf(b, poseB);
    if (!overlap(boxA, boxB)) return std::nullopt;
    std::optional<Overlap> deepest;
    if (!hasPieces(a) && !hasPieces(b)) return deeperOf(deepest, a, poseA, b, poseB);
    const std::vector<Shape> piecesB = piecesOf(b);
    for (const Shape& pieceA : piecesOf(a)) {
        const Aabb pieceBox = aabbOf(pieceA, poseA);
        if (!overlap(pieceBox, boxB)) continue;
        for (const Shape& pieceB : piecesB)
            if (overlap(pieceBox, aabbOf(pieceB, poseB))) deepest = deeperOf(deepest, pieceA, poseA, pieceB, poseB);
    }
    return deepest;
}

}  // namespace plumb
