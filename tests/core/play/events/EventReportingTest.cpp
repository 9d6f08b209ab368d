#include "core/play/events/EventReporting.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Arcade.h"
#include "tests/support/asset/Dam.h"
#include "tests/support/asset/House.h"
#include "tests/support/asset/Pane.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/asset/WallWithOpenings.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/Sessions.h"

#include <set>

using namespace rubble;
using test::addInput;
using test::energyOf;
using test::floatingBlock;
using test::sessionOf;

namespace {

/// A block that falls from its height onto the ground.
Project fallingBlock() {
    Project project = floatingBlock(12);
    project.gravity = {0.0, -9.81, 0.0};
    return project;
}

/// Blocks on each other, the lowest on the ground.
Project stack() {
    Project project = fallingBlock();
    const Id block = project.assets[0].id;
    project.instances[0].pose.position.y = 0.5;
    for (int k = 1; k < 5; ++k) {
        test::addInstance(project, block, "block " + std::to_string(k), {.position = {0.05 * k, 0.5 + k, 0.0}});
    }
    return project;
}

struct Scene {
    std::string name;
    std::shared_ptr<const PlayScene> scene;
};

const std::vector<Scene>& scenes() {
    static const std::vector<Scene> all = [] {
        std::vector<Scene> made;
        const auto add = [&](const std::string& name, Project project) {
            // What is held in place gains potential energy when it breaks, and what is removed takes its energy along.
            for (Instance& instance : project.instances) {
                instance.isFixed = false;
                instance.isAnchored = false;
            }
            project.debris = {};
            made.push_back({name, test::playSceneOf(project)});
        };
        add("block", fallingBlock());
        add("stack", stack());
        add("house", test::house());
        add("pane", test::pane());
        add("wall", test::wallWithOpenings());
        add("bonded wall", test::bondedWall(150));
        made.push_back({"anchored wall", test::playSceneOf(test::bondedWall(150))});
        made.push_back({"arcade", test::playSceneOf(test::arcade())});
        made.push_back({"dam", test::playSceneOf(test::dam())});
        return made;
    }();
    return all;
}

/// A ball or box that is thrown at the scene from somewhere around it.
Throw randomThrow(Random& random) {
    const double angle = random.between(0.0, 6.28);
    const Vec3 from{9.0 * std::sin(angle), random.between(1.0, 5.0), 9.0 * std::cos(angle)};
    return {.size = Vec3(random.between(0.2, 0.6)),
            .mass = random.between(5.0, 400.0),
            .from = from,
            .to = {random.between(-1.0, 1.0), random.between(0.3, 3.0), random.between(-1.0, 1.0)},
            .speed = random.between(5.0, 40.0)};
}

/// What free flight loses by the length of the sub-steps, J: m g² h dt / 2 for each body that touches nothing.
double lostInFlight(const Session& session) {
    std::set<BodyId> touching;
    for (const ContactPoint& point : session.world().contactPoints()) {
        if (point.impulse > 0.0) touching.insert({point.first, point.second});
    }
    const double g = glm::length(session.world().gravity()), dt = session.stepLength();
    double lost = 0.0;
    for (const PlayBody& body : session.bodies()) {
        if (session.world().kind(body.body) != BodyKind::Dynamic || touching.contains(body.body)) continue;
        lost += 0.5 * session.world().mass(body.body) * g * g * (dt / 4.0) * dt;
    }
    return lost;
}

/// The potential energy of what came off held bodies in the last step, which have none as long as they are held, J.
double gainedByDetaching(const Session& session) {
    double gained = 0.0;
    for (const PlaySplit& split : session.events().splits) {
        if (!split.body.isHeld) continue;
        for (const std::uint32_t number : split.freed) {
            const BodyId body = session.body(number)->body;
            gained -=
                session.world().mass(body) * glm::dot(session.world().gravity(), session.world().state(body).centre);
        }
    }
    return gained;
}

/// The sum of the sizes of all energies in a report, J.
double sizeOf(const EventReport& report) {
    double sum = std::abs(report.restEnergy);
    for (const EventRecord& record : report.records) sum += std::abs(record.energy);
    for (const OmittedEvents& one : report.omitted) sum += std::abs(one.energy);
    return sum;
}

/// Why a report is not as promised; empty if it is.
std::string faultOf(const EventReport& report, std::size_t most) {
    if (report.records.size() > most) return "too many records";
    const auto key = [](const EventRecord& one) { return std::tuple(one.kind, one.body, one.other); };
    if (!std::ranges::is_sorted(report.records, {}, key)) return "records not in order";
    for (std::size_t kind = 0; kind < kEventKinds; ++kind) {
        const bool isReported = std::ranges::any_of(
            report.records, [&](const EventRecord& one) { return static_cast<std::size_t>(one.kind) == kind; });
        const bool isImpact = kind == static_cast<std::size_t>(EventKind::Impact);
        if (!isImpact && !isReported && report.omitted[kind].count > 0) return "a kind that happened is not reported";
    }
    return {};
}

}  // namespace

