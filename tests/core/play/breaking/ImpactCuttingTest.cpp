#include "core/play/breaking/ImpactCutting.h"

#include "core/base/Random.h"
#include "core/base/Stopwatch.h"
#include "core/play/damage/DamageBytes.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshAsset.h"
#include "tests/support/play/Damages.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;

namespace {

Project cutWhereHit(std::uint32_t fragments = 40) {
    Project project = test::floatingBlock();
    project.assets[0].cutAtImpact = CutAtImpact{.fragments = fragments, .falloffRadius = 0.15};
    return project;
}

/// A sphere of radius 1 m, of about 10,000 triangles.
Asset sphere(std::uint32_t fragments) {
    Asset asset = test::meshAsset(test::bumpySphere(71), fragments);
    asset.cutAtImpact = CutAtImpact{.fragments = fragments, .falloffRadius = 0.4};
    return asset;
}

}  // namespace

class ImpactCuttingTest : public QObject {
    Q_OBJECT
private slots:
    void fragmentsAreSmallerAtTheImpact() {
        const Asset asset = cutWhereHit().assets[0];
        Random random(3);
        for (int round = 0; round < 50; ++round) {
            const Vec2 point{random.between(-0.5, 0.5), random.between(-0.5, 0.5)};
            const auto cut = cutAtImpact(asset, Vec3(point, 0.0), static_cast<std::uint64_t>(round));
            QVERIFY(cut.hasValue());
            const Bake& bake = *(*cut)->bake;
            QCOMPARE(bake.fragmentCount(), 40u);
            double near = 0.0, far = 0.0, total = 0.0;
            int nearCount = 0, farCount = 0;
            for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
                const Fragment piece = bake.fragment(k).solid;
                const bool isNear = glm::distance(Vec2(piece.offset()), point) < 0.15;
                (isNear ? near : far) += piece.volume();
                ++(isNear ? nearCount : farCount);
                total += piece.volume();
            }
            QVERIFY(std::abs(total - 0.5) < 1e-9);
            QVERIFY(nearCount >= 10);
            QVERIFY2(near / nearCount < 0.4 * far / farCount, QByteArray::number(round));
        }
    }
    /// What was done by hand to fragments of the pattern means others here, though the names may be the same.
    void editsOfThePatternAreIgnored() {
        Asset asset = cutWhereHit(12).assets[0];
        const auto plain = cutAtImpact(asset, {0.1, 0.1, 0.0}, 5);
        asset.fragmentLevels = {{.fragment = "2.0", .level = Level{.pattern = asset.pattern}}};
        asset.edits = {FragmentMerge{.into = "2.0", .merged = {"2.1", "2.2", "2.3", "2.4", "2.5"}}};
        const auto cut = cutAtImpact(asset, {0.1, 0.1, 0.0}, 5);
        QVERIFY(cut.hasValue());
        QCOMPARE((*cut)->bake->fragmentCount(), 12u);
        QCOMPARE((*cut)->bake->fractures[0].seeds.positions, (*plain)->bake->fractures[0].seeds.positions);
        QVERIFY((*cut)->bake->fractures[0].seeds.diagnostics.empty());
    }
    void halfOfTheSeedsLieAtTheImpact() {
        const auto cut = cutAtImpact(cutWhereHit().assets[0], {0.1, 0.1, 0.0}, 5);
        const std::vector<SeedId>& seeds = (*cut)->bake->fractures[0].seeds.ids;
        QCOMPARE(std::ranges::count(seeds, 1u, &SeedId::layer), std::ptrdiff_t{20});
        QCOMPARE(std::ranges::count(seeds, 2u, &SeedId::layer), std::ptrdiff_t{20});
    }
    /// Needles of 0.1 mm all touched each other, and took the simulation half a second a step.
    void seedsAtTheImpactKeepADistance_data() {
        QTest::addColumn<double>("depth");
        QTest::addColumn<std::uint32_t>("fragments");
        QTest::addColumn<double>("distance");
        QTest::newRow("a twentieth of the depth") << 0.1 << 1000u << 0.005;
        QTest::newRow("2 mm") << 0.005 << 1000u << 0.002;
        QTest::newRow("half of the mean distance") << 2.0 << 400u << 0.025;
    }
    void seedsAtTheImpactKeepADistance() {
        QFETCH(double, depth);
        QFETCH(std::uint32_t, fragments);
        QFETCH(double, distance);
        Asset asset = cutWhereHit(fragments).assets[0];
        asset.prism().depth = depth;
        for (const double falloffRadius : {1e-9, 0.02, 100.0}) {
            asset.cutAtImpact->falloffRadius = falloffRadius;
            const auto cut = cutAtImpact(asset, {0.45, 0.1, 0.0}, 5);
            QVERIFY(cut.hasValue());
            const Seeds& seeds = (*cut)->bake->fractures[0].seeds;
            std::vector<Vec2> near;
            for (std::size_t k = 0; k < seeds.ids.size(); ++k) {
                if (seeds.ids[k].layer == 1) near.push_back(seeds.positions[k]);
            }
            if (falloffRadius < 1.0) QCOMPARE(near.size(), std::size_t{fragments / 2});
            for (std::size_t k = 0; k < near.size(); ++k) {
                for (std::size_t other = 0; other < k; ++other) {
                    QVERIFY(glm::distance(near[k], near[other]) >= distance);
                }
            }
        }
    }
    void cutDependsOnTheAsset() {
        Asset asset = cutWhereHit().assets[0];
        const auto one = cutAtImpact(asset, {0.1, 0.1, 0.0}, 5);
        asset.id += 1;
        const auto other = cutAtImpact(asset, {0.1, 0.1, 0.0}, 5);
        QVERIFY((*one)->bake->fractures[0].seeds.positions != (*other)->bake->fractures[0].seeds.positions);
    }
    void sameNumberGivesTheSameCut() {
        const Asset asset = cutWhereHit().assets[0];
        const auto areasOf = [&](std::uint64_t number) {
            std::vector<double> volumes;
            const auto cut = cutAtImpact(asset, {0.1, 0.1, 0.0}, number);
            for (std::uint32_t k = 0; k < (*cut)->bake->fragmentCount(); ++k) {
                volumes.push_back((*cut)->bake->fragment(k).solid.volume());
            }
            return volumes;
        };
        QCOMPARE(areasOf(5), areasOf(5));
        QVERIFY(areasOf(5) != areasOf(6));
    }
    void meshesAreCutAroundAPointInSpace() {
        const Asset asset = sphere(30);
        const Vec3 point{0.0, 0.1, 1.0};
        const auto cut = cutAtImpact(asset, point, 5);
        QVERIFY2(cut, cut ? "" : cut.error().message.c_str());
        const Bake& bake = *(*cut)->bake;
        QVERIFY(bake.fragmentCount() >= 30);
        const Seeds& seeds = bake.fractures[0].seeds;
        QCOMPARE(std::ranges::count(seeds.ids, 1u, &SeedId::layer), std::ptrdiff_t{15});
        QCOMPARE(std::ranges::count(seeds.ids, 2u, &SeedId::layer), std::ptrdiff_t{15});
        const double least = 0.2 * std::cbrt(asset.mesh()->mass.volume / 30.0);
        for (std::size_t k = 0; k < 15; ++k) {
            QVERIFY(glm::distance(seeds.at(k), point) <= 0.4);
            for (std::size_t other = 0; other < k; ++other)
                QVERIFY(glm::distance(seeds.at(k), seeds.at(other)) >= least);
        }
        double near = 0.0, far = 0.0;
        int nearCount = 0, farCount = 0;
        for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) {
            const Fragment fragment = bake.fragment(k).solid;
            const bool isNear = glm::distance(fragment.offset(), point) < 0.5;
            (isNear ? near : far) += fragment.volume();
            ++(isNear ? nearCount : farCount);
        }
        QVERIFY(std::abs(near + far - asset.mesh()->mass.volume) < 1e-9);
        QVERIFY(nearCount >= 8);
        QVERIFY2(near / nearCount < 0.4 * far / farCount, QByteArray::number(near / far));
        const auto higher = cutAtImpact(asset, {0.0, 0.1, -1.0}, 5);
        QVERIFY((*higher)->bake->fractures[0].seeds.heights != seeds.heights);
    }
    void meshesAreCutFastEnoughForAStep() {
        const Asset asset = sphere(30);
        QVERIFY(asset.mesh()->mesh.triangles.size() > 9900);
        const auto uncut = *playAsset(asset, std::make_shared<const Bake>(*bake(asset)), {}, FindContacts::OnBreak);
        double best = 1e300;
        for (std::uint64_t number = 0; number < 5; ++number) {
            Stopwatch watch;
            const auto cut = cutAtImpact(asset, {0.0, 0.1, 1.0}, number, uncut.get());
            best = std::min(best, watch.lap());
            QVERIFY(cut.hasValue());
            QVERIFY((*cut)->whole.shape == uncut->whole.shape);
            QVERIFY((*cut)->bake->wholeHulls == uncut->bake->wholeHulls);
        }
        qInfo("30 fragments of a sphere of 10,000 triangles: %.1f ms", best);
    }
    void sessionsCutMeshesWhereTheyAreHit() {
        Project project = test::floatingBlock();
        Asset asset = test::meshAsset(test::bumpySphere(24), 20, project.assets[0].id);
        asset.material = project.assets[0].material;
        asset.threshold = project.assets[0].threshold;
        asset.cutAtImpact = CutAtImpact{.fragments = 40, .falloffRadius = 0.4};
        project.assets[0] = asset;
        Session session = test::sessionOf(project);
        Throw thrown = test::throwAtBlock(500.0, 20.0);
        thrown.from = {0.3, 5.3, 4.0};
        thrown.to = {0.3, 5.3, 0.0};
        test::addInput(session, ShotInput{"box", thrown});
        const std::vector<PlayBreak> broken = test::breaksWithin(session, 60);
        QCOMPARE(broken.size(), 1u);
        QVERIFY(broken[0].fragmentCount >= 40);
        const SessionDamage damage = session.damage();
        QCOMPARE(damage.size(), 1u);
        const std::optional<ImpactCut> cut = damage.begin()->second.cut;
        QVERIFY(cut && cut->height > 0.5);
        QVERIFY(*damageOfBytes(damageBytes(damage.begin()->second)) == damage.begin()->second);
        const Session fresh = test::damaged(test::playSceneOf(project), damage);
        QVERIFY(fresh.damage() == damage);
    }
    void sessionCutsWithinTheStep() {
        const Project project = cutWhereHit();
        Session session = test::sessionOf(project);
        Throw thrown = test::throwAtBlock(50.0, 12.0);
        thrown.from = {0.3, 5.3, 1.0};
        thrown.to = {0.3, 5.3, 0.0};
        test::addInput(session, ShotInput{"box", thrown});
        const std::vector<PlayBreak> broken = test::breaksWithin(session, 30);
        QCOMPARE(broken.size(), 1u);
        QCOMPARE(broken[0].fragmentCount, 40u);
        QVERIFY(glm::distance(Vec2(broken[0].point), Vec2(0.3, 5.3)) < 0.02);
    }
    void energiesOfCutsAndOfPatternsHaveTheirKinds() {
        for (const bool isCut : {false, true}) {
            Session session = test::sessionOf(isCut ? cutWhereHit() : test::floatingBlock());
            test::addInput(session, BreakInput{session.bodies()[1].number});
            session.step();
            const EnergyAudit& audit = session.events().energy;
            QCOMPARE(audit.size(), 1u);
            QVERIFY(audit[0].change == (isCut ? EnergyChange::Cut : EnergyChange::Swap));
        }
    }
    void twoBodiesOfAnAssetAreCutDifferently() {
        Project project = cutWhereHit(10);
        test::addInstance(project, project.assets[0].id, "other", {.position = {3.0, 5.0, 0.0}});
        Session session = test::sessionOf(project);
        test::addInput(session, BreakInput{session.bodies()[1].number});
        test::addInput(session, BreakInput{session.bodies()[2].number});
        session.step();
        QCOMPARE(session.events().breaks.size(), 2u);
        const auto volumeOf = [&](std::uint32_t number) {
            return session.world().shape(session.body(number)->body).mass.volume;
        };
        QVERIFY(volumeOf(session.events().breaks[0].firstFragment) !=
                volumeOf(session.events().breaks[1].firstFragment));
    }
};

RUBBLE_TEST(ImpactCuttingTest)
#include "ImpactCuttingTest.moc"
