// SPDX-License-Identifier: MIT
// Which fields may be added?
#include <type_traits>

#include <plumb/dynamics/describe.h>
#include <plumb/dynamics/edit/validate.h>
#include <plumb/math/check.h>
#include <plumb/math/require_members.h>

namespace plumb {

namespace {

struct LawCheck {
    const MemberPath& path;
    template <class T>
    [[gnu::always_inline]] void operator()(const Member& member, const T& value) const {
        if constexpr (!std::is_same_v<T, BodyId>) requireMember(member, value, path);
    }
};

void validateRegion(const Shape& region) {
    validate(region, "FieldDef.region");
    if (std::holds_alternative<Segment>(region) || std::holds_alternative<Chain>(region))
        refuse("FieldDef.region", "a line has no area that a field could fill");
    if (std::holds_alternative<TileMap>(region))
        refuse("FieldDef.region", "a tile map is not one area: give a field to each part of it");
}

}  // namespace

/// Law by law, from their descriptions; ids depend on the world, and are checked below.
void validate(const FieldDef& def) {
    std::visit(
        []<class Law>(const Law& law) {
            const MemberPath path{definitionName<Law>.type};
            describe(law, LawCheck{path});
        },
        def.law);
    if (def.region) validateRegion(*def.region);
}

void validate(const WorldState& world, const FieldDef& def) {
    if (const auto* magnet = std::get_if<Magnet>(&def.law)) requireBody(world, magnet->body, "Magnet.body");
    validate(def);
}

}  // namespace plumb
