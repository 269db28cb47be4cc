// SPDX-License-Identifier: MIT
// On which numbers does the solver of joint islands work?
//
// An item (body, link, row, joint) has some fields; each field holds W doubles: one for each of W islands of the same
// layout, or W bodies, links, rows or joints of one island. So number f of item i in lane l is at
// (i * count + f) * W + l. Blocks are laid out so, too, but those of one island alone lie without gaps.
#pragma once
#include <cstddef>

#include <plumb/dynamics/joints/lanes/island_shape.h>

namespace plumb {

struct BodyField {
    enum : int {
        X,
        Y,
        Turn,  ///< displacement in this step [m], and angle turned [rad]
        Cos,
        Sin,  ///< of Turn
        Vx,
        Vy,
        Spin,  ///< velocity [m/s], [rad/s]
        InverseMass,
        InverseInertia,
        OwnMass,
        OwnInertia,
        Mass,
        Inertia,  ///< as they are solved for (see island_stiffness_wide.h); 0: it cannot turn
        StiffAlong,
        StiffTurning,  ///< from recent forces [N/m, N m/rad]
        Swinging,      ///< StiffTurning, also by what acts within pieces
        FreshAlong,
        FreshTurning,  ///< from the present ones
        NearMass,
        NearX,
        NearY,
        NearSquares,  ///< sums over neighbours: m, m r, m r^2
        Ux,
        Uy,
        Uspin,  ///< velocity that is solved for
        MovedX,
        MovedY,
        MovedSpin,  ///< with which it moved last in this step
        BentX,
        BentY,
        BentSpin,  ///< after a move in pieces, less its mean velocity in them
        FreeX,
        FreeY,
        FreeSpin,  ///< velocity without the impulses of the joints in this half of the sub-step
        LaterX,
        LaterY,
        LaterCos,
        LaterSin,
        AheadSpin,  ///< after the coming sub-step
        KeepLinear,
        KeepAngular,
        GainX,
        GainY,
        GainSpin,  ///< by forces in half a sub-step (see Kick)
        ContactMass,
        ContactInertia,  ///< with which contacts see the body (see island_response_wide.h)
        NormalX,
        NormalY,  ///< sum of the normals of its contacts, towards the body
        Response,
        TurnResponse,  ///< greatest change of its velocity by a unit impulse, and of its spin [1/kg, 1/(kg m^2)]
        count
    };
};

struct LinkField {
    enum : int {
        StartArmAx,
        StartArmAy,
        StartArmBx,
        StartArmBy,  ///< at the step's start [m]
        StartApartX,
        StartApartY,
        StartAngle,  ///< from A's anchor to B's [m], B's angle less A's [rad]
        ArmAx,
        ArmAy,
        ArmBx,
        ArmBy,
        ApartX,
        ApartY,
        Angle,  ///< now
        LaterApartX,
        LaterApartY,
        LaterAngle,  ///< after the coming sub-step
        count
    };
};

struct RowField {
    enum : int {
        // Of each part: A gets -axis and TurnA, B gets axis and TurnB of an impulse
        AxisX,
        AxisY,
        TurnA,
        TurnB,
        SecondAxisX,
        SecondAxisY,
        SecondTurnA,
        SecondTurnB,
        InverseMass,  ///< change of its speed by a unit impulse
        Coordinate,   ///< q [m or rad]
        Speed,        ///< that is wanted, where the row is solved for
        Compliance,   ///< -1: the row is not solved for, and gives Known
        Known,        ///< [N s or N m s]
        Impulse,      ///< of this pass
        NotedSpeed,   ///< before the sub-step; of a row that holds, before the half
        Origin,
        StartError,  ///< at the step's start
        // Only of rows that do not hold:
        LastState,  ///< RowState in the last pass that was not only to hold
        State,      ///< in this pass
        Target,
        Low,
        High,
        LowerStop,
        UpperStop,
        Push,
        DampPush,
        Wanted,     ///< the drive's target, if there were no stops
        Back,       ///< speed at which an error beyond a stop is closed; negative at the upper one
        StopPush,   ///< what stops have given for that in the half before the sub-step
        TakenBack,  ///< of it, in this pass
        Slope,      ///< see JointRow
        Growth,     ///< exp(DampedAt) - 1
        DampedAt,   ///< damping, half a sub-step and inverse mass, multiplied
        Loaded,     ///< 1: it is at a stop that is loaded by contacts; -1: that has opened in this half (see
                    ///< island_contacts.h)
        DriveSpeed,
        DriveRate,
        MostImpulse,
        LimitLower,
        LimitUpper,
        HalfStiffness,
        HalfDamping,
        SpringRest,
        // Of rows whose axis needs them:
        DirectionX,
        DirectionY,
        SecondDirectionX,
        SecondDirectionY,  ///< at the step's start
        Ratio,
        count
    };
};

struct JointField {
    enum : int { LoadX, LoadY, LoadTurn, count };  ///< sums over the step
};

/// The compliance e of rows that hold, relative to an inverse mass [-] (see island_elimination_wide.h).
inline constexpr double relativeCompliance = 1e-5;
/// The same in trees, relative to what a joint gives when it is eliminated [-].
inline constexpr double treeCompliance = 1e-9;

enum class LaneUse {
    Islands,  ///< each lane has an island
    Joints    ///< all lanes have joints, and bodies, of one island
};

/// How many numbers a block and a node's part of the solution have: of islands side by side, and of one alone, whose
/// columns and rows of three are filled up to four.
struct BlockNumbers {
    static constexpr std::size_t beside = 9, alone = 24;
};
struct NodeNumbers {
    static constexpr std::size_t beside = 3, alone = 4;
};

/// What the code for W lanes sees of W islands, or of one.
struct IslandLanes {
    // The items: what lies in the same lanes counts as one.
    const IslandShape::Link* links = nullptr;
    const IslandShape::Row* rows = nullptr;
    const IslandShape::Joint* joints = nullptr;   ///< and one past the end
    const std::uint32_t* endPlaces = nullptr;     ///< of both ends of each link: where its body begins
    std::uint32_t bodyItems = 0, movedItems = 0;  ///< all bodies, and those that impulses move
    std::uint32_t linkCount = 0, rowCount = 0, jointCount = 0;
    std::uint32_t movedEnd = 0;  ///< bodies that impulses do not move begin here, or after it

