// SPDX-License-Identifier: MIT
#include <compare/page/blocks.h>

#include "catch.h"

namespace plumb::compare {

TEST_CASE("only what stands in a block is replaced, and again the same way", "[compare][page]") {
    const std::string page = "a\n<!-- bench: speed -->\nold\n<!-- end -->\nb\n<!-- check: tiles -->\nc\n<!-- end -->\n";
    const std::string once = withBlocks(page, {{"bench", "speed", "", "new\n"}, {"bench", "tiles", "", "not this\n"}});
    const std::vector<Block> blocks = blocksOf(once);
    REQUIRE(blocks.size() == 2);
    CHECK(once == "a\n<!-- bench: speed, checksum " + blocks[0].checksum +
                      " -->\nnew\n<!-- end -->\nb\n<!-- check: tiles -->\nc\n<!-- end -->\n");
    CHECK(blocks[0].isIntact());
    CHECK_FALSE(blocks[1].isIntact());  // it was never written
    CHECK(withBlocks(once, {{"bench", "speed", "", "new\n"}}) == once);
}

TEST_CASE("a digit that is changed by hand, in any place of a block, shows in its checksum", "[compare][page]") {
    const std::string page = withBlocks("<!-- bench: speed -->\n<!-- end -->", {{"bench", "speed", "", "1.23 4.56\n"}});
    CHECK(blocksOf(page).front().isIntact());
    for (std::size_t i = 0; i < page.size(); ++i) {
        if (page[i] < '0' || page[i] > '9') continue;
        std::string changed = page;
        changed[i] = changed[i] == '9' ? '0' : static_cast<char>(changed[i] + 1);
        INFO(changed);
        CHECK_FALSE(blocksOf(changed).front().isIntact());
    }
}

TEST_CASE("a block that does not end, or comes twice, is refused, and so is a page without one", "[compare][page]") {
    CHECK_THROWS_AS(blocksOf("<!-- bench: speed -->\n"), std::invalid_argument);
    CHECK_THROWS_WITH(blocksOf("<!-- bench: a -->\n<!-- bench: b -->\n<!-- end -->"),
                      "the block a has no line <!-- end -->");
    CHECK_THROWS_WITH(blocksOf("<!-- bench: a -->\n<!-- end --><!-- bench: a -->\n<!-- end -->"),
                      "the block a comes twice");
    CHECK_THROWS_WITH(readPage("/no/such/file.md", "bench"), "/no/such/file.md: cannot be read");
}

}  // namespace plumb::compare
