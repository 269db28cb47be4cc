// SPDX-License-Identifier: MIT
#include "house/arrows.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>

#include "catch.h"
#include "house/repository.h"

using namespace plumb::test;
namespace fs = std::filesystem;
using Faults = std::vector<std::string>;

namespace {

std::vector<SourceFile> kitSources() {
    return sourcesUnder(repository / "kit/plumb", repository / "kit");
}

std::set<std::string> modulesOf(const std::vector<SourceFile>& kit) {
    std::set<std::string> modules;
    for (const SourceFile& source : kit) modules.insert(moduleOf(source.path));
    modules.erase("");
    return modules;
}

const Ranks ranks{{"math", 0}, {"shapes", 1}, {"impact", 1}, {"dynamics", 4}};

Faults faultsOf(const std::string& path, const std::string& text) {
    return upwardArrows(ranks, {{path, text}});
}

}  // namespace

TEST_CASE("no include of the kit points up or aside in the README's table of ranks", "[house]") {
    const std::vector<SourceFile> kit = kitSources();
    REQUIRE(kit.size() > 1);
    const std::string readme = textOf(repository / "README.md");
    CHECK(upwardArrows(ranksIn(readme, modulesOf(kit)), kit) == Faults{});
}

TEST_CASE("games and compare never meet, and the kit knows neither", "[house]") {
    const std::vector<SourceFile> kit = kitSources();
    CHECK(arrowsInto("compare", kit) == Faults{});
    CHECK(arrowsInto("games", kit) == Faults{});
    CHECK(arrowsInto("games", sourcesUnder(repository / "compare", repository)) == Faults{});
    CHECK(arrowsInto("compare", sourcesUnder(repository / "games", repository)) == Faults{});
}

TEST_CASE("a game includes the kit, the frame and its own folder, and only the shells know a platform", "[house]") {
    const std::vector<SourceFile> games = sourcesUnder(repository / "games", repository);
    REQUIRE(games.size() > 1);
    CHECK(arrowsOutOfGames(games) == Faults{});
    CHECK(ownHeadersNotFirst(games) == Faults{});
}

TEST_CASE("a planted include of a platform, a shell or another game is caught", "[house]") {
    CHECK(arrowsOutOfGames({{"games/maze/a.cpp", "#include <SDL.h>\n#include <games/runner/level.h>\n"}}).size() == 2);
    CHECK(arrowsOutOfGames({{"games/frame/a.cpp", "#include <games/shell/program.h>\n"}}).size() == 1);
    CHECK(arrowsOutOfGames({{"games/maze/a.cpp", "#include <cairo.h>\n"}}).size() == 1);
    CHECK(arrowsOutOfGames({{"games/maze/a.cpp",
                             "#include <vector>\n#include <games/frame/game.h>\n#include <games/maze/a.h>\n"
                             "#include <plumb/plumb.h>\n"},
                            {"games/shell/a.cpp", "#include <SDL.h>\n#include <games/frame/game.h>\n"}}) == Faults{});
}

TEST_CASE("every header that is installed does without those that are not", "[house]") {
    CHECK(arrowsOutOfInstalled(kitSources()) == Faults{});
}

TEST_CASE("every source of the kit includes its own header first", "[house]") {
    CHECK(ownHeadersNotFirst(kitSources()) == Faults{});
}

TEST_CASE("a planted include that points up, aside, or out of the table is caught", "[house]") {
    CHECK(faultsOf("plumb/math/vec2.h", "#include <plumb/shapes/shape.h>\n") ==
          Faults{"plumb/math/vec2.h includes plumb/shapes/shape.h: `math` has rank 0, `shapes` has rank 1"});
    CHECK(faultsOf("plumb/shapes/mass.cpp", "#include <vector>\n  #  include \"plumb/impact/impact.h\"  // why\n") ==
          Faults{"plumb/shapes/mass.cpp includes plumb/impact/impact.h: `shapes` has rank 1, `impact` has rank 1"});
    CHECK(faultsOf("plumb/dynamics/world.h", "#include <plumb/space/space.h>") ==
          Faults{"plumb/dynamics/world.h includes plumb/space/space.h: `dynamics` has rank 4, `space` has no rank"});
    CHECK(faultsOf("plumb/space/space.h", "") == Faults{"`space` has no rank"});
    CHECK(faultsOf("plumb/math/rot.h", "#include \"../shapes/shape.h\"") ==
          Faults{"plumb/math/rot.h includes ../shapes/shape.h: a path that hides the module"});
    CHECK(faultsOf("plumb/dynamics/world.cpp", "#include <plumb/plumb.h>") ==
          Faults{"plumb/dynamics/world.cpp includes plumb/plumb.h: that is every rank at once"});
}

