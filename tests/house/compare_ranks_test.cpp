// SPDX-License-Identifier: MIT
// Does the comparison keep to the ranks of its own README?
#include "catch.h"
#include "house/arrows.h"
#include "house/rooms.h"

using namespace plumb::test;
using Faults = std::vector<std::string>;

namespace {

std::vector<SourceFile> comparisonSources() {
    return sourcesUnder(repository / "compare", repository);
}

Faults faultsOfComparison(const std::string& path, const std::string& text) {
    return upwardArrows({{"scene", 0}, {"field", 1}, {"mover", 1}, {"engine", 2}, {"main.cpp", 3}}, {{path, text}},
                        "compare");
}

}  // namespace

TEST_CASE("no include of the comparison points up or aside in its README's table of ranks", "[house]") {
    const std::vector<SourceFile> sources = comparisonSources();
    REQUIRE(sources.size() > 1);
    const Ranks ranks = ranksOf(textOf(repository / "compare/README.md"), "folders");
    CHECK(upwardArrows(ranks, sources, "compare") == Faults{});
    for (const auto& [folder, rank] : ranks) {
        CAPTURE(folder);
        CHECK(std::filesystem::exists(repository / "compare" / folder));
        CHECK((folder == "main.cpp" || rank < ranks.at("main.cpp")));
    }
}

TEST_CASE("no file of the comparison has more than 400 lines", "[house]") {
    CHECK(tooLarge({.files = 100, .functionLines = 100}, comparisonSources()) == Faults{});
}

TEST_CASE("a planted include of the comparison that points up, aside, or out of the table is caught", "[house]") {
    CHECK(faultsOfComparison("compare/scene/a.cpp", "#include <compare/mover/b.h>\n") ==
          Faults{"compare/scene/a.cpp includes compare/mover/b.h: `scene` has rank 0, `mover` has rank 1"});
    CHECK(faultsOfComparison("compare/field/a.h", "#include <compare/mover/b.h>\n") ==
          Faults{"compare/field/a.h includes compare/mover/b.h: `field` has rank 1, `mover` has rank 1"});
    CHECK(faultsOfComparison("compare/scene/deep/a.h", "#include <compare/engine/deep/b.h>\n").size() == 1);
    CHECK(faultsOfComparison("compare/engine/a.h", "#include <compare/kitchen/b.h>\n").size() == 1);
    CHECK(faultsOfComparison("compare/engine/a.h", "#include <compare/main.cpp>\n").size() == 1);
    CHECK(faultsOfComparison("compare/engine/a.h", "#include \"../scene/b.h\"\n").size() == 1);
    CHECK(faultsOfComparison("compare/kitchen/a.h", "") == Faults{"`kitchen` has no rank"});
    CHECK(faultsOfComparison("compare/other.cpp", "") == Faults{"`other.cpp` has no rank"});
    CHECK(faultsOfComparison("compare/engine/a.h",
                             "#include <plumb/plumb.h>\n#include <compare/scene/b.h>\n"
                             "#include <compare/engine/deep/c.h>\n#include <vector>\n") == Faults{});
    CHECK(faultsOfComparison("compare/main.cpp", "#include <compare/engine/b.h>\n") == Faults{});
}
