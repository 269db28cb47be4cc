// SPDX-License-Identifier: MIT
#include <compare/page/page_table.h>

#include "catch.h"

namespace plumb::compare {
namespace {

const PageTable measured{{"scene", "Plumb", "Box2D 2.4", "Box2D 3"},
                         {{"fall", "1.23 mm", "40 mm", "3 mm"}, {"tiles", "0, 0", "2, 36", "6, 90"}}};
const std::vector<Exactness> exactness{Exactness::ToTheDigit, Exactness::ToTheDigit, Exactness::WithinTwo,
                                       Exactness::Unseen};

std::vector<std::string> found(const std::string& cell, std::size_t row, std::size_t column) {
    PageTable page = measured;
    page.rows[row][column] = cell;
    return differences(page, measured, exactness);
}

}  // namespace

TEST_CASE("a table reads back from a page as it was written", "[compare][page]") {
    const PageTable back = tableOf("before\n\n" + markdown(measured) + "\nafter | this\n");
    CHECK(back.head == measured.head);
    CHECK(back.rows == measured.rows);
    CHECK(differences(back, measured, exactness).empty());
}

TEST_CASE("a changed number is told of by row and column, as exactly as the column has to be", "[compare][page]") {
    CHECK(found("1.24 mm", 0, 1) ==
          std::vector<std::string>{"fall, Plumb: the page says \"1.24 mm\", measured was \"1.23 mm\""});
    CHECK(found("0, 1", 1, 1).size() == 1);
    CHECK(found("drop", 0, 0).size() == 1);
    CHECK(found("21 mm", 0, 2).empty());
    CHECK(found("79 mm", 0, 2).empty());
    CHECK(found("81 mm", 0, 2).size() == 1);
    CHECK(found("40 µm", 0, 2).size() == 1);
    CHECK(found("40000 µm", 0, 2).empty());
    CHECK(found("1, 36", 1, 2).empty());
    CHECK(found("0, 36", 1, 2).size() == 1);
    CHECK(found("2, 36, 1", 1, 2).size() == 1);
    CHECK(found("unsupported", 0, 2).size() == 1);
    CHECK(found("anything", 0, 3).empty());
}

TEST_CASE("a row or a column too few is told of as a whole", "[compare][page]") {
    PageTable page = measured;
    page.rows.pop_back();
    CHECK(differences(page, measured, exactness).size() == 1);
    page = measured;
    page.rows[0].pop_back();
    CHECK(differences(page, measured, exactness) == std::vector<std::string>{"fall has 3 cells, wanted 4"});
}

}  // namespace plumb::compare
