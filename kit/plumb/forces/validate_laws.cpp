// SPDX-License-Identifier: MIT
// Which laws of force are refused?
#include <type_traits>

#include <plumb/forces/describe_law.h>
#include <plumb/forces/detail/require_numbers.h>
#include <plumb/math/require_members.h>

namespace plumb {

namespace {

struct NumberCheck {
    const MemberPath& path;
    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) const {
        if constexpr (std::is_arithmetic_v<T>) requireMember(member, value, path);
    }
};

template <class Law>
void check(const Law& law) {
    describe(law, NumberCheck{{definitionName<Law>.type}});
}

}  // namespace

void requireNumbers(const Attractor& law) {
    check(law);
}

void requireNumbers(const Drag& law) {
    check(law);
}

void requireNumbers(const Fluid& fluid) {
    requireMembers(fluid, {definitionName<Fluid>.type});
}

void requireNumbers(const GroundFriction& law) {
    check(law);
}

void requireNumbers(const MutualGravity& law) {
    check(law);
}

void requireNumbers(const UniformGravity& law) {
    check(law);
}

}  // namespace plumb
