// SPDX-License-Identifier: MIT
#include <plumb/dynamics/detail/contact_solver.h>

#include <algorithm>

namespace plumb {

namespace {

/// One lane's two bodies, on the way between memory and the formulas.
struct Couple {
    SolverVelocity a, b;
    float nx, ny;
};

Couple load(const ContactBatch& batch, std::size_t lane, const std::vector<SolverVelocity>& velocity) {
    return {velocity[batch.bodyA[lane]], velocity[batch.bodyB[lane]], batch.normalX[lane], batch.normalY[lane]};
}

void store(const ContactBatch& batch, std::size_t lane, const Couple& c, std::vector<SolverVelocity>& velocity) {
    velocity[batch.bodyA[lane]] = c.a;
    velocity[batch.bodyB[lane]] = c.b;
}

float normalSpeed(const Couple& c, const PointLanes& p, std::size_t lane) {
    return (c.nx * (c.b.x - c.a.x) + c.ny * (c.b.y - c.a.y)) +
           (p.anchorTangentA[lane] * c.a.w - p.anchorTangentB[lane] * c.b.w);
}

float tangentSpeed(const Couple& c, const PointLanes& p, std::size_t lane) {
    return (c.nx * (c.b.y - c.a.y) - c.ny * (c.b.x - c.a.x)) +
           (p.anchorNormalB[lane] * c.b.w - p.anchorNormalA[lane] * c.a.w);
}

void pushNormal(Couple& c, const PointLanes& p, std::size_t lane, float impulse) {
    const float ja = c.a.inverseMass * impulse;
    const float jb = c.b.inverseMass * impulse;
    c.a.x -= ja * c.nx;
    c.a.y -= ja * c.ny;
    c.a.w += ja * p.anchorTangentA[lane];
    c.b.x += jb * c.nx;
    c.b.y += jb * c.ny;
    c.b.w -= jb * p.anchorTangentB[lane];
}

void pushTangent(Couple& c, const PointLanes& p, std::size_t lane, float impulse) {
    const float ja = c.a.inverseMass * impulse;
    const float jb = c.b.inverseMass * impulse;
    c.a.x += ja * c.ny;
    c.a.y -= ja * c.nx;
    c.a.w -= ja * p.anchorNormalA[lane];
    c.b.x -= jb * c.ny;
    c.b.y += jb * c.nx;
    c.b.w += jb * p.anchorNormalB[lane];
}

/// s = s0 + n.(dB - dA) + (n.r)(c - 1) - (t.r) sin for B, less the same for A, r to the core: as a disc rolls, its
/// lowest point is ever another one, and only its centre is to be followed.
float separationNow(const ContactBatch& batch, const PointLanes& p, std::size_t lane,
                    const std::vector<SolverDisplacement>& displacement) {
    const SolverDisplacement& a = displacement[batch.bodyA[lane]];
    const SolverDisplacement& b = displacement[batch.bodyB[lane]];
    const float shift = batch.normalX[lane] * (b.x - a.x) + batch.normalY[lane] * (b.y - a.y);
    const float coreA = p.anchorNormalA[lane] - batch.roundA[lane];
    const float coreB = p.anchorNormalB[lane] + batch.roundB[lane];
    const float turnA = coreA * a.cosMinus1 - p.anchorTangentA[lane] * a.sin;
    const float turnB = coreB * b.cosMinus1 - p.anchorTangentB[lane] * b.sin;
    return p.startSeparation[lane] + (shift + (turnB - turnA));
}

/// before: what the first half of the sub-step has given, and the second may take back; 0 in the first half.
void solveNormal(Couple& c, PointLanes& p, std::size_t lane, float before, float bias, const Softness& soft) {
    const float old = p.normalImpulse[lane];
    const float change =
        -p.normalMass[lane] * soft.massScale * (normalSpeed(c, p, lane) + bias) - soft.impulseScale * old;
    const float now = std::max(old + change, -before);
    p.normalImpulse[lane] = now;
    pushNormal(c, p, lane, now - old);
}

/// Both halves together stay within the cone: mu times the normal impulse of both.
void solveFriction(Couple& c, PointLanes& p, std::size_t lane, float friction, float normalBefore, float before) {
    const float old = p.tangentImpulse[lane];
    const float limit = friction * (normalBefore + p.normalImpulse[lane]);
    const float wanted = old - p.tangentMass[lane] * tangentSpeed(c, p, lane);
    const float now = std::clamp(wanted, -limit - before, limit - before);
    p.tangentImpulse[lane] = now;
    pushTangent(c, p, lane, now - old);
}

/// Friction comes second, so that even a contact's first sub-step has its normal force to go by.
template <class SolvePoint>
void sweep(std::span<ContactBatch> batches, BodyStore& bodies, SolvePoint&& solvePoint) {
    for (ContactBatch& batch : batches) {
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            if (batch.bodyA[lane] == batch.bodyB[lane]) continue;  // an empty lane
            Couple couple = load(batch, lane, bodies.velocity);
            for (PointLanes& p : batch.points) solvePoint(couple, batch, p, lane);
            for (PointLanes& p : batch.points) {
                solveFriction(couple, p, lane, batch.friction[lane], p.solvedNormal[lane], p.solvedTangent[lane]);
                p.totalNormal[lane] += p.normalImpulse[lane];
                p.totalTangent[lane] += p.tangentImpulse[lane];
            }
            store(batch, lane, couple, bodies.velocity);
        }
    }
}

}  // namespace

