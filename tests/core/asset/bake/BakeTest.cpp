#include "core/asset/bake/Bake.h"

#include "core/asset/checks/VerifyBake.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/LayeredBox.h"

#include <QTest>

#include <algorithm>
#include <functional>

using namespace rubble;

namespace {

/// Two levels of scattered seeds below the first.
Asset scatteredBox() {
    Asset asset = boxAsset(3, 5, UniformScatter{.count = 12});
    asset.prism().outline = squareRing();
    asset.levels = {{.pattern = {{{.id = 6, .parameters = UniformScatter{.count = 6}}}}, .minimumVolume = 0.2},
                    {.pattern = {{{.id = 8, .parameters = BlueNoise{.minimumDistance = 0.2}}}}, .minimumVolume = 0.05}};
    return asset;
}

std::string bakeFault(const Bake& bake, const Asset& asset) { return verifyBake(bake, asset).value_or(""); }

Bake bakedOn(int threads, const Asset& asset) {
    TaskContext task;
    task.threads = threads;
    return *bake(asset, task);
}

bool areEqual(const Bake& a, const Bake& b) {
    const auto sameContact = [](const FragmentContact& x, const FragmentContact& y) {
        return x.fragment == y.fragment && x.area == y.area;
    };
    const auto sameFragment = [&](std::uint32_t k) {
        const BakedFragment x = a.fragment(k), y = b.fragment(k);
        return x.parent == y.parent && x.level == y.level && x.firstChild == y.firstChild &&
               x.childCount == y.childCount && x.solid.extruded()->outline() == y.solid.extruded()->outline() &&
               x.solid.extruded()->edgeNeighbours() == y.solid.extruded()->edgeNeighbours() &&
               x.solid.isConvex() == y.solid.isConvex() && x.solid.offset() == y.solid.offset() &&
               x.solid.mass().volume == y.solid.mass().volume && x.solid.mass().inertia == y.solid.mass().inertia &&
               std::ranges::equal(x.solid.contacts(), y.solid.contacts(), sameContact);
    };
    bool isEqual = a.input == b.input && idsOf(a) == idsOf(b);
    for (std::uint32_t k = 0; isEqual && k < a.fragmentCount(); ++k) isEqual = sameFragment(k);
    return isEqual;
}

}  // namespace

