// SPDX-License-Identifier: MIT
// One pass over the contacts of all machines: see machine_contacts.h.
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/joints/joint_island.h>
#include <plumb/dynamics/solver/machine_contacts.h>

namespace plumb {

/// The inputs for islands that are solved directly: their whole gaps are closed in one sub-step.
inline JointPass directPass(const SolverSettings& settings, const JointHalf& half) {
    return {half.step, half.correct, half.correct ? 1 / half.step : 0.0, settings.contactPushSpeed};
}

class MachineSweep {
public:
    MachineSweep(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                 const MachineContacts& machines, const MachinePass& pass);
    void run();

private:
    /// A unit impulse on a body, x, y, turning, and the answer of all bodies of its part.
    struct End {
        std::uint32_t part = none, node = 0;
        BodyIndex body = noBody;
        Vec3 push{};
        std::size_t answer = 0;
    };
    struct Row {
        End a, b;
        double inverseMass = 0;  ///< change of the row's speed by a unit of its impulse; 0: there is no such row
        double fixedSpeed = 0;   ///< of bodies that cannot be pushed, and of the surfaces [m/s]
        double start = 0;        ///< impulse at the start of this half [N s, N m s]
        double given = 0;        ///< of the half before, which this half may take back
        double impulse = 0;      ///< now
    };
    /// The rows of a contact: two normals, two tangents, rolling.
    struct Rows {
        std::array<Row, 5> row;
        std::array<double, 2> separation{};
        double friction = 0, rollingArm = 0, mass = 0;
        bool ground = false;
    };

    void addRows(const MachineContact& machine);
    Row rowOf(const MachineContact& machine, const ContactRecord& contact, const Vec3& pushA, const Vec3& pushB,
              float start) const;
    void noteBounces();
    void load();
    void findAnswers();
    void findAnswer(Row& row, End& end, const End& other);
    std::span<const Vec3> unitAnswers(std::uint32_t part, std::uint32_t node, BodyIndex body);
    void addAnswer(std::span<Vec3> answer, const End& end);
    double softMass(const Row& row) const;
    void sweep();
    double solveContact(Rows& rows);
    void solveNormal(Rows& rows, std::size_t point);
    void solveWithin(Row& row, double limit, double& most);
    void setImpulse(Row& row, double impulse);
    void apply(const End& end, double impulse);
    double speedOf(const Row& row) const;
    bool solveJoints();
    std::vector<std::vector<Vec3>> withoutJoints() const;
    void accept();
    void storeImpulses() const;

    const JointStores& stores_;
    ContactGraph& graph_;
    const ContactStore& contacts_;
    const MachineContacts& machines_;
    const MachinePass& pass_;
    JointPass joints_;
    std::vector<Rows> rows_;                         ///< of the contacts
    std::vector<std::vector<Vec3>> velocities_;      ///< of the bodies of each part
    std::vector<std::vector<Vec3>> before_;          ///< the same, without the joints' and these contacts' impulses
    std::vector<Vec3> answers_;                      ///< of the rows' ends
    std::vector<std::vector<std::size_t>> unitsAt_;  ///< of each body of each part: where its entry in units_ begins
    std::vector<Vec3> units_;                        ///< answers to unit impulses on a body along x, y, and turning
    bool sameStates_ = false;                        ///< the joints' matrices are those of the answers
};

}  // namespace plumb
