// SPDX-License-Identifier: MIT
// What a line of segments may do to a body: nothing that a smooth outline would not.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <plumb/collide/manifold.h>
#include <plumb/math/random.h>
#include <plumb/shapes/chain.h>

#include "cases.h"
#include "catch.h"
#include "kit/collide/manifold_check.h"

namespace {

using namespace plumb;
using namespace plumb::test;

constexpr double pi = std::numbers::pi;

struct Line {
    std::vector<Vec2> points;
    std::vector<Convex> pieces;
    std::vector<minkowski::Outline> outlines;
};

Line lineOfChain(const Chain& chain) {
    Line line{chain.points, {}, {}};
    for (const Shape& piece : piecesOf(chain)) {
        line.pieces.push_back(convexOf(piece, {0, 0}));
        line.outlines.push_back(outlineOf(line.pieces.back(), {}));
    }
    return line;
}

/// From (0, 0) on, each segment turned from the one before.
Line lineThrough(const std::vector<double>& lengths, const std::vector<double>& turns, double angle) {
    Chain chain;
    chain.points.emplace_back(0, 0);
    for (std::size_t i = 0; i < lengths.size(); ++i) {
        angle += i > 0 ? turns[i - 1] : 0;
        chain.points.push_back(chain.points.back() + lengths[i] * Vec2(std::cos(angle), std::sin(angle)));
    }
    return lineOfChain(chain);
}

/// A chain of 3 segments, whose turns at the joints are as large as that.
Line randomLine(Random& random, double scale, double turn) {
    std::vector<double> lengths, turns;
    for (int i = 0; i < 3; ++i) lengths.push_back(scale * random.uniform(0.2, 3));
    for (int i = 0; i < 2; ++i) {
        const int kind = random.integer(0, 3);
        turns.push_back(kind == 0 ? 0 : kind == 1 ? random.uniform(-0.05, 0.05) : random.uniform(-turn, turn));
    }
    return lineThrough(lengths, turns, random.uniform(-pi, pi));
}

double angleOf(const Vec2& v) {
    return std::atan2(v.y(), v.x());
}
double wrapped(double angle) {
    return std::remainder(angle, 2 * pi);
}

/// How far outside of the ways that the line's outline allows a segment's contact pushes [rad].
double offOf(const Line& line, std::size_t piece, const Vec2f& normal) {
    const auto alongAngle = [&](std::size_t i) { return angleOf(line.points[i + 1] - line.points[i]); };
    const double along = alongAngle(piece), way = std::atan2(normal.y(), normal.x());
    double off = std::min(std::fabs(wrapped(way - along - pi / 2)), std::fabs(wrapped(way - along + pi / 2)));
    const auto joint = [&](bool goesOn, std::size_t next, double outward) {
        if (!goesOn) {  // half a turn around the end
            off = std::min(off, std::max(0.0, std::fabs(wrapped(way - outward)) - pi / 2));
            return;
        }
        const double turn = wrapped(alongAngle(next) - along);
        // The convex side is the one that the line, walked from its start on, turns away from.
        const double side = along + ((turn < 0) == (next > piece) ? pi / 2 : -pi / 2);
        const double between = wrapped(way - side - turn / 2);
        off = std::min(off, std::max(0.0, std::fabs(between) - std::fabs(turn) / 2));
    };
    joint(piece + 1 < line.pieces.size(), piece + 1, along);
    joint(piece > 0, piece - 1, along + pi);
    return off;
}

struct PosedShape {
    Convex convex;
    RelativePose pose;
    minkowski::Outline outline;
};

PosedShape placed(const Convex& convex, const Vec2& position, double angle) {
    PosedShape body{
        convex, {position.cast<float>(), static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle))}, {}};
    body.outline = outlineOf(body.convex, body.pose);
    return body;
}

/// The line's nearest, or deepest.
minkowski::Gap gapTo(const Line& line, const PosedShape& body) {
    minkowski::Gap nearest{1e300, {}};
    for (const minkowski::Outline& piece : line.outlines) {
        const minkowski::Gap gap = gapBetween(piece, body.outline);
        if (gap.separation < nearest.separation) nearest = gap;
    }
    return nearest;
}

/// Moves a body until its gap to the line is as wanted, if it can be.
PosedShape atGap(const Line& line, PosedShape body, double wanted) {
    for (int i = 0; i < 30; ++i) {
        const minkowski::Gap gap = gapTo(line, body);
        const double step = wanted - gap.separation;
        if (std::fabs(step) < 1e-9) break;
        body.pose.position += Vec2f(static_cast<float>(gap.normal.x * step), static_cast<float>(gap.normal.y * step));
        body.outline = outlineOf(body.convex, body.pose);
    }
    return body;
}

