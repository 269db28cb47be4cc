// SPDX-License-Identifier: MIT
#include <plumb/dynamics/solver/machine_rows.h>

#include <plumb/dynamics/joints/joint_response.h>

namespace plumb {

namespace {

MachineRow rowOf(const MachineContact& machine, const ContactRecord& contact, const BodyStore& bodies,
                 const JointHalf& half, const Vec3& pushA, const Vec3& pushB, float start) {
    MachineRow row;
    row.a = {machine.a.part, machine.a.node, contact.bodyA, pushA, 0};
    row.b = {machine.b.part, machine.b.node, contact.bodyB, pushB, 0};
    for (const MachineEnd* end : {&row.a, &row.b}) {
        if (end->part == none) row.fixedSpeed += dot(end->push, velocityOf(bodies, end->body));
        row.ownInverseMass += dot(end->push, velocityChangeBy(bodies, end->body, end->push));
    }
    row.inverseMass = row.ownInverseMass;
    row.impulse = static_cast<double>(start);
    row.given = half.correct ? 0.0 : row.impulse;
    return row;
}

}  // namespace

MachineRows rowsOf(const MachineContact& machine, const ContactGraph& graph, const ContactRecord& contact,
                   const BodyStore& bodies, const JointHalf& half) {
    const ContactBatch& batch = graph.colours[contact.colour].batches[contact.slot / batchLanes];
    const std::size_t lane = contact.slot % batchLanes;
    const int colour = colourAt(contact.colour);
    const double nx = static_cast<double>(batch.normalX[lane]), ny = static_cast<double>(batch.normalY[lane]);
    const auto armOf = [&](BodyIndex body, float anchor) {
        const float inverseGyration = bodies.turn[body].inverseGyration;
        return inverseGyration > 0 ? static_cast<double>(anchor / inverseGyration) : 0.0;
    };
    const auto row = [&](const Vec3& pushA, const Vec3& pushB, float start) {
        return rowOf(machine, contact, bodies, half, pushA, pushB, start);
    };
    MachineRows rows;
    rows.friction = static_cast<double>(batch.friction[lane]);
    rows.rollingArm = static_cast<double>(batch.rollingArm[lane]);
    rows.ground = colour >= fixedColour && colour != overflowColour;
    const BodyIndex a = contact.bodyA, b = contact.bodyB;
    for (std::size_t p = 0; p < 2; ++p) {
        const PointLanes& point = batch.points[p];
        if (!(machine.normalMass[p] > 0)) continue;
        rows.separation[p] = static_cast<double>(point.separation[lane]);
        rows.row[p] = row({-nx, -ny, armOf(a, point.anchorTangentA[lane])},
                          {nx, ny, -armOf(b, point.anchorTangentB[lane])}, machine.normal[p]);
        rows.row[2 + p] = row({ny, -nx, -armOf(a, point.anchorNormalA[lane])},
                              {-ny, nx, armOf(b, point.anchorNormalB[lane])}, machine.tangent[p]);
        if (batch.hasSurfaceSpeed) rows.row[2 + p].fixedSpeed += static_cast<double>(batch.surfaceSpeed[lane]);
    }
    if (rows.rollingArm > 0 && machine.rollMass > 0) rows.row[4] = row({0, 0, -1}, {0, 0, 1}, machine.roll);
    return rows;
}

void storeRows(const MachineContact& machine, const MachineRows& rows, ContactGraph& graph,
               const ContactRecord& contact, const JointHalf& half) {
    ContactBatch& batch = graph.colours[contact.colour].batches[contact.slot / batchLanes];
    const std::size_t lane = contact.slot % batchLanes;
    for (std::size_t p = 0; p < 2; ++p) {
        PointLanes& point = batch.points[p];
        const MachineRow &normal = rows.row[p], &tangent = rows.row[2 + p];
        point.normalMass[lane] = machine.normalMass[p];
        point.tangentMass[lane] = machine.tangentMass[p];
        point.normalImpulse[lane] = static_cast<float>(normal.impulse);
        point.tangentImpulse[lane] = static_cast<float>(tangent.impulse);
        if (half.correct) continue;
        point.totalNormal[lane] += static_cast<float>(normal.given + normal.impulse);
        point.totalTangent[lane] += static_cast<float>(tangent.given + tangent.impulse);
        if (normal.given > 0 || normal.impulse > 0) batch.pushed[lane] = -1;
    }
    batch.rollMass[lane] = machine.rollMass;
    batch.rollImpulse[lane] = static_cast<float>(rows.row[4].impulse);
}

}  // namespace plumb
