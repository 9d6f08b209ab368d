#include "tests/support/TestProgram.h"
#include "tests/support/asset/Arcade.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

#include <map>

using namespace rubble;

namespace {

/// Where the centre of a fragment is, m.
Vec3 centreOf(const Session& session, const PlayBody& body, std::uint32_t fragment) {
    const Pose pose = session.world().state(body.body).pose;
    return pose.position + pose.orientation * (centreInAsset(body.asset->fragments[fragment]) - frameOf(body));
}

/// The centres of the fragments of the arcade by number.
std::map<std::uint32_t, Vec3> centresOf(const Session& session) {
    std::map<std::uint32_t, Vec3> centres;
    for (const PlayBody& body : session.bodies()) {
        if (body.asset == nullptr) continue;
        std::vector<std::uint32_t> fragments = fragmentsOf(body);
        if (fragments.empty() && body.fragment != kNone) fragments = {body.fragment};
        if (fragments.empty()) {
            for (std::uint32_t k = 0; k < body.asset->fragments.size(); ++k) fragments.push_back(k);
        }
        for (const std::uint32_t fragment : fragments) centres[fragment] = centreOf(session, body, fragment);
    }
    return centres;
}

}  // namespace

/// The demo arcade.
class ArcadeTest : public QObject {
    Q_OBJECT
private slots:
    void standsForAMinute() {
        Session session = test::sessionOf(test::arcade());
        for (int k = 0; k < 3600; ++k) session.step();
        QCOMPARE(session.bodies().size(), std::size_t{2});
        QVERIFY(session.damage().begin()->second.isIntact());
    }
    void whatAPierCarriedFallsAndTheRestStands() {
        Session session = test::sessionOf(test::arcade());
        const auto before = centresOf(session);
        QVERIFY(session.add(session.scene().project.shots[0]).hasValue());  // the blast at the second pier
        double carried = 0.0, fallen = 0.0;  // kg of what lost its support, and of that what is a metre lower
        std::vector<std::uint32_t> held;
        for (int k = 0; k < 240; ++k) session.step();
        const auto after = centresOf(session);
        for (const PlayBody& body : session.bodies()) {
            if (body.isHeld) held.insert(held.end(), body.nodes.begin(), body.nodes.end());
        }
        std::ranges::sort(held);
        const PlayAsset& asset = test::onlyAsset(session.scene());
        for (const auto& [fragment, centre] : before) {
            if (std::ranges::binary_search(held, fragment)) {
                QCOMPARE(after.at(fragment), centre);
                continue;
            }
            // What stood lower than a metre, or in the pier, cannot fall that far.
            if (centre.y < kLowest) continue;
            const double mass = asset.fragments[fragment].shape->mass.volume;
            carried += mass;
            if (after.at(fragment).y < centre.y - 1.0) fallen += mass;
        }
        qInfo("%zu of %zu fragments stand, %.1f %% of the others are a metre lower", held.size(), before.size(),
              100.0 * fallen / carried);
        QVERIFY(held.size() > before.size() / 4 && held.size() < before.size());
        QVERIFY(fallen >= 0.95 * carried);
        const SessionDamage damage = session.damage();
        for (int k = 0; k < 10000; ++k) session.step();
        QVERIFY(session.damage() == damage);
    }

private:
    static constexpr double kLowest = 2.0;  // m
};

RUBBLE_TEST(ArcadeTest)
#include "ArcadeTest.moc"
