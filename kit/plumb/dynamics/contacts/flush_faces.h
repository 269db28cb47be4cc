// SPDX-License-Identifier: MIT
// Does a contact lie inside of a surface that several shapes make up together?
//
// Boxes that are laid flush make one floor. What slides over it meets, at each joint, a corner of the next box: with a
// normal of the side that the box before it covers, or of the corner, which would stop the body or make it hop. Such a
// contact is none: at a corner between two faces of which one is covered, only the normal of the other is possible.
// A face counts as covered at a corner if a point just outside of it, and a little below the other face, is inside of
// another shape that the body may touch, too. Of loose boxes, only those count that are at rest.
// Test: "what slides over boxes laid flush goes on as over one box"
#pragma once
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/contacts/lanes/fresh_lanes.h>

namespace plumb {

/// In some lane of a batch, has the manifold one place only? All others are no contacts at a corner.
bool someAtCorner(const FreshLanes& fresh);
bool isAtCorner(const FreshLanes& fresh, std::size_t lane);
/// Of a contact at a corner, whose manifold is in this lane; dt: of the step [s].
bool isAtCoveredFace(const ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex contact,
                     const ShapePair& pair, const FreshLanes& fresh, std::size_t lane, double dt);

}  // namespace plumb
