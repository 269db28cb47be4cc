// SPDX-License-Identifier: MIT
// Which body, which shape, which joint, which field? An id stays valid until its object is removed, and is never
// reused. Ids have an order, so that they can be sorted and be keys of a std::set; it is that of the slots.
#pragma once
#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>  // for std::hash: <functional> would make each source longer by 16,000 lines

namespace plumb {

/// index: the slot; generation: how often the slot was used before; world: the world it belongs to, 0 for none.
struct BodyId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;
    std::uint32_t world = 0;
    friend std::strong_ordering operator<=>(const BodyId&, const BodyId&) = default;
};

struct JointId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;
    std::uint32_t world = 0;
    friend std::strong_ordering operator<=>(const JointId&, const JointId&) = default;
};

struct FieldId {
    std::uint32_t index = 0;
    std::uint32_t generation = 0;
    std::uint32_t world = 0;
    friend std::strong_ordering operator<=>(const FieldId&, const FieldId&) = default;
};

/// number: counted from 0 on each body, in the order in which its shapes were added; BodyDef.shapes[i] has number i.
struct ShapeId {
    BodyId body;
    std::uint32_t number = 0;
    friend std::strong_ordering operator<=>(const ShapeId&, const ShapeId&) = default;
};

}  // namespace plumb

/// Hash functions, for ids as keys of a std::unordered_map.
template <>
struct std::hash<plumb::BodyId> {
    std::size_t operator()(const plumb::BodyId& id) const noexcept {
        const std::uint64_t bits = (std::uint64_t{id.generation} << 32 | id.index) ^ std::uint64_t{id.world} << 48;
        return std::hash<std::uint64_t>{}(bits);
    }
};
template <>
struct std::hash<plumb::JointId> {
    std::size_t operator()(const plumb::JointId& id) const noexcept {
        return std::hash<plumb::BodyId>{}({id.index, id.generation, id.world});
    }
};
template <>
struct std::hash<plumb::FieldId> {
    std::size_t operator()(const plumb::FieldId& id) const noexcept {
        return std::hash<plumb::BodyId>{}({id.index, id.generation, id.world});
    }
};
template <>
struct std::hash<plumb::ShapeId> {
    std::size_t operator()(const plumb::ShapeId& id) const noexcept {
        return std::hash<plumb::BodyId>{}(id.body) * 31 + id.number;
    }
};
