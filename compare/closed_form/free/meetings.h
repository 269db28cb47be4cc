// SPDX-License-Identifier: MIT
// What does a free body meet next, and when?
#pragma once
#include <optional>
#include <span>
#include <string>

#include <compare/closed_form/free/free_body.h>
#include <plumb/space/wrap.h>

namespace plumb::compare {

/// Something new that happens to a body.
struct Meeting {
    enum class Kind {
        Face,     ///< it comes to a face
        Corner,   ///< to a corner or to a disc that does not give way
        Other,    ///< to another free body
        SlipEnd,  ///< it stops slipping on its face
        FaceEnd,  ///< it comes to the end of its face
        Unknown,  ///< to something that it can meet in no way that is known here
    };
    Kind kind = Kind::Face;
    double time = 0;                  ///< [s]
    std::size_t body = 0, other = 0;  ///< places in the list
    const Face* face = nullptr;
    const Corner* corner = nullptr;
    Vec2 shift{0, 0};   ///< of the other one's image in a world that wraps [m]
    std::string why{};  ///< of what is unknown
};

/// The first, up to a time; empty when nothing happens.
/// Each is the first fall through zero of a distance, a polynomial of time: of a face n.(x - p) - r, of a disc |d|^2 -
/// r^2. Source: elementary. Tests: tests/compare/closed_form/follows_test.cpp
std::optional<Meeting> nextMeeting(std::span<const FreeBody> bodies, const Wrap& wrap, double until);

}  // namespace plumb::compare
