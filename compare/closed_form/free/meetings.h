// SPDX-License-Identifier: MIT
// What does a free body meet next, and when?
#pragma once
#include <optional>
#include <span>
#include <string>

#include <compare/closed_form/free/free_body.h>
#include <plumb/space/wrap.h>

namespace plumb::compare {

/// An event of a body.
struct Meeting {
    enum class Kind {
        Face,     ///< it reaches a face
        Corner,   ///< it reaches a corner, or a disc that does not give way
        Other,    ///< it reaches another free body
        SlipEnd,  ///< it stops slipping on its face
        FaceEnd,  ///< it reaches the end of its face
        Unknown,  ///< it meets something in a way that has no formula here
    };
    Kind kind = Kind::Face;
    double time = 0;                  ///< [s]
    std::size_t body = 0, other = 0;  ///< places in the list
    const Face* face = nullptr;
    const Corner* corner = nullptr;
    Vec2 shift{0, 0};   ///< shift to the image of the other body, in a world that wraps [m]
    std::string why{};  ///< the reason, if unknown
};

/// The first event up to a time; empty if nothing happens.
/// Each event is the first fall through zero of a distance, which is a polynomial of time: for a face n.(x - p) - r,
/// for a disc |d|^2 - r^2. Source: elementary. Tests: tests/compare/closed_form/follows_test.cpp
std::optional<Meeting> nextMeeting(std::span<const FreeBody> bodies, const Wrap& wrap, double until);

}  // namespace plumb::compare
