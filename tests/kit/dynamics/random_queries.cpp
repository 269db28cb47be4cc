// SPDX-License-Identifier: MIT
// What can a world be asked between steps and edits? Each answer is that of a look at all there is, with the
// functions that the kit has for single shapes; and nothing changes by it.
#include <algorithm>
#include <optional>

#include <plumb/collide/distance.h>
#include <plumb/collide/ray_cast.h>
#include <plumb/collide/shape_cast.h>
#include <plumb/math/check.h>

#include "kit/dynamics/random_editor.h"

namespace plumb::test {

namespace {

struct Placed {
    ShapeId id;
    Shape shape;
    Transform pose;
};

/// All that is there for a filter, in the order in which queries tell of it.
std::vector<Placed> seenThrough(const World& world, const Filter& filter) {
    std::vector<Placed> seen;
    for (const BodyId& id : world.bodies()) {
        const BodyView body = world.body(id);
        if (!body.enabled()) continue;
        for (const ShapeId& shape : body.shapes()) {
            const ShapeDef def = world.shape(shape).def();
            if (!def.sensor && RandomEditor::passes(def.filter, filter))
                seen.push_back({shape, def.shape, body.pose()});
        }
    }
    return seen;
}

/// A question: draws of its own, so that a world that is not asked has the same future.
class Question {
public:
    explicit Question(RandomEditor& editor) : e(editor), before_(stateHash(editor.world)) { swap(); }
    ~Question() { swap(); }
    Question(const Question&) = delete;
    Question& operator=(const Question&) = delete;

    const World& world() const { return e.world; }
    Vec2 anywhere() { return e.vector(e.chance(50) ? 1e6 : 14) + Vec2(0, 4); }
    Vec2 way() {
        if (e.chance(12)) return {0, 0};
        if (e.chance(8)) return {e.number(-20, 20), 0};
        return e.vector(e.chance(20) ? 1e5 : 20);
    }
    Shape shape() { return e.anyShape().shape; }
    Transform pose() {
        const Vec2 position = anywhere();
        return {position, Rot::fromAngle(e.chance(3) ? 0 : e.number(-3, 3))};
    }
    void answered(bool found) {
        ++e.tally.asked;
        e.tally.found += found ? 1 : 0;
        if (stateHash(e.world) != before_) FAIL("a question changed the world");
    }

