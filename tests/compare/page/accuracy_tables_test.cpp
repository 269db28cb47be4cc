// SPDX-License-Identifier: MIT
#include <compare/page/accuracy_tables.h>

#include <algorithm>
#include <filesystem>

#include <compare/scene/builtin.h>

#include "catch.h"

namespace plumb::compare {
namespace {

const std::filesystem::path repository = PLUMB_SOURCE_DIR;

/// Of the scenes whose tables stand on the page, those that take no time.
std::vector<SceneResult> tileResults() {
    std::vector<SceneResult> results;
    for (const char* name : {"tile_floor", "tile_wall"}) results.push_back(runScene(*findScene(name), {}, engines()));
    return results;
}

}  // namespace

TEST_CASE("no block of a page was changed by hand", "[compare][page]") {
    for (const auto& [file, command] : {std::pair("README.md", "check"), std::pair("compare/measured.md", "check"),
                                        std::pair("compare/measured.md", "bench")}) {
        const std::vector<std::string> faults = pageFaults(readPage(repository / file, command), {});
        INFO(file << ": " << (faults.empty() ? "" : faults.front()));
        CHECK(faults.empty());
    }
}

TEST_CASE("the page says how often something catches on tiles, and each digit that is changed is found",
          "[compare][page]") {
    const std::vector<AccuracyTable> tables = accuracyTables(tileResults());
    REQUIRE(tables.size() == 1);
    CHECK(tables[0].name == "tiles");
    const std::string page = readPage(repository / "compare/measured.md", "check");
    CHECK(pageFaults(page, tables).empty());
    std::vector<Block> blocks = blocksOf(page);
    Block& tiles = *std::ranges::find(blocks, "tiles", &Block::name);
    const std::size_t cell = tiles.body.find("| 0, 0, 0, 0 |");
    REQUIRE(cell != std::string::npos);
    for (const std::size_t digit : {cell + 2, cell + 5, cell + 8, cell + 11}) {
        std::string changed = tiles.body;
        changed[digit] = '1';
        // as if the command had written it: the checksum is right, and the number is not
        const std::string forged = withBlocks(page, {{"check", "tiles", "", changed}});
        const std::vector<std::string> faults = pageFaults(forged, tables);
        REQUIRE(faults.size() == 1);
        CHECK(faults[0].starts_with("the table tiles: tile_floor, Plumb: the page says \""));
        // and as somebody's hand writes it
        std::string byHand = page;
        byHand.replace(byHand.find(tiles.body), tiles.body.size(), changed);
        CHECK(pageFaults(byHand, tables).size() == 2);
    }
}

TEST_CASE("a table whose scenes were not all run is not there", "[compare][page]") {
    CHECK(accuracyTables({}).empty());
    const std::vector<SceneResult> one{runScene(*findScene("catenary"), {}, engines())};
    CHECK(accuracyTables(one).empty());
}

}  // namespace plumb::compare