TEST_CASE("an include of a lower rank, of its own module, or in the umbrella header is no fault", "[house]") {
    CHECK(faultsOf("plumb/dynamics/bodies/softness.h", "#include <cmath>\n#include <plumb/math/vec2.h>\n") == Faults{});
    CHECK(faultsOf("plumb/dynamics/world.h", "#include <plumb/dynamics/body.h>\n") == Faults{});
    CHECK(faultsOf("plumb/math/rot.h", "// #include <plumb/shapes/shape.h>\n") == Faults{});
    CHECK(faultsOf("plumb/plumb.h", "#include <plumb/dynamics/world.h>\n") == Faults{});
}

TEST_CASE("planted includes between folders that never meet, and of what is not installed, are caught", "[house]") {
    CHECK(arrowsInto("compare", {{"games/a.cpp", "#include <compare>\n#include <compare/scene/scene.h>\n"}}).size() ==
          1);
    CHECK(arrowsInto("games", {{"compare/a.cpp", "#include \"../games/frame/game.h\"\n"}}).size() == 1);
    CHECK(arrowsOutOfInstalled({{"plumb/dynamics/a.h", "#include <plumb/dynamics/bodies/b.h>\n"}}).size() == 1);
    CHECK(arrowsOutOfInstalled({{"plumb/math/a.h", "#include <plumb/math/detail/b.h>\n"}}).size() == 1);
    CHECK(arrowsOutOfInstalled({{"plumb/dynamics/a.cpp", "#include <plumb/dynamics/bodies/b.h>\n"},
                                {"plumb/dynamics/a.h", "#include <plumb/math/vec2.h>\n#include <vector>\n"},
                                {"plumb/dynamics/solver/c.h", "#include <plumb/dynamics/bodies/b.h>\n"}}) == Faults{});
    const SourceFile header{"plumb/math/a.h", ""};
    CHECK(ownHeadersNotFirst({header, {"plumb/math/a.cpp", "#include <cmath>\n#include <plumb/math/a.h>\n"}}).size() ==
          1);
    CHECK(ownHeadersNotFirst({header, {"plumb/math/a.cpp", "#include <plumb/math/a.h>\n"}}) == Faults{});
}

TEST_CASE("ranks are read from the table headed rank and modules, and from nowhere else", "[house]") {
    const std::string readme =
        "`math` is a module.\n"
        "| 7 | `math` |\n\n"
        "| rank | modules |\n|---|---|\n"
        "| 0 | `math` Vec2, `double` \xC2\xB7 more |\n"
        "| 1 | `shapes` circle \xC2\xB7 `impact` closed forms, see `math` |\n"
        "\n| 9 | `dynamics` |\n";
    CHECK(ranksIn(readme, {"math", "shapes", "impact", "dynamics"}) ==
          Ranks{{"impact", 1}, {"math", 0}, {"shapes", 1}});
}

// Two types of one name in one namespace, of which a program sees one here and the other there, are no error to any
// compiler, and wrong.
TEST_CASE("no two headers of the kit define a type of the same name", "[house]") {
    const std::regex definition(R"((?:^|\n)(?:struct|class|enum class)\s+(?:alignas\(\d+\)\s*)?(\w+)[^;{<(]*\{)");
    std::map<std::string, std::set<std::string>> headers;
    for (const SourceFile& source : kitSources()) {
        if (!source.path.ends_with(".h")) continue;
        for (std::sregex_iterator it(source.text.begin(), source.text.end(), definition), end; it != end; ++it)
            headers[(*it)[1]].insert(source.path);
    }
    CHECK(headers.size() > 100);
    for (const auto& [name, where] : headers) {
        CAPTURE(name, where);
        CHECK(where.size() == 1);
    }
}