    // The equations, of each joint and each body.
    const IslandShape::Joint* laid = nullptr;  ///< and one past the end
    const IslandShape::Row* laidRows = nullptr;
    const std::uint32_t* bodyPlaces = nullptr;  ///< where it begins
    const std::uint32_t* rowPlaces = nullptr;
    const std::uint32_t* solvedPlaces = nullptr;  ///< of the joints of each item: where its part of the solution begins
    const IslandShape::BlockPlace* blockPlaces = nullptr;  ///< of both ends of each link
    const IslandShape::Step* steps = nullptr;
    const IslandShape::Lower* lowers = nullptr;
    const IslandShape::Update* updates = nullptr;
    std::uint32_t moved = 0, laidCount = 0, stepCount = 0, blocks = 0, firstFill = 0;
    bool someFree = false;
    bool isHeld = false;  ///< by bodies that impulses do not move

    double* body = nullptr;
    double* link = nullptr;
    double* row = nullptr;
    double* joint = nullptr;
    double* block = nullptr;
    double* solution = nullptr;  ///< of the nodes
    double* inverse = nullptr;   ///< of the matrix, where it has blocks
    double* active = nullptr;    ///< 1: the lane takes part in this pass
    double* missed = nullptr;    ///< how far the last prediction was off (see WidePlaces::keepMissed)
    double* lost = nullptr;      ///< 1: predictions have not come closer
    double* work = nullptr;      ///< of rows that hold in the last solution, see island_energy.h [J]
    double* heavy = nullptr;     ///< 1: dampers act by the speed at the end of each half (see island_curve_wide.h)
    bool factored = false;       ///< the blocks hold the factors of the present matrix
    double compliance = 0;       ///< of rows that hold, relative to their inverse mass [-]
    double slack = 0;            ///< the same, relative to what a joint gives when it is eliminated [-]
};

struct IslandTurn {
    double h = 0;           ///< of the sub-step [s]
    bool correct = false;   ///< before the bodies move: closes gaps, too
    bool onlyHold = false;  ///< motors and springs do nothing; their stops stay
    double fastest = 0;     ///< speed at which an error is removed at most [m/s]
    bool inPieces = false;  ///< the coming move closes the gaps itself
    double rate = 1 / h;    ///< [1/s]
    bool isLast = false;    ///< half of the step

