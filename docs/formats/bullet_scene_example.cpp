// Stands a bonded scene in Bullet, fires one of its throws and prints what breaks: bullet_scene_example FOLDER [THROW]
#include "rubble_pack.hpp"

#include <btBulletDynamicsCommon.h>
#include <iostream>
#include <list>

using namespace rubble_pack;

constexpr double kRate = 960.0;  // Hz: Bullet knows a contact only once a fast impactor overlaps
btVector3 bt(Vec3 v) { return {btScalar(v.x), btScalar(v.y), btScalar(v.z)}; }
Vec3 vec(const btVector3& v) { return {double(v.x()), double(v.y()), double(v.z())}; }

/// What hangs together of an instance; `body` has the frame of the asset moved by `centre`, that of mass.
struct Part {
    std::size_t instance = 0;
    std::vector<std::uint32_t> fragments;  // of the pack, ascending
    bool isFixed = false;
    btVector3 centre{0, 0, 0};
    btRigidBody* body = nullptr;
};

struct Play {
    Scene scene;
    std::vector<Pack> packs;
    SceneStructures all;
    std::vector<std::vector<Damage>> damages;
    std::list<Part> parts;
    std::map<std::size_t, double> collapses;  // by instance: when what has no support comes off, s
    btDiscreteDynamicsWorld* world = nullptr;