class BakeTest : public QObject {
    Q_OBJECT
private slots:
    void patternGivesTheFirstLevel() {
        Asset asset = layeredBox();
        asset.levels.clear();
        const Result<Bake> result = bake(asset);
        QVERIFY(result);
        QCOMPARE(idsOf(*result), (std::vector<std::string>{"3/5.0", "3/5.1"}));
        QCOMPARE(result->asset, 3u);
        QCOMPARE(result->whole.volume, 0.5);
        QVERIFY(result->whole.centre == Vec3(0.5, 0.5, 0.0));
        QCOMPARE(result->wholeHulls.size(), std::size_t{1});
        QVERIFY(result->wholeHulls[0].vertices[0] == Vec3(-0.5, -0.5, 0.25));
        QVERIFY(result->fragment(1).solid.offset() == Vec3(0.75, 0.5, 0.0));
        QCOMPARE(result->fragment(1).parent, kNone);
        QCOMPARE(result->fragment(1).childCount, 0u);
        QCOMPARE(bakeFault(*result, asset), std::string());
    }
    void levelFracturesTheFragmentsAboveIt() {
        const Asset asset = layeredBox();
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->fragmentCount(), 2u + 4u + 4u);
        QCOMPARE(result->fragmentId(2), std::string("3/5.0/6.0"));
        QCOMPARE(result->fragmentId(9), std::string("3/5.1/6.3"));
        QCOMPARE(result->fragment(1).firstChild, 6u);
        QCOMPARE(result->fragment(1).childCount, 4u);
        QCOMPARE(result->fragment(6).parent, 1u);
        QCOMPARE(result->fragment(6).level, 1u);
        QVERIFY(result->fragment(6).solid.offset() == Vec3(0.625, 0.25, 0.0));  // in the prism's frame
        QCOMPARE(result->fragment(6).solid.contacts()[0].fragment, 1u);         // among its siblings
        QCOMPARE(bakeFault(*result, asset), std::string());
    }
    void smallFragmentsAreNotFractured() {
        Asset asset = layeredBox();
        asset.pattern.layers[0].parameters = PlacedSeeds{{{0, {0.5, 0.5}}, {1, {1.0, 0.5}}}};
        asset.levels[0].minimumVolume = 0.25;  // the left piece has 0.375 m³, the right one 0.125
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->fragment(0).childCount, 4u);
        QCOMPARE(result->fragment(1).childCount, 0u);
        QCOMPARE(bakeFault(*result, asset), std::string());
    }
    void fragmentThatWouldGiveOnePieceIsNotFractured() {
        Asset asset = layeredBox();
        asset.levels[0].pattern.layers[0].parameters = PlacedSeeds{{{0, {0.0, 0.0}}}};
        QCOMPARE(bake(asset)->fragmentCount(), 2u);
    }
    void concaveWholeHasSeveralHulls() {
        Asset asset = layeredBox();
        asset.prism().outline = squareRing();
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->wholeHulls.size(), std::size_t{4});
        for (const Polytope& hull : result->wholeHulls) QCOMPARE(verifyPolytope(hull).value_or(""), std::string());
    }
    void reportsOfLevelsNameTheFragment() {
        Asset asset = layeredBox();
        asset.levels[0].pattern.layers[0].overrides = {{.index = 9, .isDeleted = true}};
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->diagnostics.size(), std::size_t{2});
        QCOMPARE(result->diagnostics[1].code, DiagnosticCode::LostOverride);
        QVERIFY(result->diagnostics[1].message.starts_with("Fragment 3/5.1: "));
    }
    void severalLevelsVerify() {
        const Asset asset = scatteredBox();
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->fractures.back().level, 2u);
        QCOMPARE(bakeFault(*result, asset), std::string());
    }
    void resultIsIndependentOfThreads() {
        const Asset asset = scatteredBox();
        const Bake one = bakedOn(1, asset);
        for (const int threads : {2, 4}) {
            QVERIFY(areEqual(one, bakedOn(threads, asset)));
        }
    }
    void faultsNameTheAsset() {
        Asset asset = layeredBox();
        asset.prism().depth = -1.0;
        QCOMPARE(bake(asset).error().code, ErrorCode::BadInput);
        QVERIFY(bake(asset).error().message.starts_with("Asset \"box\": the depth is -1"));
    }
    void faultsOfALevelNameTheFragment() {
        Asset asset = layeredBox();
        asset.levels[0].pattern.layers[0].parameters = BlueNoise{.minimumDistance = -1.0};
        const Result<Bake> result = bake(asset);
        QCOMPARE(result.error().code, ErrorCode::BadInput);
        QVERIFY(result.error().message.starts_with("Asset \"box\": Fragment 3/5.0: "));
    }
    void cancelledBakeReturnsCancelled() {
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(bake(layeredBox(), task).error().code, ErrorCode::Cancelled);
        QCOMPARE(bake(layeredBox(), task).error().message, TaskContext::cancelled().message);
    }
    void cancellingBetweenLevelsStopsTheBake() {
        TaskContext task;
        task.progress = [&](double fraction) {
            if (fraction == 0.5) task.cancel.cancel();
        };
        QCOMPARE(bake(layeredBox(), task).error().code, ErrorCode::Cancelled);
    }
    void progressEndsAtOne() {
        std::vector<double> fractions;
        TaskContext task;
        task.progress = [&](double fraction) { fractions.push_back(fraction); };
        QVERIFY(bake(scatteredBox(), task));
        QVERIFY(std::ranges::is_sorted(fractions));
        QCOMPARE(fractions.back(), 1.0);
    }
};

RUBBLE_TEST(BakeTest)
#include "BakeTest.moc"
