// SPDX-License-Identifier: MIT
#include <compare/check/verdict.h>

#include "catch.h"

namespace plumb::compare {
namespace {

using Catch::Matchers::WithinAbs;

std::optional<double> orderOf(const std::vector<double>& errors) {
    return observedOrder(errors, 1e-12);
}

}  // namespace

TEST_CASE("errors of 16, 4 and 1 mm show order 2, of 16, 8 and 1 mm the smaller, 1", "[compare][check]") {
    CHECK_THAT(*orderOf({16e-3, 4e-3, 1e-3}), WithinAbs(2, 1e-12));
    CHECK_THAT(*orderOf({16e-3, 8e-3, 1e-3}), WithinAbs(1, 1e-12));
    CHECK_THAT(*orderOf({1e-3, 2e-3, 1e-3}), WithinAbs(-1, 1e-12));
}

TEST_CASE("an error in the rounding counts as 1e-12, and no ratio starts from it", "[compare][check]") {
    CHECK_THAT(*orderOf({8e-12, 2e-12, 0}), WithinAbs(1, 1e-9));
    CHECK_THAT(*orderOf({8e-12, 1e-15, 1e-15}), WithinAbs(3, 1e-9));
    CHECK_FALSE(orderOf({1e-13, 5e-13, 2e-13}));
    CHECK_FALSE(orderOf({0, 0, 0}));
}

}  // namespace plumb::compare
