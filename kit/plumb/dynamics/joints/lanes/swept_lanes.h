// SPDX-License-Identifier: MIT
// On which numbers does the sweep over joints work?
//
// A batch holds up to batchLanes joints of one shape. No two of them share a body that can be pushed.
#pragma once
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

/// The fields of a batch, batchLanes floats each: those of the joint, of its links, and of its rows that need some.
struct SweptField {
    enum : int { LoadX, LoadY, LoadTurn, Impulse, joint = Impulse + 3 };  ///< sums over the step; of the last half
    enum : int {
        ArmAx,
        ArmAy,
        ArmBx,
        ArmBy,
        ApartX,
        ApartY,  ///< at the step's start, from A's anchor to B's [m]
        InverseGyrationA,
        InverseGyrationB,
        LocalAx,
        LocalAy,
        LocalBx,
        LocalBy,
        ShiftX,
        ShiftY,  ///< of A's periodic image to B's [m]
        link
    };
    enum : int {
        Origin,  ///< less the angles at the step's start
        held,
        LocalX = held,
        LocalY,  ///< the direction, in A's frame
        StartX,
        StartY,  ///< at the step's start
        directed,
        DriveSpeed = directed,
        DriveRate,
        MostForce,
        LimitLower,
        LimitUpper,
        Stiffness,
        Damping,
        SpringRest,
        free,
        SecondLocalX = free,
        SecondLocalY,
        SecondStartX,
        SecondStartY,
        Ratio,
        twofold
    };
    /// Of each row that the observer is told of.
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

/// Two rows that hold, along x and along y: most joints of wide nets.
inline constexpr SweptForm plainHinge{.axis = {RowAxis::World, RowAxis::World},
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
    float h = 0;          ///< of the sub-step [s]
    bool correct = true;  ///< before the sub-step: closes gaps too
    float fastest = 0;    ///< greatest speed at which a gap is closed [m/s]
    Softness soft;
    float* told = nullptr;  ///< for the observer: three rows of each batch
};

/// The same three functions for each number of lanes, with bitwise equal results.
struct SweptKernel {
    void (*prepare)(const SweptBatch& batch, float* fields, const std::uint32_t* bodies, const BodyPlace* places);
    /// Applies the impulses of the previous half sub-step as a first guess.
    void (*warmStart)(const SweptBatch& batch, float* fields, const std::uint32_t* bodies, const SolverBodies& all);
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
