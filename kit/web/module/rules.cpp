// SPDX-License-Identifier: MIT
#include <web/module/row.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <utility>
#include <vector>

namespace plumb::web {

/// Asks JavaScript, which finds the candidate in `count` numbers.
extern "C" __attribute__((import_module("plumb"), import_name("mayTouch"))) std::int32_t mayTouch(
    std::uint32_t rule, const double* candidate, std::uint32_t count);

namespace {

template <std::size_t Number>
bool ask(const ContactCandidate& candidate) {
    static std::vector<double> row;
    Writer(row).add(candidate);
    return mayTouch(Number, row.data(), static_cast<std::uint32_t>(row.size())) != 0;
}

template <std::size_t... I>
constexpr std::array<ContactRule, sizeof...(I)> rulesFor(std::index_sequence<I...>) {
    return {&ask<I + 1>...};
}
constexpr std::array<ContactRule, mostRules> rules = rulesFor(std::make_index_sequence<mostRules>{});

}  // namespace

ContactRule ruleOf(std::size_t number) {
    if (number > mostRules)
        throw std::invalid_argument("ShapeDef.rule: there may be no more than " + std::to_string(mostRules) + " rules");
    return number == 0 ? nullptr : rules[number - 1];
}

std::size_t numberOf(ContactRule rule) {
    if (rule == nullptr) return 0;
    return static_cast<std::size_t>(std::find(rules.begin(), rules.end(), rule) - rules.begin()) + 1;
}

}  // namespace plumb::web