class EventReportingTest : public QObject {
    Q_OBJECT
private slots:
    /// From 4.5 m, at 9.4 m/s, it breaks; its fragments come to rest one by one.
    void fallBreakAndRest() {
        Project project = fallingBlock();
        project.events.maxRecords = 1000;
        Session session = sessionOf(project);
        std::array<std::uint32_t, kEventKinds> counts{};
        for (int step = 0; step < 400; ++step) {
            session.step();
            for (const EventRecord& record : session.events().report.records) {
                ++counts[static_cast<std::size_t>(record.kind)];
                QCOMPARE(record.step, session.stepsDone());
                QCOMPARE(record.instance, session.scene().project.instances[0].id);
                if (record.kind == EventKind::Broken) {
                    QCOMPARE(record.body, 1u);
                    QCOMPARE(record.other, 0u);  // the ground
                    QCOMPARE(record.count, 12u);
                    QVERIFY(record.fragment.empty());
                    QVERIFY(std::abs(record.mass - 500.0) < 0.1);
                    QVERIFY(std::abs(record.speed - 9.4) < 0.1);
                    QVERIFY(record.normal.y > 0.99);
                    QVERIFY(record.area > 1.0 && record.area < 20.0);
                    QVERIFY(record.box.min.y < 0.1 && record.box.max.y > 0.9);
                } else {
                    QVERIFY(!record.fragment.empty() && record.body > 1);
                }
            }
        }
        QCOMPARE(counts[static_cast<std::size_t>(EventKind::Broken)], 1u);
        QCOMPARE(counts[static_cast<std::size_t>(EventKind::Settled)], 12u);
        QVERIFY(counts[static_cast<std::size_t>(EventKind::Impact)] > 5);
    }
    void whatStandsSaysNothing() {
        Session session = sessionOf(stack());
        for (int step = 0; step < 120; ++step) {
            session.step();
            QVERIFY(session.events().report.records.empty());
            const double energy = session.events().report.energy();
            QVERIFY2(step < 5 || std::abs(energy) < 5.0, QByteArray::number(energy));  // it settles first
        }
    }
    /// A box that bounces is one impact each time that it was in the air for a tenth of a second.
    void touchingBodiesAreOneImpact() {
        Project project = fallingBlock();
        project.materials[0].restitution = 0.5;
        project.instances[0].isUnbreakable = true;
        Session session = sessionOf(project);
        std::vector<std::uint64_t> impacts;
        for (int step = 0; step < 300; ++step) {
            session.step();
            for (const EventRecord& record : session.events().report.records) {
                if (record.kind == EventKind::Impact) impacts.push_back(record.step);
            }
        }
        QVERIFY(impacts.size() >= 3 && impacts.size() <= 8);
        for (std::size_t k = 1; k < impacts.size(); ++k) QVERIFY(impacts[k] - impacts[k - 1] > 6);
    }
    void removedBodiesHaveAReason() {
        Project project = fallingBlock();
        project.debris.maxFragments = 5;
        Session session = sessionOf(project);
        std::uint32_t removed = 0;
        for (int step = 0; step < 90; ++step) {
            session.step();
            const EventReport& report = session.events().report;
            for (const EventRecord& record : report.records) {
                if (record.kind != EventKind::Removed) continue;
                ++removed;
                QVERIFY(record.reason == RemovalReason::Budget);
                QVERIFY(record.mass > 0.0 && !record.fragment.empty());
            }
            removed += report.omitted[static_cast<std::size_t>(EventKind::Removed)].count;
        }
        QCOMPARE(removed, 7u);
    }
    /// Over 100 shots: what is reported is the mechanical energy that contacts and breaks took; never more than k
    /// records a step, none of them weaker than one left out; each break once.
    void energyBalances() {
        constexpr int kShots = 100;
        double worst = 0.0;
        for (int shot = 0; shot < kShots; ++shot) {
            const Scene& scene = scenes()[static_cast<std::size_t>(shot) % scenes().size()];
            Random random(static_cast<std::uint64_t>(2026 + shot));
            Result<Session> started = Session::start(scene.scene);
            QVERIFY(started);
            Session& session = *started;
            addInput(session, ShotInput{"shot", randomThrow(random)});
            session.step();
            double before = energyOf(session.world()), reported = 0.0, flight = 0.0;
            std::set<std::uint32_t> broken, detached;
            for (int step = 0; step < 150; ++step) {
                session.step();
                const EventReport& report = session.events().report;
                reported += report.energy();
                flight += lostInFlight(session);
                before += gainedByDetaching(session);
                QVERIFY2(faultOf(report, 16).empty(), faultOf(report, 16).c_str());
                QVERIFY(report.omitted[static_cast<std::size_t>(EventKind::Impact)].energy >= 0.0);
                for (const EventRecord& record : report.records) {
                    if (record.kind == EventKind::Impact) QVERIFY(record.energy >= 0.0);
                    if (record.kind == EventKind::Broken) QVERIFY(broken.insert(record.body).second);
                    if (record.kind == EventKind::Detached) QVERIFY(detached.insert(record.body).second);
                }
            }
            const double lost = before - energyOf(session.world()) - flight;
            const double error = std::abs(reported - lost) / std::max(lost, 10.0);
            worst = std::max(worst, error);
            qInfo("%s, seed %d: %.5g J lost, %.5g reported", scene.name.c_str(), 2026 + shot, lost, reported);
            QVERIFY2(error < 0.01, QByteArray::number(error));
        }
        qInfo("at worst %.2g of the energy", worst);
    }
    void whatComesOffIsReportedOnce() {
        Project project = test::bondedWall();
        project.events.maxRecords = 1000;
        Session session = sessionOf(project);
        std::set<std::uint32_t> detached;
        std::uint32_t bonds = 0;
        for (int shot = 0; shot < 12; ++shot) {
            addInput(session, ShotInput{"ball", test::ballAtWall({-1.6 + 0.3 * shot, 0.6 + 0.15 * shot})});
            for (int step = 0; step < 40; ++step) {
                session.step();
                for (const EventRecord& record : session.events().report.records) {
                    if (record.kind == EventKind::Bonds) {
                        bonds += record.count;
                        QVERIFY(record.area > 0.0 && !record.box.isEmpty());
                    }
                    if (record.kind != EventKind::Detached) continue;
                    QVERIFY(detached.insert(record.body).second);
                    QVERIFY(record.mass > 0.0 && record.count >= 1);
                }
            }
        }
        std::set<std::uint32_t> debris;
        for (const PlayBody& body : session.bodies()) {
            if (body.isDebris()) debris.insert(body.number);
        }
        QVERIFY(debris.size() > 40);
        QVERIFY(std::ranges::includes(detached, debris));
        std::ptrdiff_t broken = std::ranges::count(session.damage().begin()->second.broken, true);
        QCOMPARE(static_cast<std::ptrdiff_t>(bonds), broken);
    }
    void strongestAreReported() {
        for (const std::uint32_t most : {1u, 2u, 4u, 16u}) {
            const auto play = [&](std::uint32_t records) {
                Project project = stack();
                project.events.maxRecords = records;
                Session session = sessionOf(project);
                addInput(
                    session,
                    ShotInput{"shot",
                              Throw{.mass = 300.0, .from = {0.0, 2.0, 6.0}, .to = {0.0, 2.0, 0.0}, .speed = 30.0}});
                std::vector<EventReport> reports;
                for (int step = 0; step < 120; ++step) {
                    session.step();
                    reports.push_back(session.events().report);
                }
                return reports;
            };
            const std::vector<EventReport> all = play(100'000), some = play(most);
            for (std::size_t step = 0; step < all.size(); ++step) {
                std::array<std::vector<double>, kEventKinds> left;
                for (const EventRecord& one : all[step].records) {
                    if (std::ranges::find(some[step].records, one) == some[step].records.end())
                        left[static_cast<std::size_t>(one.kind)].push_back(one.energy);
                }
                for (const EventRecord& one : some[step].records) {
                    for (const double energy : left[static_cast<std::size_t>(one.kind)]) QVERIFY(one.energy >= energy);
                }
                const double reported = all[step].energy(), less = some[step].energy();
                QVERIFY2(std::abs(reported - less) < 1e-6 * (1.0 + sizeOf(all[step])),
                         QByteArray::number(reported - less));
                QVERIFY(some[step].records.size() <= std::max<std::size_t>(most, 1));
            }
        }
    }
    void sameOnAnyThreadsAndLanes() {
        const auto hashes = [](int threads, SimdWidth lanes) {
            Result<Session> session = Session::start(scenes()[2].scene, {.threads = threads, .lanes = lanes});
            Random random(7);
            addInput(*session, ShotInput{"shot", randomThrow(random)});
            std::vector<std::uint64_t> all;
            for (int step = 0; step < 120; ++step) {
                session->step();
                all.push_back(session->events().report.hash());
            }
            return all;
        };
        const std::vector<std::uint64_t> one = hashes(1, SimdWidth::Scalar);
        for (const int threads : {2, 3, 8}) QCOMPARE(hashes(threads, widestSimd()), one);
        QCOMPARE(hashes(1, SimdWidth::Four), one);
        QVERIFY(std::set(one.begin(), one.end()).size() > 10);
    }
};

RUBBLE_TEST(EventReportingTest)
#include "EventReportingTest.moc"