double largest(const Line& line, const PosedShape& body) {
    double size = largestNumber(body.convex) + static_cast<double>(body.pose.position.norm());
    for (const Vec2& p : line.points) size = std::max(size, p.norm());
    return size;
}

std::string describeChain(const Line& line, const PosedShape& body, double margin) {
    std::ostringstream text;
    text.precision(9);
    text << "margin " << margin << " line";
    for (const Vec2& p : line.points) text << " (" << p.transpose() << ")";
    text << "; body radius " << body.outline.radius << " corners";
    for (const auto p : body.outline.corners) text << " (" << p.x << ", " << p.y << ")";
    for (std::size_t i = 0; i < line.pieces.size(); ++i) {
        const Manifold m = manifold(line.pieces[i], body.convex, body.pose, static_cast<float>(margin));
        text << "\n  piece " << i << " true gap " << gapBetween(line.outlines[i], body.outline).separation << " along ("
             << gapBetween(line.outlines[i], body.outline).normal.x << ", "
             << gapBetween(line.outlines[i], body.outline).normal.y << "); count " << m.count << " normal "
             << m.normal.transpose() << " off " << offOf(line, i, m.normal);
        for (std::size_t j = 0; j < static_cast<std::size_t>(m.count); ++j)
            text << " point " << m.points[j].position.transpose() << " separation " << m.points[j].separation;
    }
    return text.str();
}

Vec2 middleOf(const minkowski::Outline& outline) {
    Vec2 sum(0, 0);
    for (const auto p : outline.corners) sum += Vec2(p.x, p.y);
    return sum / static_cast<double>(outline.corners.size());
}

/// Is a body behind a segment, but in front of a neighbour, where their joint is convex, and nearer to that one? It
/// cannot come to the segment but through the neighbour, or around one of its ends.
bool isBehindNeighbour(const Line& line, const PosedShape& body, std::size_t piece) {
    const Vec2 middle = middleOf(body.outline);
    const auto sideOf = [&](std::size_t i) {
        return cross(Vec2(line.points[i + 1] - line.points[i]), Vec2(middle - line.points[i]));
    };
    const auto gap = [&](std::size_t i) { return gapBetween(line.outlines[i], body.outline).separation; };
    for (const std::size_t next : {piece - 1, piece + 1}) {
        if (next >= line.pieces.size()) continue;
        const std::size_t first = std::min(piece, next);
        const double turn = cross(Vec2(line.points[first + 1] - line.points[first]),
                                  Vec2(line.points[first + 2] - line.points[first + 1]));
        // Where the line turns to the left, its right side is convex.
        const double inFront = turn > 0 ? -1 : 1;
        if (inFront * sideOf(next) > 0 && inFront * sideOf(piece) < 0 && gap(next) < gap(piece)) return true;
    }
    return false;
}

/// What all segments together say.
struct Seen {
    double nearest = 1e300;  ///< least separation of all points
    double off = 0;          ///< farthest outside of what is allowed [rad]
    int points = 0;
    int missing =
        0;  ///< segments within the margin, not as near as a neighbour could be, nor behind one, that say nothing
};

Seen look(const Line& line, const PosedShape& body, double margin, double tolerance) {
    Seen seen;
    for (std::size_t i = 0; i < line.pieces.size(); ++i) {
        const Manifold m = manifold(line.pieces[i], body.convex, body.pose, static_cast<float>(margin));
        const double gap = gapBetween(line.outlines[i], body.outline).separation;
        const bool within = gap > 0.005 + tolerance && gap < margin - tolerance;
        seen.missing += m.count == 0 && within && !isBehindNeighbour(line, body, i);
        if (m.count == 0) continue;
        seen.nearest = std::min(seen.nearest, static_cast<double>(leastSeparation(m)));
        seen.off = std::max(seen.off, offOf(line, i, m.normal));
        seen.points += m.count;
    }
    return seen;
}

/// Directions within this of a segment's normal count as its own [rad]; and float's part.
constexpr double ownAngle = 0.02 + 1e-5;

