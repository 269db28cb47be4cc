// SPDX-License-Identifier: MIT
// Is there anything that goes into the kit, and that no table spoils?
#include <algorithm>
#include <set>

#include "catch.h"
#include "house/arrows.h"
#include "house/declarations.h"
#include "kit/dynamics/bad_input.h"

namespace plumb::test {

namespace {

using NameSet = std::set<std::string>;

/// Modules that work on plain values: what they refuse, their own tests show.
const std::set<std::string> byThemselves{"ballistics", "forces", "impact",   "integrate",
                                         "kinematics", "movers", "steering", "stepping"};

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
const NameSet results{
    "BodyMoved",    "CastHit",        "CastPoint",        "Contact",         "ContactBegin",  "ContactEnd",
    "ContactHit",   "ContactPoint",   "ContactCandidate", "Distance",        "ImpactResult",  "JointBroke",
    "EnergyLedger", "MomentumLedger", "Ledger",           "JointCoordinate", "JointReaction", "Nearest",
    "Quarantined",  "SensorBegin",    "SensorEnd",        "SinCos",          "SpaceWork",     "StepProfile",
    "WorldCounts",  "Pair",           "Manifold",         "ManifoldPoint",   "Forecast",      "ForecastHit"};
/// Spoilt as arguments of the calls that take them.
const NameSet arguments{"Aabb",       "BodyId",  "Capacity", "FieldId", "ImpactLaw",
                        "ImpactSide", "JointId", "Rot",      "ShapeId", "Transform"};
/// Of the layers beneath World, for whoever builds on them: asked a million times a step, they take what they are
/// given.
const NameSet unchecked{"BlockTree.View", "JointOfNoKind", "Bounds", "BoxBlock", "BoxProbe",
                        "Convex",         "FilterKey",     "Proxy",  "RayPart",  "RelativePose"};

const NameSet worldClasses{"World", "Body",      "BodyView", "BodyShape", "BodyShapeView",
                           "Joint", "JointView", "Field",    "FieldView"};
const NameSet lowerClasses{"BasicVec2", "BlockTree",  "BoundsRounding", "Bvh",    "Vec2fArray", "FunctionRef",
                           "Lock",      "MortonSort", "RadixSort",      "Random", "Space"};

/// Of the layers beneath, as said above; what they do with numbers that are none is in their headers.
const NameSet uncheckedFunctions{
    "aabbOf",          "countFrom",    "forEachImage",      "partOf",    "overlapMask",    "padded",      "arcTangent",
    "bruteForcePairs", "castRay",      "castShape",         "clipRay",   "contains",       "convexOf",    "cross",
    "distance",        "exponential",  "exponentialMinus1", "logarithm", "logarithm1Plus", "filterKeyOf", "inflate",
    "manifold",        "filtersAllow", "mayPair",           "merge",     "mortonOrder",    "overlap",     "perp",
    "piecesOf",        "pointProbe",   "probeLimit",        "rayProbe",  "sinCos",         "stateHash"};
/// Refused as their own tests show, or, of the layers beneath, taken as they are.
const NameSet sweepAndBounds{
    "BoundingCircle",     "CollisionTime",  "GridSettings", "MovingCircle", "OrientedBox",     "Overlap",
    "PairSearch",         "SweptShape",     "Touch",        "Sweep",        "bisectCollision", "boundingCircleOf",
    "cornersOf",          "findPairs",      "firstTouch",   "gridPairs",    "orientedBoxOf",   "poseAt",
    "sweepAndPrunePairs", "timeOfApproach", "sweepBetween"};
/// Refused as tile_map_test.cpp, tiles_test.cpp and wrap_test.cpp show.
const NameSet tilesAndWrap{"Wrap",         "Cell",         "Tile",      "TileMap",        "TileMapDef",     "TilePiece",
                           "hasPieces",    "isEmpty",      "isSolid",   "outerCornersOf", "standardLegend", "textOf",
                           "tileBlocksAt", "tileBlocksOf", "tileMapOf", "tilePiecesOf",   "tiles"};
/// Refused as field_worlds_test.cpp shows.
const NameSet fieldDefs{"FieldDef", "Magnet", "Pool"};
/// They make a def, which is checked when it is given to a world.
const NameSet makers{"capsule", "chain", "circle", "loop", "polygon", "roundedPolygon", "segment"};
/// They are what checks, and what is said of members: describe_test.cpp looks at that.
const NameSet checks{
    "Allowed",       "AlternativeTags", "DefinitionName", "JointMembers",       "Member",         "MemberCheck",
    "MemberPath",    "describe",        "refuse",         "refuseZero",         "requireAllowed", "requireEnumerator",
    "requireFinite", "requireMember",   "requireMembers", "requireNotNegative", "requireOneOf",   "requirePositive",
    "requireUpTo",   "requireWithin",   "toText",         "validate",           "withinReach"};

/// Arguments of which none is wrong, or that a table of their own spoils.
const std::set<std::pair<std::string, std::string>> otherwise{{"Body.setCanSleep", "canSleep"},
                                                              {"Body.setEnabled", "enabled"},
                                                              {"Body.setFixedRotation", "fixed"},
                                                              {"Body.setLocks", "lockX"},
                                                              {"Body.setLocks", "lockY"},
                                                              {"Body.setTag", "tag"},
                                                              {"Joint.set", "def"},
                                                              {"World.World", "def"},
                                                              {"World.add", "def"},
                                                              {"World.add", "shape"},
                                                              {"World.join", "def"},
                                                              {"BodyShape.set", "def"},
                                                              {"BodyShape.setTag", "tag"},
                                                              {"BodyShape.setFilter", "filter"},
                                                              {"BodyShape.setMaterial", "material"},
                                                              {"World.setTile", "cell"},
                                                              {"World.setTile", "tile"},
                                                              {"World.contains", "body"},
                                                              {"World.contains", "shape"},
                                                              {"World.contains", "joint"},
                                                              {"box", "material"},
                                                              {"box", "double"},  // is told by the compiler
                                                              {"outline", "material"},
                                                              {"roundedBox", "material"},
                                                              {"roundedBox", "radius"},
                                                              {"massOf", "def"},
                                                              {"World.castRay", "filter"},
                                                              {"World.castRayAll", "filter"},
                                                              {"World.castShape", "filter"},
                                                              {"World.castShapeAll", "filter"},
                                                              {"World.castShapePieces", "filter"},
                                                              {"World.overlapBox", "filter"},
                                                              {"World.overlapShape", "filter"},
                                                              {"World.overlapPoint", "filter"},
                                                              {"World.nearest", "filter"},
                                                              {"World.addField", "def"},
                                                              {"World.contains", "field"},
                                                              {"World.remove", "field"},
                                                              {"World.field", "field"},
                                                              {"Field.set", "def"},
                                                              {"World.explode", "explosion"},
                                                              {"World.explode", "filter"},
                                                              {"World.World", "other"},
                                                              {"World.World", "EmptyBraces"},
                                                              {"forecast", "world"},
                                                              {"forecast", "body"},
                                                              {"forecast", "shot"},
                                                              {"forecast", "ticks"},
                                                              {"forecast", "dt"}};

bool has(const std::vector<std::string>& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool isLeftOut(const std::string& function) {
    const std::size_t dot = function.find('.');
    if (dot != std::string::npos) return !worldClasses.contains(function.substr(0, dot));
    if (sweepAndBounds.contains(function) || tilesAndWrap.contains(function)) return true;
    return uncheckedFunctions.contains(function) || makers.contains(function) || checks.contains(function);
}

std::vector<std::string> missingIn(const Declarations& all, const Covered& tables, const Covered& calls) {
    std::vector<std::string> missing;
    for (const auto& [name, fields] : all.structs) {
        if (sweepAndBounds.contains(name) || fieldDefs.contains(name) || tilesAndWrap.contains(name)) continue;
        if (results.contains(name) || arguments.contains(name) || unchecked.contains(name)) continue;
        if (checks.contains(name)) continue;
        if (!tables.contains(name)) missing.push_back("struct " + name);
        for (const std::string& field : fields)
            if (tables.contains(name) && !has(tables.at(name), field)) missing.push_back(name + "." + field);
    }
    for (const auto& [name, none] : all.classes)
        if (!worldClasses.contains(name) && !lowerClasses.contains(name) && !tilesAndWrap.contains(name))
            missing.push_back("class " + name);
    for (const auto& [name, parameters] : all.functions) {
        if (isLeftOut(name)) continue;
        for (const std::string& parameter : parameters)
            if (!otherwise.contains({name, parameter}) && !(calls.contains(name) && has(calls.at(name), parameter)))
                missing.push_back(name + "(" + parameter + ")");
    }
    return missing;
}

std::vector<std::string> strangersIn(const Declarations& all, const Covered& tables) {
    std::vector<std::string> strangers;
    for (const auto& [name, fields] : tables)
        for (const std::string& field : fields)
            if (!all.structs.contains(name) || !has(all.structs.at(name), field))
                strangers.push_back(name + "." + field);
    return strangers;
}

}  // namespace

TEST_CASE("every field and argument that goes into the kit is in a table of how it can be wrong",
          "[dynamics][errors][house]") {
    const Declarations all = publicDeclarations();
    REQUIRE(all.structs.size() > 50);
    Covered tables = coveredDefs();
    tables.merge(coveredJoints());
    CHECK(missingIn(all, tables, coveredCalls()) == std::vector<std::string>{});
    CHECK(strangersIn(all, tables) == std::vector<std::string>{});
}

TEST_CASE("a new field, struct, class, function or argument is missed in the tables", "[dynamics][errors][house]") {
    const Covered tables{{"BallDef", {"radius"}}}, calls{{"World.drop", {"ball"}}};
    const auto missing = [&](const std::string& header) {
        Declarations all;
        addDeclarations(all, header);
        return missingIn(all, tables, calls);
    };
    using Missing = std::vector<std::string>;
    CHECK(missing("namespace plumb {\nstruct BallDef { double radius = 1; ///< [m]\n};\n}") == Missing{});
    CHECK(missing("struct BallDef { double radius = 1, weight{2}; };") == Missing{"BallDef.weight"});
    CHECK(missing("struct BallDef {\n  std::optional<Vec2>\n      spin = std::nullopt;\n};") ==
          Missing{"BallDef.spin"});
    CHECK(missing("struct BatDef { double length = 1; };") == Missing{"struct BatDef"});
    CHECK(missing("class Umpire {\npublic:\n    void call(double strike);\n};") == Missing{"class Umpire"});
    CHECK(missing("class World {\npublic:\n    void drop(const BallDef& ball);\nprivate:\n    void lose(int x);\n};") ==
          Missing{});
    CHECK(missing("class World {\npublic:\n    void drop(const BallDef& ball, double from = 1);\n};") ==
          Missing{"World.drop(from)"});
    CHECK(missing("double swing(double angle);") == Missing{"swing(angle)"});
}

}  // namespace plumb::test
