// SPDX-License-Identifier: MIT
// How is a batch of joint islands solved in a step?
//
// A batch holds up to eight islands of one layout, from the start of a step to its end. In each half of a sub-step it
// is kicked, which gives the free velocities, those without joints; and solved, which gives the velocities at which
// joints hold. Joints hold exactly after each solution, so nothing is carried on from one to the next but a first
// guess. What contacts push afterwards is added to the free velocities, and the batch is solved again from there.
// Where others see it: island_records.h. What contacts see of it: island_contacts.h.
#pragma once
#include <plumb/dynamics/bodies/step_observer.h>
#include <plumb/dynamics/joints/island_contacts.h>
#include <plumb/dynamics/joints/island_records.h>

namespace plumb {

/// An impulse on a body, and the change of the body's velocity; each along x, along y, turning.
struct BodyPush {
    BodyIndex body = noBody;
    Vec3 impulse{}, change{};
};

class JointBatch {
public:
    IslandNumbers numbers;
    IslandContacts contacts;

    JointBatch() = default;
    /// A copy is empty: it is filled at the start of a step.
    JointBatch(const JointBatch&) {}
    JointBatch(JointBatch&&) = default;
    JointBatch& operator=(const JointBatch&) { return *this = JointBatch(); }
    JointBatch& operator=(JointBatch&&) = default;

    /// Takes in islands of one layout, as they are at the start of a step with sub-steps of h [s], in vectors of at
    /// most so many floats.
    void load(std::span<JointIsland* const> islands, const JointStore& joints, BodyStore& bodies, double h,
              int mostFloats);
    /// Gives them back at its end, after dt [s].
    void store(JointStore& joints, BodyStore& bodies, double dt);

    /// Adds what others have changed.
    void pull(const BodyStore& bodies);
    /// Others may have moved bodies: the next pull takes that in.
    void noteMoves() { moved_ = true; }
    /// At the start of a half: pulls, and lets the step's forces and the contacts' first guess act on the free
    /// velocities. correct: in the half before the bodies move.
    void kick(const BodyStore& bodies, bool correct);
    /// Solves all joints from the free velocities.
    void solve(BodyStore& bodies, const IslandTurn& turn);
    /// After contacts were solved: solves again where they have changed something. Returns those lanes.
    LaneFlags respondToContacts(BodyStore& bodies, const IslandTurn& turn);
    /// At the end of the half: notes the loads.
    void note(StepObserver* observer) { note(observer, h_, false); }
    /// By a sub-step of h [s]; fastest: speed at which gaps are closed at most [m/s].
    void move(BodyStore& bodies, double h, double fastest, StepObserver* observer);

    // Of one island:
    /// By how much impulses together would change the velocities of these bodies, with the joints' response.
    void respond(std::size_t lane, std::span<BodyPush> pushes);
    /// Applies them, and the impulses of the joints that follow from them.
    void push(BodyStore& bodies, std::size_t lane, std::span<BodyPush> pushes);
    void addLoads(std::size_t lane);
    /// Removes the errors of its held rows after the coming h [s].
    void closeGaps(BodyStore& bodies, std::size_t lane, double h, double fastest);

    const std::vector<JointIsland*>& islands() const { return numbers.islands; }
    std::size_t bytes() const { return numbers.bytes() + contacts.bytes(); }

private:
    /// Calls change(velocity, place, the field Bent) for each coordinate of each body.
    template <class Change>
    void forEachCoordinate(Change&& change);
    void moveInPieces(BodyStore& bodies, double h, double fastest, StepObserver* observer);
    void endPieces();
    void setFreeVelocities();
    /// In some lanes. change: the share of the last change of velocities that is expected again.
    void findSolution(const BodyStore& bodies, const IslandTurn& turn, const LaneFlags& lanes, double change);
    /// From conditions of the rows that are known.
    void solvePrepared(const BodyStore& bodies, const IslandTurn& turn, const LaneFlags& lanes);
    void predict(const IslandTurn& turn);
    void noteStates();
    /// Before the velocities of a half change. ofFree: of rows that do not hold, too.
    void noteSpeeds(bool ofFree);
    /// Before a move, notes what joints give an island that touches nothing; after it, takes back what they may not
    /// give.
    void keepEnergy(const BodyStore& bodies, std::size_t lane, const IslandTurn& turn);
    /// The same as without numbers; none, if something else than forces and rows that hold acts on the island.
    double fallOf(std::size_t lane, int velocity) const;
    void note(StepObserver* observer, double h, bool inPieces);
    IslandTurn ownTurn(IslandTurn turn) const;
    /// Adds the changes of velocity by impulses, without the joints', to velocities of a kind.
    void addPushes(std::size_t lane, std::span<BodyPush> pushes, int field);
    Vec3 changeBy(std::size_t lane, std::size_t node, const Vec3& impulse) const;

    double h_ = 0;                   ///< of the sub-step [s]
    int pieces_ = 1;                 ///< in which its islands move in each of them
    LaneFlags pushed_{};             ///< an impact has changed the free velocities
    LaneFlags given_{};              ///< by joints, before the move [J]
    LaneFlags raised_{};             ///< by the move, more than forces have taken for it [J]
    LaneFlags lost_{}, lostNext_{};  ///< before and after this sub-step, see JointIsland
    LaneFlags energy_{};             ///< that the islands had lately [J]
    bool moved_ = false;             ///< others may have moved bodies
    bool touchesNothing_ = false;    ///< one of its islands
};

}  // namespace plumb