const char* faultApart(const Seen& seen, double gap, double margin, double tolerance) {
    if (gap > margin + tolerance) return seen.points > 0 ? "a contact beyond the margin" : nullptr;
    if (gap > margin - tolerance) return nullptr;
    if (seen.points == 0 || seen.nearest > gap + tolerance) return "nothing at the nearest point";
    if (seen.missing > 0) return "a segment that a fast body may reach says nothing";
    return seen.nearest < -tolerance ? "apart, and yet pushed" : nullptr;
}

/// A way that is allowed may be longer than the nearest way out, but not by far.
const char* faultSunk(const Seen& seen, double gap, double tolerance) {
    if (seen.points == 0 || seen.nearest > tolerance) return "a sunken body that nothing pushes";
    return seen.nearest < 3 * gap - 2 * tolerance ? "pushed by more than it has sunk" : nullptr;
}

struct ChainTally {
    int apart = 0, sunk = 0, faults = 0;
    std::string first;
};

ChainTally tallyOfChains(Kind kind) {
    Random random(7000 + static_cast<std::uint64_t>(kind));
    ChainTally tally;
    for (int i = 0; i < allCases(10'000); ++i) {
        const double scale = std::pow(10, random.uniform(-1, 0.5));
        const Line line = randomLine(random, scale, 2.4);
        const Convex convex = randomConvex(random, kind, scale * random.uniform(0.2, 2));
        const Vec2 near = line.points[static_cast<std::size_t>(random.integer(0, 3))];
        const Vec2 start = near + randomVec2(random, scale);
        const bool isApart = random.integer(0, 1) == 0;
        const double wanted = scale * (isApart ? placements::powerOfTen(random, -6, 0.3)  //
                                               : -placements::powerOfTen(random, -5, -2));
        const PosedShape body = atGap(line, placed(convex, start, random.uniform(-pi, pi)), wanted);
        const double gap = gapTo(line, body).separation;
        // As for any manifold, and as much for what turned it; and an edge of the chain's may lend its normal.
        double tolerance = 4e-6 * largest(line, body);
        if (kind != Kind::Circle)
            tolerance += manifoldCheck::favourOfShorter * manifoldCheck::longestEdge(body.outline);
        const double margin = random.integer(0, 1) == 0 ? 0.02 : 10;
        const Seen seen = look(line, body, margin, tolerance);
        const char* fault = nullptr;
        if (seen.points > 0 && seen.off > ownAngle) fault = "pushed a way that the outline does not allow";
        if (!fault && gap > tolerance) {
            ++tally.apart;
            fault = faultApart(seen, gap, margin, tolerance);
        } else if (!fault && gap < 0 && std::fabs(gap - wanted) < tolerance && kind != Kind::Segment) {
            ++tally.sunk;  // a line has no inside: once it has crossed the joint it is no longer shallow
            fault = faultSunk(seen, gap, tolerance);
        }
        if (fault && tally.faults++ == 0) tally.first = fault + ("; " + describeChain(line, body, margin));
    }
    return tally;
}

/// A body whose flat side lies along the line, at a height; the ends of that side.
struct Flush {
    PosedShape body;
    double half = 0;
};

/// Kinds 0 to 3: disc, box, capsule, rounded box.
Flush flushOn(int kind, double half, double radius, const Vec2& at, double angle, double sunk) {
    const Vec2 along(std::cos(angle), std::sin(angle)), up = perp(along);
    Shape shape = Circle{radius};
    double high = radius;
    if (kind == 1) shape = boxPolygon({half, radius});
    if (kind == 2) shape = Capsule{{-half, 0}, {half, 0}, radius};
    if (kind == 3) {
        Polygon rounded = boxPolygon({half, radius});
        rounded.radius = radius / 2;
        high += rounded.radius;
        shape = rounded;
    }
    const Vec2 center = at + up * (high - sunk);
    return {placed(convexOf(shape, {0, 0}), center, angle), kind == 0 ? 0 : half};
}

double randomLength(Random& random) {
    return random.uniform(0.05, 1.5);
}

/// Just at a joint, just short of it, just past it, or anywhere.
double randomAside(Random& random) {
    const int way = random.integer(-1, 1);
    return random.integer(0, 3) == 0 ? random.uniform(-0.5, 0.5) : way * placements::powerOfTen(random, -8, -2);
}

/// Not sunk, or by 1e-7 to 5e-3 m.
double randomSunk(Random& random) {
    return random.integer(0, 3) == 0 ? 0 : placements::powerOfTen(random, -7, -2.3);
}

}  // namespace

