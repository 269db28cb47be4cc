// SPDX-License-Identifier: MIT
// Which definitions of joints are refused in every world?
#include <type_traits>

#include <plumb/dynamics/describe.h>
#include <plumb/math/check.h>
#include <plumb/math/require_members.h>

namespace plumb {

namespace {

/// Checks each member by its description. Written in place (always_inline), so that only the checks get into a program,
/// and none of the descriptions' texts (math/require_members.h).
struct JointMemberCheck {
    const MemberPath& path;
    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) const {
        if constexpr (std::is_same_v<T, std::optional<Limit>>) {
            requireMember(member, value, path);
            if (value && !(value->lower <= value->upper))
                refuse(path.text(member.name) + ".lower",
                       toText(value->lower) + " is more than limit.upper " + toText(value->upper));
        } else if constexpr (!std::is_same_v<T, BodyId> && !std::is_same_v<T, JointId>) {
            requireMember(member, value, path);
        }
    }
};

// Conditions between the members of a def, if there are any.

template <class Def>
void validateTogether(const Def&, const MemberPath&) {}

void validateTogether(const DistanceJointDef& def, const MemberPath& path) {
    if (!def.spring && def.anchorA == def.anchorB)
        refuse(path.text("anchorB"), toText(def.anchorB) + " is anchorA too, so the rod would have no direction");
    if (def.maxLength < def.minLength)
        refuse(path.text("maxLength"), toText(def.maxLength) + " is less than minLength " + toText(def.minLength));
}

void validateTogether(const PulleyJointDef& def, const MemberPath& path) {
    const std::string fault = " too, so the rope would have no direction";
    if (def.groundA == def.anchorA) refuse(path.text("groundA"), toText(def.groundA) + " is anchorA" + fault);
    if (def.groundB == def.anchorB) refuse(path.text("groundB"), toText(def.groundB) + " is anchorB" + fault);
}

}  // namespace

void validate(const JointDef& def, const std::string& field) {
    const MemberPath path{field};
    std::visit(
        [&path](const auto& kind) {
            describe(kind, JointMemberCheck{path});
            validateTogether(kind, path);
        },
        def);
}

}  // namespace plumb
