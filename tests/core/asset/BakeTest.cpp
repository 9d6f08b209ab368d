#include "core/asset/Bake.h"

#include "tests/support/Projects.h"

#include <QTest>

#include <algorithm>
#include <functional>

using namespace rubble;

namespace {

/// A box of 1 x 1 x 0.5 m with two placed halves; the left one is broken in four, the right one stays.
Asset layeredBox() {
    Asset asset = boxAsset(3, 5, PlacedSeeds{{{0, {0.125, 0.5}}, {1, {0.875, 0.5}}}});
    const Vec2 reach{0.25, 0.25};  // in the frame of a half, about its centre
    const PlacedSeeds quarters{{{0, -reach}, {1, {reach.x, -reach.y}}, {2, {-reach.x, reach.y}}, {3, reach}}};
    asset.levels = {{.pattern = {{{.id = 6, .parameters = quarters}}}, .minimumVolume = 0.0}};
    return asset;
}

/// Two levels of scattered seeds below the first.
Asset scatteredBox() {
    Asset asset = boxAsset(3, 5, UniformScatter{.count = 12});
    asset.prism.outline = squareRing();
    asset.levels = {{.pattern = {{{.id = 6, .parameters = UniformScatter{.count = 6}}}}, .minimumVolume = 0.2},
                    {.pattern = {{{.id = 8, .parameters = BlueNoise{.minimumDistance = 0.2}}}}, .minimumVolume = 0.05}};
    return asset;
}

std::vector<std::string> idsOf(const Bake& bake) {
    std::vector<std::string> ids;
    for (const BakedFragment& fragment : bake.fragments) ids.push_back(fragment.id);
    return ids;
}

std::string faultOf(const Bake& bake, const Asset& asset) { return verifyBake(bake, asset).value_or(""); }

Bake bakedOn(int threads, const Asset& asset) {
    TaskContext task;
    task.threads = threads;
    return *bake(asset, task);
}

bool areEqual(const BakedFragment& a, const BakedFragment& b) {
    const auto sameBond = [](const Bond& x, const Bond& y) { return x.fragment == y.fragment && x.area == y.area; };
    return a.id == b.id && a.parent == b.parent && a.level == b.level && a.firstChild == b.firstChild &&
           a.childCount == b.childCount && a.solid.outline == b.solid.outline && a.solid.across == b.solid.across &&
           a.solid.parts == b.solid.parts && a.solid.offset == b.solid.offset &&
           a.solid.mass.volume == b.solid.mass.volume && a.solid.mass.inertia == b.solid.mass.inertia &&
           std::ranges::equal(a.solid.bonds, b.solid.bonds, sameBond);
}

using Change = std::function<void(Asset&)>;
using Fault = std::function<void(Bake&)>;

}  // namespace
Q_DECLARE_METATYPE(Change)
Q_DECLARE_METATYPE(Fault)

