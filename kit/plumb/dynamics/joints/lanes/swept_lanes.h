// SPDX-License-Identifier: MIT
// On which numbers does the sweep over joints work?
//
// A batch holds up to batchLanes joints of one shape. No two of them share a body that can be pushed.
#pragma once
#include <cstddef>

#include <plumb/collide/lanes/body_place.h>
#include <plumb/dynamics/bodies/softness.h>
#include <plumb/dynamics/bodies/solver_body.h>
#include <plumb/dynamics/joints/lanes/island_shape.h>

namespace plumb {

/// What all joints of a batch have in common (see JointForm). An axis that is fixed in the world is x or y.
struct SweptForm {
    std::uint8_t links = 1, rows = 2;
    RowAxis axis[3] = {}, secondAxis = {};
    bool alongY[3] = {}, secondAlongY = false, holds[3] = {}, bounded[3] = {};
    bool turnsOnly = false;
    std::uint8_t first[3] = {}, fields = 0;  ///< the first of each row's own fields; number of all fields

    bool operator==(const SweptForm&) const = default;
};

/// The fields of a batch, batchLanes floats each.
struct SweptField {
    /// Of the joint: sums over the step, and the impulses of the last half.
    enum : int { LoadX, LoadY, LoadTurn, Impulse, joint = Impulse + 3 };
    /// Of a link at the step's start: arms, and from A's anchor to B's [m].
    enum : int { ArmAx, ArmAy, ArmBx, ArmBy, ApartX, ApartY, InverseGyrationA, InverseGyrationB, firstLocal };
    /// Anchors in the bodies' frames, and from A's periodic image to B's [m].
    enum : int { LocalAx = firstLocal, LocalAy, LocalBx, LocalBy, ShiftX, ShiftY, firstNow };
    /// Arms and gap now; and what A has turned in this step, and B more than A.
    enum : int { NowAx = firstNow, NowAy, NowBx, NowBy, NowApartX, NowApartY, CosMinus1, Sin, Angle, link };
    /// Of a row that is not fixed in the world: its origin, less angles at the step's start; its direction in A's
    /// frame, and at the step's start.
    enum : int { Origin, held, LocalX = held, LocalY, StartX, StartY, directed };
    /// Of one that does not hold (see RowForm).
    enum : int { Speed = directed, Rate, MostForce, Lower, Upper, Stiffness, Damping, SpringRest, free };
    /// Of one of two links.
    enum : int { SecondLocalX = free, SecondLocalY, SecondStartX, SecondStartY, Ratio, twofold };
    /// What the observer is told of a row.
    enum : int {
        AxisX,
        AxisY,
        TurnA,
        TurnB,
        SecondX,
        SecondY,
        SecondTurnA,
        SecondTurnB,
        Push,
        High,
        Slope,
        After,
        Given,
        told
    };
};

/// Two rows that hold, along x and along y: most joints of wide nets. Not inline: code for wide lanes has its own copy.
constexpr SweptForm plainHinge{.axis = {RowAxis::World, RowAxis::World},
                               .alongY = {false, true},
                               .holds = {true, true},
                               .fields = int{SweptField::joint} + int{SweptField::link}};

struct SweptBatch {
    SweptForm shape;
    bool isPlain = false;                ///< its shape is plainHinge
    std::size_t fields = 0, bodies = 0;  ///< the first of its fields and of its lists of bodies: A and B of each link
};
struct alignas(64) SweptFloats {
    Lanes<float> of = {};
};
struct alignas(64) SweptSlots {
    Lanes<std::uint32_t> of = {};  ///< an empty lane has 0
};

struct SweptPass {
    float h = 0;           ///< of the sub-step [s]
    bool correct = true;   ///< before the sub-step: closes gaps too
    bool hasMoved = true;  ///< since the last half
    float fastest = 0;     ///< greatest speed at which a gap is closed [m/s]
    Softness soft;
    bool isFirstGuess = false;  ///< only applies the impulses of the half before
    float* told = nullptr;      ///< for the observer: three rows of each batch
};

/// The same two functions for each number of lanes, with bitwise equal results.
struct SweptKernel {
    void (*prepare)(const SweptBatch& batch, float* fields, const std::uint32_t* bodies, const BodyPlace* places);
    void (*solve)(const SweptBatch& batch, float* fields, const std::uint32_t* bodies, const SolverBodies& all,
                  const SweptPass& pass);
};

template <int W>
struct WideSweptKernel {
    static const SweptKernel code;
};

/// The widest that this machine supports, with at most this number of lanes.
const SweptKernel& sweptKernel(int lanes);

}  // namespace plumb
