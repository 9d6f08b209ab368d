#include "tests/exchange/programs/Measure.h"

#include <btBulletDynamicsCommon.h>

#include <memory>

namespace rubble::exchange {
namespace {

btVector3 bt(Vec3 v) { return {btScalar(v.x), btScalar(v.y), btScalar(v.z)}; }
Vec3 values(const btVector3& v) { return {v.x(), v.y(), v.z()}; }

/// Its principal axes: Bullet has a diagonal of inertia only, so a body has their frame.
btMatrix3x3 diagonal(const rubble_pack::Body& body, btMatrix3x3& axes) {
    const auto& i = body.inertia;
    const auto at = [&](int row, int column) { return btScalar(i[row][column]); };
    btMatrix3x3 inertia(at(0, 0), at(0, 1), at(0, 2), at(1, 0), at(1, 1), at(1, 2), at(2, 0), at(2, 1), at(2, 2));
    inertia.diagonalize(axes, btScalar(1e-7), 50);
    return inertia;
}

constexpr btScalar kMargin = btScalar(2e-5);  // m: the gap between hulls must be more than twice as wide

struct Body {
    std::vector<std::unique_ptr<btCollisionShape>> shapes;
    std::unique_ptr<btRigidBody> body;
    std::unique_ptr<btMotionState> motion;
    Vec3 moments;
};

/// With the setting "tuned", shapes have a margin of less than half of the inset, and the solver keeps stacks.
class World {
public:
    World(Vec3 gravity, const std::string& setting) : m_isTuned(setting == "tuned") {
        m_world.setGravity(bt(gravity));
        if (!m_isTuned) return;
        m_world.getSolverInfo().m_numIterations = 30;
        m_world.getSolverInfo().m_solverMode |=
            SOLVER_USE_2_FRICTION_DIRECTIONS | SOLVER_INTERLEAVE_CONTACT_AND_FRICTION_CONSTRAINTS;
    }
    ~World() {
        for (Body& body : m_bodies) m_world.removeRigidBody(body.body.get());
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    void addFloor(double height, double friction) {
        Body& floor = m_bodies.emplace_back();
        floor.shapes.push_back(std::make_unique<btBoxShape>(btVector3(10, 1, 10)));
        floor.body = std::make_unique<btRigidBody>(0, nullptr, floor.shapes.back().get());
        floor.body->getWorldTransform().setOrigin(btVector3(0, btScalar(height - 1.0), 0));
        floor.body->setFriction(btScalar(std::sqrt(friction)));
        m_world.addRigidBody(floor.body.get());
        m_floors = 1;
    }

    // The adapter. The friction of a pair is the product of both.
    void add(const Placed& placed, const rubble_pack::Material& material) {
        Body& added = m_bodies.emplace_back();
        btMatrix3x3 axes;
        const btMatrix3x3 inertia = diagonal(*placed.body, axes);
        added.moments = {inertia[0][0], inertia[1][1], inertia[2][2]};
        auto compound = std::make_unique<btCompoundShape>();
        for (const rubble_pack::Hull& hull : placed.body->hulls) {
            auto shape = std::make_unique<btConvexHullShape>();
            for (const Vec3& vertex : hull.vertices) shape->addPoint(bt(vertex), false);
            shape->recalcLocalAabb();
            if (m_isTuned) shape->setMargin(kMargin);
            compound->addChildShape(btTransform(axes.transpose()), shape.get());
            added.shapes.push_back(std::move(shape));
        }
        if (m_isTuned) compound->setMargin(kMargin);
        btRigidBody::btRigidBodyConstructionInfo info(btScalar(placed.body->mass), nullptr, compound.get(),
                                                      bt(added.moments));
        const Quaternion q = placed.rotation;
        const btQuaternion rotation(btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w));
        info.m_startWorldTransform = btTransform(btMatrix3x3(rotation) * axes, bt(placed.position));
        info.m_friction = btScalar(std::sqrt(material.friction));
        info.m_restitution = btScalar(material.restitution);
        added.body = std::make_unique<btRigidBody>(info);
        added.shapes.push_back(std::move(compound));
        m_world.addRigidBody(added.body.get());
    }
    void step() {
        const int substeps = m_isTuned ? 4 : 1;
        for (int k = 0; k < substeps; ++k) m_world.stepSimulation(btScalar(kStep / substeps), 0);
    }

    Found found(std::size_t k) const {
        const btRigidBody& body = bodyAt(k);
        const btVector3 inverse = body.getInvInertiaDiagLocal();
        return {1.0 / body.getInvMass(),
                {1.0 / inverse.x(), 1.0 / inverse.y(), 1.0 / inverse.z(), 0.0, 0.0, 0.0},
                body.getFriction() * body.getFriction(),
                position(k)};
    }
    Vec3 position(std::size_t k) const { return values(bodyAt(k).getWorldTransform().getOrigin()); }
    Vec3 velocity(std::size_t k) const { return values(bodyAt(k).getLinearVelocity()); }

private:
    const btRigidBody& bodyAt(std::size_t k) const { return *m_bodies[m_floors + k].body; }

    bool m_isTuned;
    std::size_t m_floors = 0;
    btDefaultCollisionConfiguration m_configuration;
    btCollisionDispatcher m_dispatcher{&m_configuration};
    btDbvtBroadphase m_broadphase;
    btSequentialImpulseConstraintSolver m_solver;
    btDiscreteDynamicsWorld m_world{&m_dispatcher, &m_broadphase, &m_solver, &m_configuration};
    std::vector<Body> m_bodies;
};

}  // namespace
}  // namespace rubble::exchange

int main(int count, char** arguments) {
    using namespace rubble::exchange;
    return measure<World>(taskOf(count, arguments));
}
