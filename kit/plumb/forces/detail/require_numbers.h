// SPDX-License-Identifier: MIT
// Are a law's own numbers as its description allows?
#pragma once
#include <type_traits>

#include <plumb/forces/describe_law.h>
#include <plumb/math/require_members.h>

namespace plumb {

/// Leaves out vectors: a centre may be a body's, and a step never throws.
struct NumberCheck {
    const MemberPath& path;
    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) const {
        if constexpr (std::is_arithmetic_v<T>) requireMember(member, value, path);
    }
};

template <class Law>
void requireNumbers(const Law& law) {
    describe(law, NumberCheck{{definitionName<Law>.type}});
}

}  // namespace plumb