    RandomEditor& e;

private:
    void swap() { std::swap(e.random, e.asker); }
    std::uint64_t before_;
};

template <class Meet>
std::vector<CastHit> castHitsOf(const std::vector<Placed>& seen, Meet&& meet) {
    std::vector<CastHit> hits;
    for (const Placed& placed : seen)
        if (const std::optional<CastPoint> met = meet(placed))
            hits.push_back({placed.id, met->point, met->normal, met->fraction});
    std::stable_sort(hits.begin(), hits.end(),
                     [](const CastHit& a, const CastHit& b) { return a.fraction < b.fraction; });
    return hits;
}

bool isSame(const CastHit& a, const CastHit& b) {
    return a.shape == b.shape && a.fraction == b.fraction;
}

void hear(RandomEditor& e, const CastHit& hit) {
    e.hear(hit.shape);
    for (const double number : {hit.fraction, hit.point.x(), hit.point.y(), hit.normal.x(), hit.normal.y()})
        e.hear(number);
}

/// The first, and all, of what something meets on its way.
void compareCasts(Question& ask, const std::optional<CastHit>& first, const std::vector<CastHit>& all,
                  const std::vector<CastHit>& truth) {
    const auto textOf = [](const std::vector<CastHit>& hits) {
        std::string text;
        for (const CastHit& hit : hits)
            text += " shape " + std::to_string(hit.shape.number) + " of body " + std::to_string(hit.shape.body.index) +
                    " at " + toText(hit.fraction) + ",";
        return text;
    };
    INFO("met:" << textOf(all) << " in truth:" << textOf(truth));
    if (all.size() != truth.size() || !std::equal(all.begin(), all.end(), truth.begin(), isSame))
        FAIL("what is met is not what a look at all shapes says");
    if (first.has_value() != !all.empty()) FAIL("all and the first do not agree");
    if (first && !isSame(*first, all.front())) FAIL("the first is another than the first of all");
    for (const CastHit& hit : all) {
        if (!hit.point.allFinite() || std::fabs(hit.normal.norm() - 1) > 1e-9) FAIL("a hit of no place");
        if (!(hit.fraction >= 0 && hit.fraction <= 1)) FAIL("a hit beyond the way");
        hear(ask.e, hit);
    }
    ask.answered(first.has_value());
}

void askRay(RandomEditor& e) {
    if (!e.manner.asks) return;
    Question ask(e);
    const Filter filter = e.anyFilter();
    const Vec2 from = ask.anywhere(), to = from + ask.way();
    const std::vector<CastHit> truth = castHitsOf(seenThrough(e.world, filter), [&](const Placed& placed) {
        return castRay(from, to, placed.shape, placed.pose);
    });
    compareCasts(ask, ask.world().castRay(from, to, filter), ask.world().castRayAll(from, to, filter), truth);
}

void askShape(RandomEditor& e) {
    if (!e.manner.asks) return;
    Question ask(e);
    const Filter filter = e.anyFilter();
    const Shape shape = ask.shape();
    const Transform pose = ask.pose();
    const Vec2 shift = ask.way();
    const std::vector<CastHit> truth = castHitsOf(seenThrough(e.world, filter), [&](const Placed& placed) {
        return castShape(shape, pose, shift, placed.shape, placed.pose);
    });
    compareCasts(ask, ask.world().castShape(shape, pose, shift, filter),
                 ask.world().castShapeAll(shape, pose, shift, filter), truth);
}

void compareOverlaps(Question& ask, const std::vector<ShapeId>& found, const Filter& filter, const Shape& shape,
                     const Transform& pose) {
    std::vector<ShapeId> truth;
    for (const Placed& placed : seenThrough(ask.world(), filter))
        if (distance(placed.shape, placed.pose, shape, pose).separation <= 0) truth.push_back(placed.id);
    if (found != truth) FAIL("what overlaps is not what a look at all shapes says");
    for (const ShapeId& id : found) ask.e.hear(id);
    ask.answered(!found.empty());
}

void askOverlap(RandomEditor& e) {
    if (!e.manner.asks) return;
    Question ask(e);
    const Filter filter = e.anyFilter();
    const Transform pose = ask.pose();
    if (e.chance(3)) {
        const Shape shape = ask.shape();
        return compareOverlaps(ask, ask.world().overlapShape(shape, pose, filter), filter, shape, pose);
    }
    const Vec2 lower = pose.position, upper = lower + e.vector(5).cwiseAbs();
    if (e.chance(2)) {
        const std::vector<ShapeId> found = ask.world().overlapPoint(lower, filter);
        return compareOverlaps(ask, found, filter, Circle{.radius = 0}, {lower, {}});
    }
    const Polygon box{{lower, {upper.x(), lower.y()}, upper, {lower.x(), upper.y()}}};
    compareOverlaps(ask, ask.world().overlapBox({lower, upper}, filter), filter, box, {});
}

void askNearest(RandomEditor& e) {
    if (!e.manner.asks) return;
    Question ask(e);
    const Filter filter = e.anyFilter();
    const Vec2 point = ask.anywhere();
    const double within = e.chance(4) ? infinity : e.chance(6) ? 0 : e.number(0, 5);
    const std::optional<Nearest> nearest = ask.world().nearest(point, within, filter);
    std::optional<Nearest> truth;
    for (const Placed& placed : seenThrough(e.world, filter)) {
        const double gap = distance(placed.shape, placed.pose, Circle{.radius = 0}, {point, {}}).separation;
        if (gap <= within && (!truth || gap < truth->separation)) truth = Nearest{placed.id, gap, {}, {}};
    }
    const auto textOf = [](const std::optional<Nearest>& n) {
        return n ? "shape " + std::to_string(n->shape.number) + " of body " + std::to_string(n->shape.body.index) +
                       " at " + std::to_string(n->separation)
                 : std::string("none");
    };
    INFO("within " << within << " of " << point.transpose() << ": " << textOf(nearest) << ", in truth "
                   << textOf(truth));
    if (nearest.has_value() != truth.has_value()) FAIL("nearest is there for one and not for the other");
    if (nearest && (nearest->shape != truth->shape || nearest->separation != truth->separation))
        FAIL("the nearest is not what a look at all shapes says");
    if (nearest) e.hear(nearest->shape), e.hear(nearest->separation), e.hear(nearest->point.x());
    ask.answered(nearest.has_value());
}

void askDistance(RandomEditor& e) {
    if (!e.manner.asks) return;
    Question ask(e);
    if (e.bodies.empty()) return;
    const ShapeId a = e.someShape(), b = e.someShape();
    if (!e.world.contains(a) || !e.world.contains(b)) return;
    const Distance there = ask.world().distance(a, b), back = ask.world().distance(b, a);
    const Transform poseA = ask.world().body(a.body).pose(), poseB = ask.world().body(b.body).pose();
    const Distance truth = distance(ask.world().shape(a).def().shape, poseA, ask.world().shape(b).def().shape, poseB);
    if (there.separation != truth.separation) FAIL("a distance is not that of the two shapes");
    const double size = poseA.position.norm() + poseB.position.norm() + 10;
    if (!(std::fabs(there.separation - back.separation) <= 1e-14 * size)) FAIL("there is farther than back");
    e.hear(there.separation);
    ask.answered(true);
}

}  // namespace

std::vector<RandomEditor::Action> queryActions() {
    return {{12, askRay}, {12, askShape}, {12, askOverlap}, {12, askNearest}, {6, askDistance}};
}

}  // namespace plumb::test
