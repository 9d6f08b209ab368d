#include "bench/BulletBodies.h"

#include "core/geometry/hull/MassProperties.h"

#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <btBulletDynamicsCommon.h>

#include <cmath>

namespace rubble::bench {
namespace {

constexpr btScalar kMargin = 0.001f;  // m

btScalar scalar(double value) { return static_cast<btScalar>(value); }
btVector3 vector(Vec3 v) { return {scalar(v.x), scalar(v.y), scalar(v.z)}; }
Vec3 vector(const btVector3& v) { return {v.x(), v.y(), v.z()}; }
btQuaternion turn(const Quat& q) { return {scalar(q.x), scalar(q.y), scalar(q.z), scalar(q.w)}; }
btTransform placing(const Pose& pose) { return btTransform(turn(pose.orientation), vector(pose.position)); }

btScalar rootOfProduct(const btCollisionObject* first, const btCollisionObject* second) {
    return std::sqrt(first->getFriction() * second->getFriction());
}

/// The Bullet shape shared by all bodies of a scene's shape.
struct SharedShape {
    std::unique_ptr<btCollisionShape> shape;
    std::vector<std::unique_ptr<btConvexHullShape>> hulls;
    btTransform principal;  // of the scene's frame: the centre of mass, turned to the principal axes
    btVector3 inertia;      // at density 1
    double volume = 0.0;
};

std::unique_ptr<btConvexHullShape> hullAbout(const Polytope& polytope, const btTransform& frame) {
    auto hull = std::make_unique<btConvexHullShape>();
    const btTransform inverse = frame.inverse();
    for (const Vec3& corner : polytope.vertices) hull->addPoint(inverse * vector(corner), false);
    hull->recalcLocalAabb();
    hull->setMargin(kMargin);
    return hull;
}

/// The centre of mass and the principal axes.
btTransform principalFrame(const MassProperties& mass, btVector3& inertia) {
    btMatrix3x3 tensor;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) tensor[row][column] = scalar(mass.inertia[column][row]);
    }
    btMatrix3x3 axes = btMatrix3x3::getIdentity();
    tensor.diagonalize(axes, scalar(1e-6), 40);
    inertia = {tensor[0][0], tensor[1][1], tensor[2][2]};
    return btTransform(axes, vector(mass.centre));
}

SharedShape sharedShape(const std::vector<Polytope>& hulls) {
    std::vector<MassProperties> masses;
    for (const Polytope& hull : hulls) masses.push_back(massOf(hull));
    const MassProperties mass = combined(masses);
    SharedShape shared;
    shared.volume = mass.volume;
    shared.principal = principalFrame(mass, shared.inertia);
    for (const Polytope& hull : hulls) shared.hulls.push_back(hullAbout(hull, shared.principal));
    if (hulls.size() == 1) return shared;
    auto compound = std::make_unique<btCompoundShape>();
    for (const auto& hull : shared.hulls) compound->addChildShape(btTransform::getIdentity(), hull.get());
    shared.shape = std::move(compound);
    return shared;
}

}  // namespace

struct BulletBodies::Data {
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher{&configuration};
    btDbvtBroadphase broadPhase;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world{&dispatcher, &broadPhase, &solver, &configuration};
    std::vector<SharedShape> shapes;
    std::vector<std::uint32_t> shapeOf;  // of each body
    std::vector<std::unique_ptr<btRigidBody>> bodies;

    void add(const SceneBody& body) {
        SharedShape& shared = shapes[body.shape];
        btCollisionShape* shape = shared.shape ? shared.shape.get() : shared.hulls.front().get();
        const double mass = body.kind == BodyKind::Dynamic ? body.density * shared.volume : 0.0;
        btRigidBody::btRigidBodyConstructionInfo how(
            scalar(mass), nullptr, shape, mass > 0.0 ? shared.inertia * scalar(body.density) : btVector3(0, 0, 0));
        how.m_startWorldTransform = placing(body.pose) * shared.principal;
        how.m_friction = scalar(body.friction);
        how.m_restitution = scalar(body.restitution);
        bodies.push_back(std::make_unique<btRigidBody>(how));
        bodies.back()->setLinearVelocity(vector(body.velocity));
        bodies.back()->setAngularVelocity(vector(body.angularVelocity));
        bodies.back()->setActivationState(DISABLE_DEACTIVATION);
        shapeOf.push_back(body.shape);
        world.addRigidBody(bodies.back().get());
    }
};

BulletBodies::BulletBodies(const BodyScene& scene) : m_data(std::make_unique<Data>()) {
    gCalculateCombinedFrictionCallback = rootOfProduct;
    m_data->world.setGravity(vector(scene.gravity));
    for (const std::vector<Polytope>& hulls : scene.shapes) m_data->shapes.push_back(sharedShape(hulls));
    for (const SceneBody& body : scene.bodies) m_data->add(body);
}

BulletBodies::~BulletBodies() {
    for (const auto& body : m_data->bodies) m_data->world.removeRigidBody(body.get());
}

void BulletBodies::step(double dt) { m_data->world.stepSimulation(scalar(dt), 0); }

std::vector<Pose> BulletBodies::poses() const {
    std::vector<Pose> poses;
    for (std::size_t k = 0; k < m_data->bodies.size(); ++k) {
        const btTransform frame =
            m_data->bodies[k]->getWorldTransform() * m_data->shapes[m_data->shapeOf[k]].principal.inverse();
        const btQuaternion q = frame.getRotation();
        poses.push_back({vector(frame.getOrigin()), Quat(q.w(), q.x(), q.y(), q.z())});
    }
    return poses;
}

std::size_t BulletBodies::contactPoints() const {
    std::size_t points = 0;
    for (int k = 0; k < m_data->dispatcher.getNumManifolds(); ++k) {
        points += static_cast<std::size_t>(m_data->dispatcher.getManifoldByIndexInternal(k)->getNumContacts());
    }
    return points;
}

}  // namespace rubble::bench