void gatherWarmStart(std::span<const ContactBatch> batches, BodyStore& bodies) {
    for (const ContactBatch& batch : batches) {
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            if (batch.bodyA[lane] == batch.bodyB[lane]) continue;
            Couple couple = load(batch, lane, bodies.warm);
            couple.a.inverseMass = bodies.velocity[batch.bodyA[lane]].inverseMass;
            couple.b.inverseMass = bodies.velocity[batch.bodyB[lane]].inverseMass;
            for (const PointLanes& p : batch.points) {
                pushNormal(couple, p, lane, p.normalImpulse[lane]);
                pushTangent(couple, p, lane, p.tangentImpulse[lane]);
            }
            store(batch, lane, couple, bodies.warm);
        }
    }
}

void solveContacts(std::span<ContactBatch> batches, BodyStore& bodies, const ContactPass& pass) {
    sweep(batches, bodies, [&pass](Couple& couple, const ContactBatch&, PointLanes& p, std::size_t lane) {
        p.solvedNormal[lane] = p.solvedTangent[lane] = 0;
        const float s = p.separation[lane];
        if (s > 0)
            solveNormal(couple, p, lane, 0, s * pass.inverseStep, {});
        else
            solveNormal(couple, p, lane, 0, std::max(pass.soft.biasRate * s, -pass.pushSpeed), pass.soft);
    });
}

void relaxContacts(std::span<ContactBatch> batches, BodyStore& bodies, const ContactPass& pass) {
    sweep(batches, bodies, [&](Couple& couple, const ContactBatch& batch, PointLanes& p, std::size_t lane) {
        // The impulses are still those of the solve, given a second time as a first guess.
        p.solvedNormal[lane] = p.normalImpulse[lane];
        p.solvedTangent[lane] = p.tangentImpulse[lane];
        p.separation[lane] = separationNow(batch, p, lane, bodies.displacement);
        const float bias = std::max(p.separation[lane], 0.0f) * pass.inverseStep;
        solveNormal(couple, p, lane, p.solvedNormal[lane], bias, {});
    });
}

void bounceContacts(std::span<ContactBatch> batches, BodyStore& bodies) {
    for (ContactBatch& batch : batches) {
        for (std::size_t lane = 0; lane < batchLanes; ++lane) {
            if (batch.bodyA[lane] == batch.bodyB[lane]) continue;
            Couple couple = load(batch, lane, bodies.velocity);
            for (PointLanes& p : batch.points) {
                if (p.bounceSpeed[lane] == 0 || p.totalNormal[lane] == 0) continue;
                const float old = p.totalNormal[lane];
                const float change = -p.normalMass[lane] * (normalSpeed(couple, p, lane) - p.bounceSpeed[lane]);
                p.totalNormal[lane] = std::max(old + change, 0.0f);
                pushNormal(couple, p, lane, p.totalNormal[lane] - old);
            }
            store(batch, lane, couple, bodies.velocity);
        }
    }
}

}  // namespace plumb