TEST_CASE("10,000 placements of each shape on bent chains are held, and pushed only the ways the outline allows",
          "[collide][chain]") {
    for (const Kind kind : kinds) {
        const ChainTally tally = tallyOfChains(kind);
        INFO(nameOf(kind) << ": " << tally.apart << " apart, " << tally.sunk << " sunk; first fault: " << tally.first);
        CHECK(tally.faults == 0);
        CHECK(tally.apart > allCases(3000));
        CHECK((tally.sunk > allCases(3000) || kind == Kind::Segment));
    }
}

TEST_CASE("box, disc, capsule and rounded box flush on a straight chain, or sunk to 5 mm, feel one long straight floor",
          "[collide][chain]") {
    Random random(31);
    double worstTurn = 0, worstDepth = 0, worstEnd = 0;
    for (int i = 0; i < 20'000; ++i) {
        std::vector<double> lengths;
        for (int k = 0; k < 6; ++k) lengths.push_back(randomLength(random));
        const double angle = random.integer(0, 1) == 0 ? 0 : random.uniform(-pi, pi);
        const Line line = lineThrough(lengths, {0, 0, 0, 0, 0}, angle);
        const double radius = random.uniform(0.1, 0.5);
        const int kind = random.integer(0, 3);
        const double half = kind == 0 ? 0 : random.uniform(0.05, 1);
        // One end of the flat side at the third joint, or near it, and all of it on the chain.
        const Vec2 along(std::cos(angle), std::sin(angle));
        const Vec2 at = line.points[3] + along * (half * random.integer(-1, 1) + randomAside(random));
        const double from = (at - line.points[0]).dot(along) - half, to = from + 2 * half;
        if (from < 0.01 || to > (line.points[6] - line.points[0]).dot(along) - 0.01) continue;
        const double sunk = randomSunk(random);
        const Flush flush = flushOn(kind, half, radius, at, angle, sunk);

        double first = 1e300, last = -1e300;
        for (std::size_t k = 0; k < line.pieces.size(); ++k) {
            const Manifold m = manifold(line.pieces[k], flush.body.convex, flush.body.pose, 0.02f);
            for (std::size_t p = 0; p < static_cast<std::size_t>(m.count); ++p) {
                if (m.points[p].separation > 0.005f) continue;  // the disc's next segment, which it may reach
                const Vec2 normal = m.normal.cast<double>();
                worstTurn = std::max(worstTurn, (normal - perp(along)).norm());
                worstDepth = std::max(worstDepth, std::fabs(static_cast<double>(m.points[p].separation) + sunk));
                const double place = m.points[p].position.cast<double>().dot(along);
                first = std::min(first, place);
                last = std::max(last, place);
            }
        }
        worstEnd = std::max({worstEnd, std::fabs(first - from), std::fabs(last - to)});
    }
    // Coordinates up to 10 m are floats to 5e-7 m, and so is a direction from one to the next, 0.1 m on.
    CHECK(worstTurn < 1e-6);
    CHECK(worstDepth < 3e-6);
    CHECK(worstEnd < 2e-4);  // two points nearer than 1e-4 of an edge are one
}

TEST_CASE("a body that slides off a segment is never held back at a flat or convex joint", "[collide][chain]") {
    Random random(37);
    double mostBack = 0;
    int atJoint = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double turn = -placements::powerOfTen(random, -5, 0.3);  // to the right: the left side is convex
        const Line line = lineThrough({2, randomLength(random), 1}, {turn, 0}, random.uniform(-pi, pi));
        const Vec2 along = (line.points[1] - line.points[0]).normalized();
        const double half = random.uniform(0.05, 0.9);
        const double short_ = half + randomAside(random);  // of the joint, the leading end by so much less
        const Flush flush = flushOn(random.integer(0, 3), half, random.uniform(0.1, 0.5),
                                    line.points[1] - along * short_, angleOf(along), randomSunk(random));
        for (std::size_t k = 0; k < line.pieces.size(); ++k) {
            const Manifold m = manifold(line.pieces[k], flush.body.convex, flush.body.pose, 0.02f);
            if (m.count == 0 || leastSeparation(m) > 0.005f) continue;  // what it may reach is not yet touched
            atJoint += k == 1;
            mostBack = std::max(mostBack, -m.normal.cast<double>().dot(along));
        }
    }
    CHECK(mostBack < 2e-6);  // float's direction of the body and of the segment
    CHECK(atJoint > 1000);
}

