#include "tests/exchange/programs/Measure.h"

#include <ode/ode.h>

#include <deque>

namespace rubble::exchange {
namespace {

/// What a convex geom of ODE refers to, and does not copy: planes, points, and polygons as counts and indices.
/// The origin of a geom must be inside, so it is the mean of the hull's vertices.
struct Convex {
    Vec3 origin;
    std::vector<dReal> planes;
    std::vector<dReal> points;
    std::vector<unsigned> polygons;

    explicit Convex(const rubble_pack::Hull& hull) {
        const double part = 1.0 / static_cast<double>(hull.vertices.size());
        for (const Vec3& v : hull.vertices) {
            origin = {origin.x + part * v.x, origin.y + part * v.y, origin.z + part * v.z};
        }
        for (const rubble_pack::Plane& plane : hull.planes) {
            const Vec3& n = plane.normal;
            const double offset = plane.offset - (n.x * origin.x + n.y * origin.y + n.z * origin.z);
            planes.insert(planes.end(), {dReal(n.x), dReal(n.y), dReal(n.z), dReal(offset)});
        }
        for (const Vec3& v : hull.vertices) {
            points.insert(points.end(), {dReal(v.x - origin.x), dReal(v.y - origin.y), dReal(v.z - origin.z)});
        }
        for (const std::vector<std::uint32_t>& face : hull.faces) {
            polygons.push_back(static_cast<unsigned>(face.size()));
            polygons.insert(polygons.end(), face.begin(), face.end());
        }
    }
};

Vec3 values(const dReal* v) { return {v[0], v[1], v[2]}; }

class World {
public:
    World(Vec3 gravity, const std::string& setting)
        : m_world(dWorldCreate()),
          m_space(dHashSpaceCreate(nullptr)),
          m_contacts(dJointGroupCreate(0)),
          m_isTuned(setting == "tuned") {
        dWorldSetGravity(m_world, dReal(gravity.x), dReal(gravity.y), dReal(gravity.z));
    }
    ~World() {
        dJointGroupDestroy(m_contacts);
        dSpaceDestroy(m_space);
        dWorldDestroy(m_world);
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    void addFloor(double height, double friction) {
        dCreatePlane(m_space, 0, 1, 0, dReal(height));
        m_friction = friction;
    }

    // The adapter: planes, vertices and faces of the pack are what ODE takes.
    void add(const Placed& placed, const rubble_pack::Material& material) {
        const rubble_pack::Body& body = *placed.body;
        const dBodyID added = dBodyCreate(m_world);
        const auto& i = body.inertia;
        dMass mass;
        dMassSetParameters(&mass, dReal(body.mass), 0, 0, 0, dReal(i[0][0]), dReal(i[1][1]), dReal(i[2][2]),
                           dReal(i[0][1]), dReal(i[0][2]), dReal(i[1][2]));
        dBodySetMass(added, &mass);
        const dQuaternion rotation = {dReal(placed.rotation.w), dReal(placed.rotation.x), dReal(placed.rotation.y),
                                      dReal(placed.rotation.z)};
        dBodySetPosition(added, dReal(placed.position.x), dReal(placed.position.y), dReal(placed.position.z));
        dBodySetQuaternion(added, rotation);
        for (const rubble_pack::Hull& hull : body.hulls) {
            Convex& convex = m_convexes.emplace_back(hull);
            const dGeomID geom = dCreateConvex(m_space, convex.planes.data(), static_cast<unsigned>(hull.planes.size()),
                                               convex.points.data(), static_cast<unsigned>(hull.vertices.size()),
                                               convex.polygons.data());
            dGeomSetBody(geom, added);
            dGeomSetOffsetPosition(geom, dReal(convex.origin.x), dReal(convex.origin.y), dReal(convex.origin.z));
        }
        m_friction = material.friction;
        m_bodies.push_back(added);
    }

    void step() {
        const int substeps = m_isTuned ? 4 : 1;
        for (int k = 0; k < substeps; ++k) stepBy(kStep / substeps);
    }
    Found found(std::size_t k) const {
        dMass mass;
        dBodyGetMass(m_bodies[k], &mass);
        const dReal* i = mass.I;  // rows of four
        return {mass.mass, {i[0], i[5], i[10], i[1], i[2], i[6]}, m_friction, position(k)};
    }
    Vec3 position(std::size_t k) const { return values(dBodyGetPosition(m_bodies[k])); }
    Vec3 velocity(std::size_t k) const { return values(dBodyGetLinearVel(m_bodies[k])); }

private:
    void stepBy(double seconds) {
        dSpaceCollide(m_space, this, &World::collide);
        dWorldQuickStep(m_world, dReal(seconds));
        dJointGroupEmpty(m_contacts);
    }
    /// The contacts of two geoms become joints for one step, as in ODE's examples.
    static void collide(void* data, dGeomID a, dGeomID b) {
        World& world = *static_cast<World*>(data);
        const dBodyID first = dGeomGetBody(a);
        const dBodyID second = dGeomGetBody(b);
        if (first == second) return;
        dContact contacts[8];
        const int count = dCollide(a, b, 8, &contacts[0].geom, sizeof(dContact));
        for (int k = 0; k < count; ++k) {
            // Hulls that touch exactly give contacts without a normal, which make positions infinite.
            const dReal* n = contacts[k].geom.normal;
            if (world.m_isTuned && n[0] * n[0] + n[1] * n[1] + n[2] * n[2] < dReal(0.5)) continue;
            contacts[k].surface.mode = dContactApprox1;
            contacts[k].surface.mu = dReal(world.m_friction);
            dJointAttach(dJointCreateContact(world.m_world, world.m_contacts, &contacts[k]), first, second);
        }
    }

    dWorldID m_world;
    dSpaceID m_space;
    dJointGroupID m_contacts;
    bool m_isTuned;
    double m_friction = 0.0;
    std::deque<Convex> m_convexes;
    std::vector<dBodyID> m_bodies;
};

}  // namespace
}  // namespace rubble::exchange

int main(int count, char** arguments) {
    using namespace rubble::exchange;
    const Task task = taskOf(count, arguments);
    dInitODE();
    const int exit = measure<World>(task);
    dCloseODE();
    return exit;
}