class BakeTest : public QObject {
    Q_OBJECT
private slots:
    void aPatternGivesTheFirstLevel() {
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
        QVERIFY(result->fragments[1].solid.offset == Vec3(0.75, 0.5, 0.0));
        QCOMPARE(result->fragments[1].parent, kNone);
        QCOMPARE(result->fragments[1].childCount, 0u);
        QCOMPARE(faultOf(*result, asset), std::string());
    }
    void aLevelBreaksTheFragmentsAboveIt() {
        const Asset asset = layeredBox();
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->fragments.size(), std::size_t{2 + 4 + 4});
        QCOMPARE(result->fragments[2].id, std::string("3/5.0/6.0"));
        QCOMPARE(result->fragments[9].id, std::string("3/5.1/6.3"));
        QCOMPARE(result->fragments[1].firstChild, 6u);
        QCOMPARE(result->fragments[1].childCount, 4u);
        QCOMPARE(result->fragments[6].parent, 1u);
        QCOMPARE(result->fragments[6].level, 1u);
        QVERIFY(result->fragments[6].solid.offset == Vec3(0.625, 0.25, 0.0));  // in the prism's frame
        QCOMPARE(result->fragments[6].solid.bonds[0].fragment, 1u);            // among its siblings
        QCOMPARE(faultOf(*result, asset), std::string());
    }
    void smallFragmentsStayWhole() {
        Asset asset = layeredBox();
        asset.pattern.layers[0].parameters = PlacedSeeds{{{0, {0.5, 0.5}}, {1, {1.0, 0.5}}}};
        asset.levels[0].minimumVolume = 0.25;  // the left piece has 0.375 m^3, the right one 0.125
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->fragments[0].childCount, 4u);
        QCOMPARE(result->fragments[1].childCount, 0u);
        QCOMPARE(faultOf(*result, asset), std::string());
    }
    void aFragmentThatWouldGiveOnePieceStaysWhole() {
        Asset asset = layeredBox();
        asset.levels[0].pattern.layers[0].parameters = PlacedSeeds{{{0, {0.0, 0.0}}}};
        QCOMPARE(bake(asset)->fragments.size(), std::size_t{2});
    }
    void aConcaveWholeHasSeveralHulls() {
        Asset asset = layeredBox();
        asset.prism.outline = squareRing();
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->wholeHulls.size(), std::size_t{4});
        for (const Polytope& hull : result->wholeHulls) QCOMPARE(verifyPolytope(hull).value_or(""), std::string());
    }
    void reportsOfLevelsNameTheFragment() {
        Asset asset = layeredBox();
        asset.levels[0].pattern.layers[0].overrides = {{.index = 9, .isDeleted = true}};
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->reports.size(), std::size_t{2});
        QCOMPARE(result->reports[1].code, ReportCode::LostOverride);
        QVERIFY(result->reports[1].message.starts_with("Fragment 3/5.1: "));
    }
    void severalLevelsVerify() {
        const Asset asset = scatteredBox();
        const Result<Bake> result = bake(asset);
        QVERIFY(std::ranges::any_of(result->fragments, [](const BakedFragment& f) { return f.level == 2; }));
        QCOMPARE(faultOf(*result, asset), std::string());
    }
    void everyNumberOfThreadsGivesTheSame() {
        const Asset asset = scatteredBox();
        const Bake one = bakedOn(1, asset);
        for (const int threads : {2, 4}) {
            const Bake many = bakedOn(threads, asset);
            QVERIFY(std::ranges::equal(one.fragments, many.fragments, areEqual));
            QVERIFY(one.partition.points == many.partition.points);
            QVERIFY(one.input == many.input);
        }
    }
    void faultsNameTheAsset() {
        Asset asset = layeredBox();
        asset.prism.depth = -1.0;
        QCOMPARE(bake(asset).error().code, ErrorCode::BadInput);
        QVERIFY(bake(asset).error().message.starts_with("Asset \"box\": The depth is -1"));
    }
    void faultsOfALevelNameTheFragment() {
        Asset asset = layeredBox();
        asset.levels[0].pattern.layers[0].parameters = UniformScatter{.count = kMostSeeds + 1};
        const Result<Bake> result = bake(asset);
        QCOMPARE(result.error().code, ErrorCode::Limit);
        QVERIFY(result.error().message.starts_with("Asset \"box\": Fragment 3/5.0: "));
    }
    void aCancelledBakeGivesNothing() {
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

    void theHashIsOfAllThatMatters_data() {
        QTest::addColumn<Change>("change");
        const auto row = [](const char* name, const Change& change) { QTest::newRow(name) << change; };
        row("id", [](Asset& a) { a.id = 4; });
        row("depth", [](Asset& a) { a.prism.depth = 0.75; });
        row("corner", [](Asset& a) { a.prism.outline.outer[1].x = 1.5; });
        row("hole", [](Asset& a) { a.prism.outline.holes = {{{0.5, 0.5}, {0.5, 0.6}, {0.6, 0.6}}}; });
        row("layer id", [](Asset& a) { a.pattern.layers[0].id = 9; });
        row("random seed", [](Asset& a) { a.pattern.layers[0].randomSeed = 8; });
        row("kind", [](Asset& a) { a.pattern.layers[0].parameters = BlueNoise{}; });
        row("layer off", [](Asset& a) { a.pattern.layers[0].isOn = false; });
        row("another layer", [](Asset& a) { a.pattern.layers.push_back({.id = 9}); });
        row("count", [](Asset& a) { a.pattern.layers[1].parameters = UniformScatter{.count = 4}; });
        row("domain", [](Asset& a) {
            a.pattern.layers[1].parameters = UniformScatter{.count = 3, .domain = ScatterDomain::BoundingBox};
        });
        row("distance", [](Asset& a) { a.pattern.layers[2].parameters = BlueNoise{.minimumDistance = 0.3}; });
        row("rounds", [](Asset& a) { a.pattern.layers[3].parameters = LloydRelaxation{4}; });
        row("placed index", [](Asset& a) { std::get<PlacedSeeds>(a.pattern.layers[0].parameters).seeds[1].index = 2; });
        row("placed position",
            [](Asset& a) { std::get<PlacedSeeds>(a.pattern.layers[0].parameters).seeds[1].position.y = 0.25; });
        row("override index", [](Asset& a) { a.pattern.layers[1].overrides[0].index = 1; });
        row("override deletes", [](Asset& a) { a.pattern.layers[1].overrides[0].isDeleted = true; });
        row("override moves", [](Asset& a) { a.pattern.layers[1].overrides[0].position.x = 0.5; });
        row("level's pattern", [](Asset& a) { a.levels[0].pattern.layers[0].randomSeed = 8; });
        row("level's volume", [](Asset& a) { a.levels[0].minimumVolume = 0.1; });
        row("another level", [](Asset& a) { a.levels.push_back({}); });
    }
    void theHashIsOfAllThatMatters() {
        QFETCH(Change, change);
        Asset asset = hashedBox();
        const ContentHash before = bakeInputHash(asset);
        change(asset);
        QVERIFY(bakeInputHash(asset) != before);
    }
    void theHashIsOfNothingElse_data() {
        QTest::addColumn<Change>("change");
        const auto row = [](const char* name, const Change& change) { QTest::newRow(name) << change; };
        row("name", [](Asset& a) { a.name = "wall"; });
        row("material", [](Asset& a) { a.material = 2; });
        row("threshold", [](Asset& a) { a.threshold = 7.0; });
        row("scale", [](Asset& a) { a.insideUvScale = 2.0; });
        row("surface", [](Asset& a) { a.surface = std::make_shared<Surface>(); });
        row("a layer that is off", [](Asset& a) { a.pattern.layers.push_back({.id = 9, .isOn = false}); });
        row("where a deleted seed was moved to", [](Asset& a) {
            a.pattern.layers[1].overrides[1] = {.index = 2, .isDeleted = true, .position = {7.0, 7.0}};
        });
    }
    void theHashIsOfNothingElse() {
        QFETCH(Change, change);
        Asset asset = hashedBox();
        const ContentHash before = bakeInputHash(asset);
        change(asset);
        QVERIFY(bakeInputHash(asset) == before);
    }

    void damagedBakesAreFound_data() {
        QTest::addColumn<Fault>("damage");
        QTest::addColumn<QString>("sentence");
        const auto row = [](const char* sentence, const Fault& damage) {
            QTest::newRow(sentence) << damage << sentence;
        };
        row("Asset \"box\": the bake was made from something else.", [](Bake& b) { b.asset = 7; });
        row("Asset \"box\": the bake was made from something else.", [](Bake& b) { b.input = {}; });
        row("Asset \"box\": a hull of the whole: 6 faces have 5 planes.",
            [](Bake& b) { b.wholeHulls[0].planes.pop_back(); });
        row("Asset \"box\": Fragment 1 does not have its centre of mass as origin.",
            [](Bake& b) { b.fragments[1].solid.mass.centre.x = 0.5; });
        row("Asset \"box\": Fragment 3/5.7 is not the 3/5.1 it should be.",
            [](Bake& b) { b.fragments[1].id = "3/5.7"; });
        row("Asset \"box\": There are 1 fragments, but 2 when it is broken again.",
            [](Bake& b) { b.fragments[1].parent = 0; });
        row("Asset \"box\": fragment 3/5.1: The fragments' centre of mass is not the prism's.",
            [](Bake& b) { b.fragments[6].solid.offset.x += 0.1; });
        row("Asset \"box\": fragment 3/5.1/6.0 has pieces below the last level.",
            [](Bake& b) { b.fragments[6].childCount = 1; });
    }
    void damagedBakesAreFound() {
        QFETCH(Fault, damage);
        QFETCH(QString, sentence);
        Bake result = *bake(layeredBox());
        damage(result);
        QCOMPARE(QString::fromStdString(faultOf(result, layeredBox())), sentence);
    }

private:
    /// One layer of every kind, with overrides, and a level.
    static Asset hashedBox() {
        Asset asset = layeredBox();
        asset.pattern.layers.push_back(
            {.id = 10,
             .parameters = UniformScatter{.count = 3},
             .overrides = {{.index = 0, .position = {0.25, 0.25}}, {.index = 2, .isDeleted = true}}});
        asset.pattern.layers.push_back({.id = 11, .parameters = BlueNoise{.minimumDistance = 0.4}});
        asset.pattern.layers.push_back({.id = 12, .parameters = LloydRelaxation{2}});
        return asset;
    }
};

QTEST_APPLESS_MAIN(BakeTest)
#include "BakeTest.moc"