    bool closesGaps() const { return correct && !inPieces; }
};

/// The same functions for each number of lanes, with bitwise equal results.
struct IslandKernel {
    /// Moves the bodies by h [s] at their velocities, and places the rows.
    void (*move)(IslandLanes& view, double h);
    /// Finds arms, axes and masses of rows, after bodies have moved.
    void (*place)(IslandLanes& view);
    /// Of rows that hold, or of the others.
    void (*noteSpeeds)(const IslandLanes& view, bool hold);
    /// Sets U to V, and to a share of the change since the last move in addition.
    void (*guess)(const IslandLanes& view, double share);
    /// Finds the conditions of the rows. How far they will be off is predicted from U.
    void (*prepare)(IslandLanes& view, const IslandTurn& turn);
    /// Where a lane is active, its rows that hold were predicted from velocities that are not U any more: predicts them
    /// again if that matters and comes closer to a solution, else makes the lane inactive, and lost if it does not come
    /// closer. Returns true if some lane is active.
    bool (*predictAgain)(IslandLanes& view, const IslandTurn& turn);
    /// Where a lane is active, predicts rows that hold from U; or, if nothing bends, they close the gaps that there
    /// are.
    void (*predictHeld)(const IslandLanes& view, const IslandTurn& turn, bool bends);
    /// Solves for U from the free velocities, and, where a lane is active, for the impulses. Returns true if a row came
    /// to another part of its curve; it can do so where a lane is active.
    bool (*solve)(IslandLanes& view);
    /// Solves for U, which is V and the change by a push: rows that hold, or are at a stop, keep their speeds.
    void (*solvePush)(IslandLanes& view);
    /// Finds how each body responds to an impulse, if no motor, spring or stop acts.
    void (*findResponses)(IslandLanes& view);
    /// Where a lane is active: sets V to U; adds the impulses to the loads; notes the stiffness by the forces.
    void (*accept)(const IslandLanes& view);
    void (*addLoads)(const IslandLanes& view);
    /// Of rows that hold, in the last solution (see island_energy.h).
    void (*findWork)(const IslandLanes& view);
    /// h: of the sub-step, or of the piece of it, whose half was solved [s].
    void (*noteForces)(const IslandLanes& view, double h, bool inPieces);
    /// Where a lane is active, finds the masses to solve for in the next sub-step of h [s].
    void (*setMasses)(IslandLanes& view, double h);
    /// Sets the free velocities to those after the forces of half a sub-step.
    void (*kick)(const IslandLanes& view);
    /// Finds the moments of inertia for the next step.
    void (*findInertias)(const IslandLanes& view, double h);
};

/// With vectors of W floats.
template <int W, LaneUse use>
struct WideIslandKernel {
    static const IslandKernel code;
};

/// The code for so many islands, and the lanes for them.
struct IslandCode {
    const IslandKernel* kernel = nullptr;
    LaneUse use = LaneUse::Islands;
    std::size_t lanes = 1;
};

/// How many islands at a time, with at most this number of floats in a vector?
int islandLanes(int lanes);
/// For 1, 2, 4 or 8 islands at a time, with at most this number of floats in a vector.
IslandCode islandCode(int islands, int lanes);

}  // namespace plumb
