// SPDX-License-Identifier: MIT
// How are the contacts of machines solved in half a sub-step? By the method of machine_contacts.h.
#pragma once
#include <span>
#include <vector>

#include <plumb/dynamics/joints/joint_islands.h>
#include <plumb/dynamics/solver/machine_rows.h>

namespace plumb {

/// One pass over the contacts of all machines.
class MachineSweep {
public:
    MachineSweep(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                 const MachineContacts& machines, const MachinePass& pass);
    void run();

private:
    void findBefore();
    void load();
    void findAnswers();
    void findAnswer(MachineRow& row, MachineEnd& end, const MachineEnd& other);
    std::span<const Vec3> unitAnswers(std::uint32_t part, std::uint32_t node);
    Vec3 changeBy(std::size_t part, std::size_t node, const Vec3& push) const;
    void addAnswer(std::span<Vec3> answer, const MachineEnd& end);
    double massOf(const MachinePart& part) const;
    double energyOf(const std::vector<std::vector<Vec3>>& velocities) const;
    double givenEnergy() const;
    void dropIfUseless();
    void sweep();
    double solveContact(MachineRows& rows, bool findLimits);
    void solveNormal(MachineRows& rows, std::size_t point);
    void solveWithin(MachineRow& row, double& most);
    double wantedImpulse(const MachineRow& row, double bias, double give) const;
    void setImpulse(MachineRow& row, double impulse);
    void apply(const MachineEnd& end, double impulse);
    double speedOf(const MachineRow& row) const;
    bool solveJoints();
    std::vector<std::vector<Vec3>> impulses() const;
    std::vector<std::vector<Vec3>> pushes() const;
    std::vector<std::vector<Vec3>> withoutJoints() const;
    void accept();

    const JointStores& stores_;
    ContactGraph& graph_;
    const ContactStore& contacts_;
    const MachineContacts& machines_;
    const MachinePass& pass_;
    IslandTurn joints_;
    std::vector<MachineRows> rows_;                  ///< of the contacts
    std::vector<std::vector<Vec3>> velocities_;      ///< of the bodies of each part
    std::vector<std::vector<Vec3>> guess_;           ///< the contacts' impulses at the start, on each body
    std::vector<std::vector<Vec3>> tried_;           ///< the same, before these contacts are solved
    std::vector<std::vector<Vec3>> before_;          ///< the same, without the joints' and these contacts' impulses
    std::vector<Vec3> answers_;                      ///< of the rows' ends
    std::vector<std::vector<std::size_t>> unitsAt_;  ///< of each body of each part: where its entry in units_ begins
    std::vector<Vec3> units_;                        ///< answers to unit impulses on a body along x, y, and turning
    double scale_ = 1;                               ///< speed of the fastest body, at least 1 m/s
    bool sameStates_ = false;                        ///< the joints' matrices are those of the answers
};

/// Solves the contacts that are hidden, and puts their masses and impulses back into their lanes.
void solveMachineContacts(const JointStores& stores, ContactGraph& graph, const ContactStore& contacts,
                          MachineContacts& machines, const MachinePass& pass);

}  // namespace plumb