    const Pack& packOf(std::size_t instance) const { return packs[scene.instances[instance].pack]; }
    /// Adds a body at the pose of the asset's frame; nothing is freed: the program ends first.
    void add(Part part, const btTransform& pose, const Part* whole) {
        const Pack& pack = packOf(part.instance);
        const IslandMass mass = massOf(pack, part.fragments);
        part.centre = part.isFixed ? btVector3(0, 0, 0) : bt(mass.centre);
        auto* shape = new btCompoundShape;
        std::vector<const Body*> solids;
        for (const std::uint32_t k : part.fragments) solids.push_back(&pack.fragments[k]);
        const bool isIntact = whole == nullptr && solids.size() == all.structures[part.instance].fragments.size();
        if (isIntact) solids = {&pack.whole};
        for (const Body* solid : solids) {
            for (const Hull& hull : solid->hulls) {
                auto* convex = new btConvexHullShape;
                for (const Vec3& vertex : hull.vertices) convex->addPoint(bt(vertex));
                convex->setMargin(btScalar(2e-5));
                const btVector3 place = bt(solid->offset) - part.centre;
                shape->addChildShape(btTransform(btQuaternion::getIdentity(), place), convex);
            }
        }
        const btVector3 moments(btScalar(mass.inertia[0][0]), btScalar(mass.inertia[1][1]),
                                btScalar(mass.inertia[2][2]));
        part.body = new btRigidBody(btScalar(part.isFixed ? 0.0 : mass.mass), nullptr, shape, moments);
        part.body->setWorldTransform(pose * btTransform(btQuaternion::getIdentity(), part.centre));
        part.body->setFriction(btSqrt(btScalar(pack.material.friction)));
        if (whole != nullptr && !part.isFixed) {
            const btVector3 arm = part.body->getCenterOfMassPosition() - whole->body->getCenterOfMassPosition();
            part.body->setLinearVelocity(whole->body->getVelocityInLocalPoint(arm));
            part.body->setAngularVelocity(whole->body->getAngularVelocity());
        }
        parts.push_back(part);
        world->addRigidBody(part.body);
        parts.back().body->setUserPointer(&parts.back());
    }
    static btTransform frameOf(const Part& part) {
        return part.body->getWorldTransform() * btTransform(btQuaternion::getIdentity(), -part.centre);
    }
    /// Replaces parts by the islands that they are now, and plans when what has lost its support comes off.
    void split(double time) {
        breakMortar(all, damages);
        std::vector<std::vector<std::uint32_t>> held(scene.instances.size());
        for (auto part = parts.begin(); part != parts.end();) {
            const std::vector<Island> islands =
                islandsOf(all.structures[part->instance], damages[part->instance], part->fragments);
            if (islands.size() > 1 || islands[0].isAnchored != part->isFixed) {
                for (const Island& island : islands)
                    add({part->instance, island.fragments, island.isAnchored}, frameOf(*part), &*part);
                world->removeRigidBody(part->body);
                part = parts.erase(part);
                continue;
            }
            if (part->isFixed) {
                auto& own = held[part->instance];
                own.insert(own.end(), part->fragments.begin(), part->fragments.end());
                std::sort(own.begin(), own.end());
            }
            ++part;
        }
        const auto lost = unsupported(all, damages, held);
        for (std::size_t k = 0; k < lost.size(); ++k) {
            if (lost[k].empty()) continue;
            const double when = collapses.try_emplace(k, time + packOf(k).bonding->collapseDelay).first->second;
            if (when > time) continue;
            collapses.erase(k);
            breakOff(all.structures[k], lost[k], damages[k], breakingLevel(all.structures[k], damages[k], held[k]));
            return split(time);
        }
    }
    /// Hits a part where a impactor touches it first, and within 5 mm behind, with J from before the step.
    void strike(const btPersistentManifold& contact, Part& part, btRigidBody& impactor, const btVector3& before,
                int step) {
        const bool isFirst = contact.getBody0() == part.body;
        struct Touch {
            btVector3 at, n;  // n leads to the impactor
            btScalar distance, speed;
        };
        std::map<int, Touch> touches;  // by hull: the nearest of each
        btScalar first = 1e9f, hardest = 0;
        for (int k = 0; k < contact.getNumContacts(); ++k) {
            const btManifoldPoint& point = contact.getContactPoint(k);
            const btVector3 n = isFirst ? -point.m_normalWorldOnB : point.m_normalWorldOnB;
            const btScalar speed = -(before - part.body->getLinearVelocity()).dot(n);
            if (speed < btScalar(0.5) || point.getDistance() > speed / btScalar(kRate)) continue;
            const Touch touch{isFirst ? point.m_positionWorldOnA : point.m_positionWorldOnB, n, point.getDistance(),
                              speed};
            Touch& known = touches.try_emplace(isFirst ? point.m_index0 : point.m_index1, touch).first->second;
            if (touch.distance < known.distance) known = touch;
            first = btMin(first, touch.distance);
        }
        Hit hit;
        btVector3 normal(0, 0, 0);
        for (const auto& [hull, touch] : touches) {
            if (touch.distance > first + btScalar(0.005)) continue;
            const btScalar inverse = impactor.computeImpulseDenominator(touch.at, touch.n) +
                                     part.body->computeImpulseDenominator(touch.at, touch.n);
            const btScalar impact = btScalar(packOf(part.instance).impactOf(touch.speed, 1.0 / inverse, 0.0));
            if (impact > hardest) hardest = impact, normal = touch.n;
            hit.points.push_back(vec(frameOf(part).invXform(touch.at)));
        }
        hit.impulse = double(hardest);
        if (hit.points.empty()) return;
        const HitOutcome outcome = applyHit(all.structures[part.instance], *packOf(part.instance).bonding, hit,
                                            part.fragments, damages[part.instance]);
        if (outcome.broken.empty()) return;
        std::cout << "{\"time\":" << step / kRate << ",\"instance\":" << scene.instances[part.instance].id
                  << ",\"taken\":" << outcome.taken << ",\"broken\":[" << outcome.broken[0];
        for (std::size_t k = 1; k < outcome.broken.size(); ++k) std::cout << ',' << outcome.broken[k];
        std::cout << "],\"islands\":[";
        const char* between = "";
        for (const Island& island : islandsOf(all.structures[part.instance], damages[part.instance], part.fragments)) {
            if (island.isAnchored) continue;
            for (std::size_t k = 0; k < island.fragments.size(); ++k)
                std::cout << (k == 0 ? between : ",") << (k == 0 ? "[" : "") << island.fragments[k];
            std::cout << ']';
            between = ",";
        }
        std::cout << "]}\n";
        impactor.setLinearVelocity(before + normal * btScalar(outcome.taken) *
                                                impactor.getInvMass());  // fragments take the rest
    }
    btRigidBody* fire(const SceneShot& shot) {
        const Vec3 path = detail::minus(shot.to, shot.from), z = detail::times(path, -1.0 / detail::length(path));
        btVector3 x(btScalar(z.z), 0, btScalar(-z.x));
        x = x.fuzzyZero() ? btVector3(1, 0, 0) : x.normalized();
        const btVector3 y = bt(z).cross(x), half = bt(shot.size) / 2;
        btCollisionShape* shape = new btBoxShape(half);
        if (shot.projectile == Projectile::Ball) shape = new btSphereShape(half.x());
        btVector3 moments;
        shape->calculateLocalInertia(btScalar(shot.mass), moments);
        auto* body = new btRigidBody(btScalar(shot.mass), nullptr, shape, moments);
        const btVector3 back = bt(z);
        const btMatrix3x3 axes(x.x(), y.x(), back.x(), x.y(), y.y(), back.y(), x.z(), y.z(), back.z());
        body->setWorldTransform(btTransform(axes, bt(shot.from)));
        body->setLinearVelocity(back * btScalar(-shot.speed));
        body->setFriction(btSqrt(btScalar(0.6)));
        world->addRigidBody(body);
        return body;
    }
};

