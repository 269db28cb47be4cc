// SPDX-License-Identifier: MIT
// Which Catch2 is this? Version 3 where there is one, else version 2 (Debian 12): tests include this header only.
#pragma once
#include <string>

#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
// In every source alike: it changes the interfaces that they share.
#define CATCH_CONFIG_ENABLE_BENCHMARKING
#define CATCH_CONFIG_FAST_COMPILE
#include <catch2/catch.hpp>
#endif

namespace plumb::test {

/// For REQUIRE_THAT and REQUIRE_THROWS_WITH; the two versions name it differently.
inline auto containsText(const std::string& text) {
#if __has_include(<catch2/catch_all.hpp>)
    return Catch::Matchers::ContainsSubstring(text);
#else
    return Catch::Matchers::Contains(text);
#endif
}

}  // namespace plumb::test