TEST_CASE("a body that slides towards a brink of 45 to 160 degrees is not held back by the drop's inside",
          "[collide][chain]") {
    Random random(47);
    double mostBack = 0;
    int near = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double turn = -random.uniform(pi / 4, 8 * pi / 9);
        const Line line = lineThrough({5, randomLength(random)}, {turn}, random.uniform(-pi, pi));
        const Vec2 along = (line.points[1] - line.points[0]).normalized();
        const double half = random.uniform(0.05, 0.9), short_ = placements::powerOfTen(random, -6, 0);
        // A box is there with its leading edge, what is round with its middle.
        const int kind = random.integer(0, 3);
        const double lead = kind == 0 ? 0 : half;
        // What is round may be pressed in up to its middle: the floor is nearer than the drop, unless that leans back.
        const double radius = random.uniform(0.1, 0.5);
        const bool pressed = kind % 2 == 0 && turn > -pi / 2;
        const double sunk = pressed ? random.uniform(0, 0.9 * radius) : randomSunk(random);
        const Flush flush = flushOn(kind, half, radius, line.points[1] - along * (lead + short_), angleOf(along), sunk);
        const Manifold m = manifold(line.pieces[1], flush.body.convex, flush.body.pose, 0.02f);
        near += gapBetween(line.outlines[1], flush.body.outline).separation < 0.02;
        if (m.count > 0) mostBack = std::max(mostBack, -m.normal.cast<double>().dot(along));
    }
    CHECK(mostBack < 2e-6);  // float's direction of the body and of the segment
    CHECK(near > 5000);
}

TEST_CASE("a body that slides towards a rise is not pushed back before it is there", "[collide][chain]") {
    Random random(41);
    int early = 0, looked = 0;
    for (int i = 0; i < 20'000; ++i) {
        const double turn = placements::powerOfTen(random, -2.5, 0.3);
        const Line line = lineThrough({2, randomLength(random)}, {turn}, random.uniform(-pi, pi));
        const Vec2 along = (line.points[1] - line.points[0]).normalized();
        const double half = random.uniform(0.05, 0.9), radius = random.uniform(0.1, 0.5), sunk = randomSunk(random);
        const int kind = random.integer(0, 3);
        const Flush flush = flushOn(kind, half, radius, line.points[1] - along * (half + random.uniform(1e-5, 0.1)),
                                    angleOf(along), sunk);
        const double gap = gapBetween(line.outlines[1], flush.body.outline).separation;
        if (gap < 1e-5) continue;  // of a round end, or under an overhang
        ++looked;
        const Manifold m = manifold(line.pieces[1], flush.body.convex, flush.body.pose, 0.05f);
        early += m.count > 0 && leastSeparation(m) < -1e-6f;
    }
    CHECK(early == 0);
    CHECK(looked > 10'000);
}

TEST_CASE("the body asks the chain what the chain asks the body", "[collide][chain]") {
    Random random(43);
    int contacts = 0, differ = 0;
    for (int i = 0; i < 5'000; ++i) {
        const Line line = randomLine(random, 1, 2);
        const Convex convex = randomConvex(random, randomKind(random), random.uniform(0.2, 1));
        PosedShape body = placed(convex, line.points[1] + randomVec2(random, 1), random.uniform(-pi, pi));
        body = atGap(line, body, random.uniform(-0.02, 0.05));
        const RelativePose& pose = body.pose;
        const Vec2f back(-pose.cos * pose.position.x() - pose.sin * pose.position.y(),
                         pose.sin * pose.position.x() - pose.cos * pose.position.y());
        for (const Convex& piece : line.pieces) {
            const Manifold m = manifold(piece, body.convex, pose, 0.02f);
            const Manifold n = manifold(body.convex, piece, {back, pose.cos, -pose.sin}, 0.02f);
            if (m.count != n.count && std::fabs(leastSeparation(m.count > 0 ? m : n) - 0.02f) < 1e-5f) continue;
            contacts += m.count > 0;
            const Vec2f normal(pose.cos * n.normal.x() - pose.sin * n.normal.y(),
                               pose.sin * n.normal.x() + pose.cos * n.normal.y());
            const bool same = m.count == 0 || std::fabs(leastSeparation(m) - leastSeparation(n)) < 2e-5f;
            differ += m.count != n.count || !same || (m.count > 0 && (normal + m.normal).norm() > 2e-3f);
        }
    }
    CHECK(contacts > 2000);
    CHECK(differ <= contacts / 200);  // where two ways are equally good to rounding, or a point is at the margin
}
