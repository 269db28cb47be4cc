// SPDX-License-Identifier: MIT
// Which definitions of shapes are refused?
#include <type_traits>

#include <plumb/math/require_members.h>
#include <plumb/space/describe_shape_def.h>

namespace plumb {

namespace {

/// An outline is checked by its own rules.
struct ShapeCheck {
    const MemberPath& path;
    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) const {
        if constexpr (std::is_same_v<T, Shape>)
            validate(value, path.text(member.name));
        else
            requireMember(member, value, path);
    }
};

}  // namespace

void validate(const ShapeDef& def, const std::string& field) {
    const MemberPath path{field};
    describe(def, ShapeCheck{path});
}

}  // namespace plumb
