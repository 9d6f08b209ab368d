// Stands the asset of a pack in Bullet, throws a ball at it and breaks it: bullet_example pack.json SPEED
#include "rubble_pack.hpp"

#include <btBulletDynamicsCommon.h>
#include <iostream>

btVector3 bt(rubble_pack::Vec3 v) { return {btScalar(v.x), btScalar(v.y), btScalar(v.z)}; }
/// A body of the pack, at the pose of its frame. Bullet's frame has the principal axes: inertia is a diagonal there.
btRigidBody* makeBody(const rubble_pack::Pack& pack, const rubble_pack::Body& from, const btTransform& pose) {
    const rubble_pack::Quaternion& q = from.principal.rotation;
    const btTransform axes({btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w)});
    auto* shape = new btCompoundShape;  // nothing is freed: the program ends first
    for (const rubble_pack::Hull& hull : from.hulls) {
        auto* convex = new btConvexHullShape;
        for (const rubble_pack::Vec3& vertex : hull.vertices) convex->addPoint(bt(vertex));
        convex->setMargin(btScalar(2e-5));  // on each side; the gap between hulls is wider than both
        shape->addChildShape(axes.inverse(), convex);
    }
    auto* body = new btRigidBody(btScalar(from.mass), nullptr, shape, bt(from.principal.moments));
    body->setWorldTransform(pose * axes);
    body->setFriction(btSqrt(btScalar(pack.material.friction)));  // Bullet multiplies those of a pair
    return body;
}

/// J = (1 + e) vn m; here without restitution, and nothing rotates. v: of b from a before the step.
btScalar impactOf(const btPersistentManifold& contact, const btRigidBody& a, const btRigidBody& b, const btVector3& v) {
    if (contact.getNumContacts() == 0 || contact.getContactPoint(0).getAppliedImpulse() == 0) return 0;
    const btManifoldPoint& point = contact.getContactPoint(0);
    const btVector3& normal = point.m_normalWorldOnB;
    const btScalar speed = btFabs(normal.dot(v));
    const btScalar inverse = a.computeImpulseDenominator(point.m_positionWorldOnB, normal) + b.getInvMass();
    return speed > btScalar(0.5) ? speed / inverse : 0;
}

int main(int count, char** arguments) {
    rubble_pack::Pack pack;
    std::string fault = "usage: bullet_example pack.json SPEED";
    if (count != 3 || !rubble_pack::load(arguments[1], pack, fault)) return std::cerr << fault << '\n', 2;
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &pairs, &solver, &configuration);
    world.getSolverInfo().m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;  // with one, stacks slide apart
    const btTransform start(btQuaternion::getIdentity(), bt(pack.whole.offset));
    btRigidBody* whole = makeBody(pack, pack.whole, start);
    const btTransform packFromWhole = whole->getWorldTransform().inverse() * start;
    const auto low = btScalar(pack.whole.offset.y + pack.whole.bounds.min.y);
    world.addRigidBody(new btRigidBody(0, nullptr, new btStaticPlaneShape({0, 1, 0}, low)));
    auto* ball = new btRigidBody(100, nullptr, new btSphereShape(btScalar(0.2)), {1.6f, 1.6f, 1.6f});
    ball->getWorldTransform().setOrigin(start.getOrigin() + btVector3(0, 0, 1));
    ball->setLinearVelocity({0, 0, btScalar(-std::stod(arguments[2]))});
    for (btRigidBody* body : {whole, ball}) world.addRigidBody(body);
    std::vector<std::pair<btRigidBody*, btVector3>> fragments;  // and where they were
    for (int step = 0; step < 480; ++step) {
        const btVector3 velocity = ball->getLinearVelocity() - whole->getLinearVelocity();
        world.stepSimulation(btScalar(1.0 / 240.0), 0);
        btScalar impact = 0;
        for (int k = 0; k < dispatcher.getNumManifolds(); ++k) {
            const btPersistentManifold& contact = *dispatcher.getManifoldByIndexInternal(k);
            const bool isOfBall = contact.getBody0() == ball || contact.getBody1() == ball;
            if (isOfBall) impact = btMax(impact, impactOf(contact, *whole, *ball, velocity));
        }
        if (!fragments.empty() || impact < pack.threshold) continue;
        std::cout << "broke at " << impact << " N·s, threshold " << pack.threshold << ", fragments moved\n";
        world.removeRigidBody(whole);
        const btTransform pose = whole->getWorldTransform() * packFromWhole;
        for (const std::uint32_t k : pack.fragmentsOf(rubble_pack::kNone)) {
            const btVector3 arm = pose.getBasis() * (bt(pack.fragments[k].offset) - bt(pack.whole.offset));
            btRigidBody* body = makeBody(pack, pack.fragments[k], btTransform(pose.getBasis(), pose.getOrigin() + arm));
            body->setLinearVelocity(whole->getLinearVelocity() + whole->getAngularVelocity().cross(arm));
            body->setAngularVelocity(whole->getAngularVelocity());
            world.addRigidBody(body);
            fragments.push_back({body, body->getCenterOfMassPosition()});
        }
    }
    for (const auto& [body, from] : fragments) std::cout << from.distance(body->getCenterOfMassPosition()) << " m\n";
}