int main(int count, char** arguments) {
    Play play;
    const std::string folder = count > 1 ? arguments[1] : "";
    std::string fault = "usage: bullet_scene_example FOLDER [THROW] [SECONDS]";
    if (count < 2 || !loadScene(folder + "/scene.json", play.scene, fault)) return std::cerr << fault << '\n', 2;
    play.packs.resize(play.scene.packs.size());
    for (std::size_t k = 0; k < play.packs.size(); ++k) {
        if (!load(folder + "/" + play.scene.packs[k].folder + "/pack.json", play.packs[k], fault))
            return std::cerr << fault << '\n', 1;
    }
    if (!structuresOf(play.scene, play.packs, play.all, fault)) return std::cerr << fault << '\n', 1;
    play.damages = intactDamages(play.all);
    gContactBreakingThreshold = 1;  // of the size of a shape: contacts are known before a fast impactor touches
    btDefaultCollisionConfiguration configuration;
    btCollisionDispatcher dispatcher(&configuration);
    btDbvtBroadphase pairs;
    btSequentialImpulseConstraintSolver solver;
    btDiscreteDynamicsWorld world(&dispatcher, &pairs, &solver, &configuration);
    world.setGravity(bt(play.scene.gravity));
    play.world = &world;
    breakMortar(play.all, play.damages);
    for (std::size_t k = 0; k < play.scene.instances.size(); ++k) {
        const SceneInstance& instance = play.scene.instances[k];
        const Quaternion& q = instance.rotation;
        const btTransform pose({btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w)}, bt(instance.position));
        for (const Island& island :
             islandsOf(play.all.structures[k], play.damages[k], play.all.structures[k].fragments))
            play.add({k, island.fragments, island.isAnchored}, pose, nullptr);
    }
    auto* ground = new btRigidBody(
        0, nullptr, new btStaticPlaneShape({0, 1, 0}, btScalar(play.scene.ground ? play.scene.ground->height : 0.0)));
    if (play.scene.ground) world.addRigidBody(ground);
    const auto shot = std::find_if(play.scene.shots.begin(), play.scene.shots.end(), [&](const SceneShot& one) {
        return count > 2 && one.name == arguments[2] && one.kind == SceneShotKind::Throw;
    });
    btRigidBody* impactor = nullptr;
    for (int step = 1; step <= kRate * (count > 3 ? std::atof(arguments[3]) : 5.0); ++step) {
        if (shot != play.scene.shots.end() && step == std::ceil(shot->time * kRate) + 1) impactor = play.fire(*shot);
        const btVector3 before = impactor != nullptr ? impactor->getLinearVelocity() : btVector3(0, 0, 0);
        world.stepSimulation(btScalar(1.0 / kRate), 0);
        for (int k = 0; k < dispatcher.getNumManifolds() && impactor != nullptr; ++k) {
            const btPersistentManifold& contact = *dispatcher.getManifoldByIndexInternal(k);
            if (contact.getBody0() != impactor && contact.getBody1() != impactor) continue;
            const btCollisionObject* other = contact.getBody0() == impactor ? contact.getBody1() : contact.getBody0();
            if (auto* part = static_cast<Part*>(other->getUserPointer()))
                play.strike(contact, *part, *impactor, before, step);
        }
        play.split(step / kRate);
    }
    const auto isFree = [](const Part& part) { return !part.isFixed; };
    std::cout << "{\"bodies\":" << play.parts.size()
              << ",\"free\":" << std::count_if(play.parts.begin(), play.parts.end(), isFree) << "}\n";
}
