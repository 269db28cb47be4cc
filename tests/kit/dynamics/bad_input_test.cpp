// SPDX-License-Identifier: MIT
// Is there anything that goes into the kit, and that no description or table spoils?
#include <algorithm>
#include <iterator>
#include <set>
#include <sstream>

#include "catch.h"
#include "house/arrows.h"
#include "house/declarations.h"
#include "kit/dynamics/bad_input.h"
#include "kit/dynamics/described_leaves.h"

namespace plumb::test {

namespace {

using NameSet = std::set<std::string>;

NameSet setOf(const std::string& words) {
    std::istringstream text(words);
    return {std::istream_iterator<std::string>(text), {}};
}

/// Modules that work on plain values: what they refuse, their own tests show.
const NameSet byThemselves = setOf("ballistics forces impact integrate kinematics movers steering stepping");

Declarations publicDeclarations() {
    std::vector<SourceFile> sources = sourcesUnder(repository / "kit/plumb", repository / "kit");
    std::sort(sources.begin(), sources.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
    Declarations all;
    for (const SourceFile& source : sources)
        if (isInstalled(source.path) && !byThemselves.contains(moduleOf(source.path)))
            addDeclarations(all, source.text);
    return all;
}

/// What the kit only gives back.
const NameSet results = setOf(
    "BodyMoved CastHit CastPoint Contact ContactBegin ContactEnd ContactHit ContactPoint ContactCandidate Distance "
    "ImpactResult JointBroke EnergyLedger MomentumLedger Ledger JointCoordinate JointReaction Nearest Quarantined "
    "SensorBegin SensorEnd SinCos SpaceWork StepProfile WorldCounts Pair Manifold ManifoldPoint Forecast ForecastHit");
/// Spoilt as arguments of the calls that take them.
const NameSet arguments = setOf("Aabb BodyId Capacity FieldId ImpactLaw ImpactSide JointId Rot ShapeId Transform");
/// Of the layers beneath World, for whoever builds on them: asked a million times a step, they take what they are
/// given. What they do with numbers that are none is in their headers.
const NameSet unchecked = setOf(
    "BlockTree.View JointOfNoKind Bounds BoxBlock BoxProbe Convex FilterKey Proxy RayPart RelativePose aabbOf "
    "countFrom forEachImage partOf overlapMask padded arcTangent bruteForcePairs castRay castShape clipRay contains "
    "convexOf cross distance exponential exponentialMinus1 logarithm logarithm1Plus filterKeyOf inflate manifold "
    "filtersAllow mayPair merge mortonOrder overlap perp piecesOf pointProbe probeLimit rayProbe sinCos stateHash");

const NameSet worldClasses = setOf("World Body BodyView BodyShape BodyShapeView Joint JointView Field FieldView");
const NameSet lowerClasses =
    setOf("BasicVec2 BlockTree BoundsRounding Bvh Vec2fArray FunctionRef Lock MortonSort RadixSort Random Space");

/// Refused as their own tests show, or, of the layers beneath, taken as they are: of sweeps and bounds; and of tiles,
/// as tile_map_test.cpp, tiles_test.cpp and wrap_test.cpp show.
const NameSet shownElsewhere = setOf(
    "BoundingCircle CollisionTime GridSettings MovingCircle OrientedBox Overlap PairSearch SweptShape Touch Sweep "
    "bisectCollision boundingCircleOf cornersOf findPairs firstTouch gridPairs orientedBoxOf poseAt "
    "sweepAndPrunePairs timeOfApproach sweepBetween Wrap Cell Tile TileMap TileMapDef TilePiece hasPieces isEmpty "
    "isSolid outerCornersOf standardLegend textOf tileBlocksAt tileBlocksOf tileMapOf tilePiecesOf tiles");
/// They make a def, which is checked when it is given to a world; they are what checks; or what is said of members, at
/// which describe_test.cpp looks.
const NameSet makersAndChecks = setOf(
    "capsule chain circle loop polygon roundedPolygon segment Allowed AlternativeTags DefinitionName JointMembers "
    "Member MemberCheck MemberPath describe refuse refuseZero requireAllowed requireEnumerator requireFinite "
    "requireMember requireMembers requireNotNegative requireOneOf requirePositive requireUpTo requireWithin toText "
    "validate withinReach");

/// Arguments of which none is wrong, or that are spoilt elsewhere; the double of a box is told by the compiler.
const NameSet otherwise = setOf(
    "Body.setCanSleep(canSleep) Body.setEnabled(enabled) Body.setFixedRotation(fixed) Body.setLocks(lockX) "
    "Body.setLocks(lockY) Body.setTag(tag) Joint.set(def) World.World(def) World.add(def) World.add(shape) "
    "World.join(def) BodyShape.set(def) BodyShape.setTag(tag) BodyShape.setFilter(filter) "
    "BodyShape.setMaterial(material) World.setTile(cell) World.setTile(tile) World.contains(body) "
    "World.contains(shape) World.contains(joint) box(material) box(double) outline(material) roundedBox(material) "
    "roundedBox(radius) massOf(def) World.castRay(filter) World.castRayAll(filter) World.castShape(filter) "
    "World.castShapeAll(filter) World.castShapePieces(filter) World.overlapBox(filter) World.overlapShape(filter) "
    "World.overlapPoint(filter) World.nearest(filter) World.addField(def) World.contains(field) World.remove(field) "
    "World.field(field) Field.set(def) World.explode(explosion) World.explode(filter) World.World(other) "
    "isVector(v) isChainSegment(shape) World.World(EmptyBraces) forecast(world) forecast(body) forecast(shot) "
    "forecast(ticks) forecast(dt)");

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool isLeftOut(const std::string& name) {
    const std::size_t dot = name.find('.');
    if (dot != std::string::npos && !unchecked.contains(name)) return !worldClasses.contains(name.substr(0, dot));
    return shownElsewhere.contains(name) || unchecked.contains(name) || makersAndChecks.contains(name);
}

/// A struct is spoilt by its description, which describe_test.cpp finds to have all members; arguments by a table.
std::vector<std::string> missingIn(const Declarations& all, const Descriptions& described, const Covered& calls) {
    std::vector<std::string> missing;
    for (const auto& [name, fields] : all.structs)
        if (!described.contains(name) && !isLeftOut(name) && !results.contains(name) && !arguments.contains(name))
            missing.push_back("struct " + name);
    for (const auto& [name, none] : all.classes)
        if (!worldClasses.contains(name) && !lowerClasses.contains(name) && !isLeftOut(name))
            missing.push_back("class " + name);
    for (const auto& [name, parameters] : all.functions) {
        if (isLeftOut(name)) continue;
        for (const std::string& parameter : parameters)
            if (!otherwise.contains(name + "(" + parameter + ")") &&
                !(calls.contains(name) && has(calls.at(name), parameter)))
                missing.push_back(name + "(" + parameter + ")");
    }
    return missing;
}

}  // namespace

TEST_CASE("every struct that goes into the kit is described, and every argument is in a table of how it can be wrong",
          "[dynamics][errors][house]") {
    const Declarations all = publicDeclarations();
    REQUIRE(all.structs.size() > 50);
    CHECK(missingIn(all, allDescriptions(), coveredCalls()) == std::vector<std::string>{});
}

TEST_CASE("a new struct, class, function or argument is missed in the tables", "[dynamics][errors][house]") {
    const Descriptions described{{"BallDef", {Member{"radius"}}}};
    const auto missing = [&](const std::string& header) {
        Declarations all;
        addDeclarations(all, header);
        return missingIn(all, described, {{"World.drop", {"ball"}}});
    };
    using Missing = std::vector<std::string>;
    CHECK(missing("namespace plumb {\nstruct BallDef { double radius = 1; ///< [m]\n};\n}") == Missing{});
    CHECK(missing("struct BatDef { double length = 1; };") == Missing{"struct BatDef"});
    CHECK(missing("class Umpire {\npublic:\n    void call(double strike);\n};") == Missing{"class Umpire"});
    CHECK(missing("class World {\npublic:\n    void drop(const BallDef& ball);\nprivate:\n    void lose(int x);\n};") ==
          Missing{});
    CHECK(missing("class World {\npublic:\n    void drop(const BallDef& ball, double from = 1);\n};") ==
          Missing{"World.drop(from)"});
    CHECK(missing("double swing(double angle);") == Missing{"swing(angle)"});
}

}  // namespace plumb::test
