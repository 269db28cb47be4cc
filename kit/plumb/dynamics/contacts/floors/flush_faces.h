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
#include <plumb/collide/lanes/pair_lanes.h>
#include <plumb/dynamics/contacts/contact_store.h>
#include <plumb/dynamics/contacts/floors/flush_sides.h>

namespace plumb {

/// Has the manifold in this lane one place only? All others are no contacts at a corner.
bool isAtCorner(const FreshLanes& fresh, std::size_t lane);
bool someAtCorner(const FreshLanes& fresh, std::size_t count);  ///< in some of the first lanes

/// Which of two bodies may be part of a floor on which the other one slides, in a step of dt [s]? Bits.
inline constexpr int floorA = 1, floorB = 2;
int floorSides(const BodyStore& bodies, BodyIndex a, BodyIndex b, double dt);

/// The faces that meet at a contact's place, unless the contact's normal is that of the other face there.
CornerFaces facesAt(const ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex contact,
                    const Manifold& manifold);

/// Of a contact at a corner; sides: the bodies that may be part of a floor.
bool isAtCoveredFace(const ContactStore& contacts, const BodyStore& bodies, const Space& space, ContactIndex contact,
                     const Manifold& manifold, int sides);

}  // namespace plumb
