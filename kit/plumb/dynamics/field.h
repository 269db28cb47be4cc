// SPDX-License-Identifier: MIT
// Which law does a field follow, and how can it be changed?
#pragma once
#include <plumb/dynamics/field_def.h>

namespace plumb {

struct WorldState;

/// A read-only view of one field of a world. Valid as long as the world exists; each call
/// throws std::invalid_argument once the field was removed.
class FieldView {
public:
    FieldId id() const;
    FieldDef def() const;  ///< as given or last set

protected:
    friend class World;
    FieldView(WorldState& world, FieldId id) : world_(&world), id_(id) {}
    std::uint32_t index() const;  ///< the slot; throws std::invalid_argument if it was removed
    WorldState* world_;
    FieldId id_;
};

/// A view that can also change the field.
class Field : public FieldView {
public:
    /// Replaces the definition, and wakes the bodies on which the field acted or acts now. Throws
    /// std::invalid_argument, and changes nothing, if the definition is not valid.
    void set(const FieldDef& def);

private:
    friend class World;
    using FieldView::FieldView;
};

}  // namespace plumb
