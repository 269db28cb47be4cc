// SPDX-License-Identifier: MIT
// Does the module for JavaScript have all that the kit's headers have? What it leaves out is listed here, with the
// reason; its page says the same in short.
#include <map>
#include <regex>
#include <set>
#include <string>

#include "catch.h"
#include "house/arrows.h"
#include "house/declarations.h"
#include "house/repository.h"

using namespace plumb::test;

namespace {

/// Modules that JavaScript does not have, but for the functions named here.
const std::map<std::string, std::string> kitModulesLeftOut{
    {"broad", "a world asks it"},
    {"collide", "a world asks it"},
    {"forces", "laws are given to a world's fields"},
    {"integrate", "takes functions, and calls them many times a step"},
    {"math", "values"},
};

const std::map<std::string, std::string> notInModule{
    // Values that are plain numbers in JavaScript, or said in another way there.
    {"MotionPath.closed", "its first and last point tell"},
    {"MotionPath.end", "whoever makes it knows"},
    {"PathMover.def", "whoever makes it knows"},
    {"Wrap.any", "a definition in JavaScript"},
    {"Wrap.isExceededBy", "a definition in JavaScript"},
    {"Wrap.place", "the world gives positions within it"},
    {"Wrap.shiftNear", "shortest says the same"},
    {"Wrap.imageIndex", "the world gives positions within it"},
    {"Wrap.imageOffset", "the world gives positions within it"},
    {"EnergyLedger.stored", "a sum of four members"},
    {"EnergyLedger.gained", "a sum of nine members"},
    {"MomentumLedger.gained", "a sum of six members"},
    {"TileMap.columns", "a member in JavaScript"},
    {"TileMap.rows", "a member in JavaScript"},
    {"TileMap.size", "a member in JavaScript"},
    {"TileMap.def", "a definition in JavaScript"},
    {"TileMap.wrapped", "a definition in JavaScript"},
    {"TileMap.contains", "a definition in JavaScript"},
    {"TileMap.at", "tiles[] in JavaScript"},
    {"TileMap.set", "setTile, or tiles[] before the map is a shape"},
    {"TileMap.wrapping", "wrapX and wrapY are members in JavaScript"},
    {"TileMap.cellAt", "a division"},
    {"TileMap.lowerLeft", "a product"},
    {"TileMap.centerOf", "a product"},
    {"TileMap.cornersOf", "for whoever draws slopes: aabbOf and forms"},
    {"Lock.solver", "a bool in JavaScript"},
    {"TileMap.new", "tileMapOf makes one, and so does a definition"},
    {"Wrap.shortest", "shortest, a function"},
    {"Cornering.of", "a member in JavaScript"},
    // For the kit itself, or for C++ alone.
    {"describe", "the schema is made of it"},
    {"validate", "done by whoever takes the definition"},
    {"combine", "massOf a body's shapes is world.body(id).mass()"},
    {"hasPieces", "for the kit itself"},
    {"piecesOf", "for the kit itself"},
    {"tileBlocksAt", "for the kit itself"},
    {"tileBlocksOf", "for the kit itself"},
    {"tilePiecesOf", "for the kit itself"},
    {"outerCornersOf", "for the kit itself"},
    {"boxPolygon", "box() makes the same"},
    {"isEmpty", "a comparison"},
    {"isSolid", "a comparison"},
    {"cornersOf", "for whoever draws slopes"},
    {"contains", "of bounding volumes: a comparison"},
    {"inflate", "of bounding volumes: a sum"},
    {"merge", "of bounding volumes: a comparison"},
    {"uncheckedDragStep", "for the kit itself"},
    {"dragStep", "moveWithDrag says what is asked for"},
    {"oscillatorStep", "oscillate says what is asked for"},
    {"terminalSpeed", "a square root"},
    {"impact", "the general law is for whoever builds a solver"},
    {"impactImpulses", "the general law is for whoever builds a solver"},
    {"collideRow", "collideInLine, one after the other"},
    {"mayEnter", "isOpen asks the map"},
    {"isSlow", "a search in a list"},
    {"isUpClosed", "a search in a list"},
    {"placeOfPixel", "a division"},
    {"timeOf", "PathMover.period"},
    {"progressAt", "PathMover.at"},
    {"interpolate", "numbers: a line; poses: interpolatePose"},
    {"unitOf", "a word"},
};

/// "World.step" and "circle", of list("World", "step", ...).
std::set<std::string> functionsOfModule() {
    std::set<std::string> names;
    const std::regex call(R"re(list\("(\w*)", "(\w+)")re");
    for (const char* file : {"world", "shape", "mover", "formula"}) {
        const std::string text = textOf(repository / "kit/web/module" / (std::string(file) + "_calls.h"));
        REQUIRE(text.size() > 1000);
        for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it)
            names.insert((*it)[1].length() > 0 ? (*it)[1].str() + "." + (*it)[2].str() : (*it)[2].str());
    }
    return names;
}

/// A function of a view is listed for the view that can change the object, a constructor as new.
std::string nameInModule(std::string name) {
    const std::size_t dot = name.find('.');
    if (dot != std::string::npos && name.substr(0, dot) == name.substr(dot + 1)) name.replace(dot + 1, dot, "new");
    const std::size_t view = name.find("View.");
    return view == std::string::npos ? name : name.erase(view, 4);
}

}  // namespace

TEST_CASE("the module for JavaScript has every function of the kit's headers, or says why not", "[house][web]") {
    const std::set<std::string> has = functionsOfModule();
    // What runtime.js adds, beside the calls of the module.
    const std::set<std::string> written{
        "Body.id",           "BodyShape.id",         "Joint.id",           "Field.id",
        "MotionPath.lineTo", "MotionPath.arcAround", "MotionPath.curveTo", "MotionPath.close",
        "MotionPath.new",    "MotionPath.length",    "MotionPath.at",      "splineThrough"};
    std::set<std::string> missing, used;
    for (const SourceFile& source : sourcesUnder(repository / "kit/plumb", repository / "kit")) {
        if (!isInstalled(source.path) || kitModulesLeftOut.contains(moduleOf(source.path))) continue;
        Declarations here;
        addDeclarations(here, source.text);
        for (const auto& [declared, parameters] : here.functions) {
            const std::string name = nameInModule(declared);
            if (has.contains(name) || written.contains(name)) continue;
            if (notInModule.contains(name))
                used.insert(name);
            else
                missing.insert(source.path + ": " + name);
        }
    }
    CHECK(missing == std::set<std::string>{});
    std::set<std::string> stale;
    for (const auto& [name, reason] : notInModule)
        if (!used.contains(name)) stale.insert(name);
    CHECK(stale == std::set<std::string>{});
}

TEST_CASE("what the module's page says is left out are modules that are", "[house][web]") {
    const std::string page = textOf(repository / "kit/web/README.md");
    for (const auto& [module, reason] : kitModulesLeftOut)
        if (module != "math") CHECK(page.find("`" + module + "`") != std::string::npos);
}
