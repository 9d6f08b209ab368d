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
    for (std::uint32_t k = 0; k < bake.fragmentCount(); ++k) ids.push_back(bake.fragmentId(k));
    return ids;
}

std::string faultOf(const Bake& bake, const Asset& asset) { return verifyBake(bake, asset).value_or(""); }

Bake bakedOn(int threads, const Asset& asset) {
    TaskContext task;
    task.threads = threads;
    return *bake(asset, task);
}

bool areEqual(const Bake& a, const Bake& b) {
    const auto sameBond = [](const Bond& x, const Bond& y) { return x.fragment == y.fragment && x.area == y.area; };
    const auto sameFragment = [&](std::uint32_t k) {
        const BakedFragment x = a.fragment(k), y = b.fragment(k);
        return x.parent == y.parent && x.level == y.level && x.firstChild == y.firstChild &&
               x.childCount == y.childCount && x.solid.outline() == y.solid.outline() &&
               x.solid.across() == y.solid.across() && x.solid.isConvex() == y.solid.isConvex() &&
               x.solid.offset() == y.solid.offset() && x.solid.mass().volume == y.solid.mass().volume &&
               x.solid.mass().inertia == y.solid.mass().inertia &&
               std::ranges::equal(x.solid.bonds(), y.solid.bonds(), sameBond);
    };
    bool isEqual = a.input == b.input && idsOf(a) == idsOf(b);
    for (std::uint32_t k = 0; isEqual && k < a.fragmentCount(); ++k) isEqual = sameFragment(k);
    return isEqual;
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
        QVERIFY(result->fragment(1).solid.offset() == Vec3(0.75, 0.5, 0.0));
        QCOMPARE(result->fragment(1).parent, kNone);
        QCOMPARE(result->fragment(1).childCount, 0u);
        QCOMPARE(faultOf(*result, asset), std::string());
    }
    void aLevelBreaksTheFragmentsAboveIt() {
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
        QCOMPARE(result->fragment(6).solid.bonds()[0].fragment, 1u);            // among its siblings
        QCOMPARE(faultOf(*result, asset), std::string());
    }
    void smallFragmentsStayWhole() {
        Asset asset = layeredBox();
        asset.pattern.layers[0].parameters = PlacedSeeds{{{0, {0.5, 0.5}}, {1, {1.0, 0.5}}}};
        asset.levels[0].minimumVolume = 0.25;  // the left piece has 0.375 m^3, the right one 0.125
        const Result<Bake> result = bake(asset);
        QCOMPARE(result->fragment(0).childCount, 4u);
        QCOMPARE(result->fragment(1).childCount, 0u);
        QCOMPARE(faultOf(*result, asset), std::string());
    }
    void aFragmentThatWouldGiveOnePieceStaysWhole() {
        Asset asset = layeredBox();
        asset.levels[0].pattern.layers[0].parameters = PlacedSeeds{{{0, {0.0, 0.0}}}};
        QCOMPARE(bake(asset)->fragmentCount(), 2u);
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
        QCOMPARE(result->breakings.back().level, 2u);
        QCOMPARE(faultOf(*result, asset), std::string());
    }
    void everyNumberOfThreadsGivesTheSame() {
        const Asset asset = scatteredBox();
        const Bake one = bakedOn(1, asset);
        for (const int threads : {2, 4}) {
            QVERIFY(areEqual(one, bakedOn(threads, asset)));
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
        asset.levels[0].pattern.layers[0].parameters = UniformScatter{.count = {CountBy::Density, 1e12}};
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
    void theHashIsOfEveryParameterOfEveryKind() {
        for (const LayerParameters& sample : patternSamples()) {
            Asset asset = hashedBox();
            asset.pattern.layers[0] = {.id = 30, .parameters = sample};
            for (const LayerParameter& parameter : kindOf(sample).parameters) {
                Asset changed = asset;
                ParameterValue value = parameter.read(sample);
                if (auto* number = std::get_if<double>(&value)) *number = *number == 1.0 ? 0.0 : 1.0;
                if (auto* point = std::get_if<Vec2>(&value)) point->y += 1.0;
                if (auto* count = std::get_if<SeedCount>(&value)) count->amount += 1.0;
                parameter.write(changed.pattern.layers[0].parameters, value);
                QVERIFY2(bakeInputHash(changed) != bakeInputHash(asset), parameter.caption);
            }
        }
        const auto hashOf = [](const SeedCount& count) {
            Asset asset = hashedBox();
            asset.pattern.layers[0] = {.id = 30, .parameters = UniformScatter{.count = count}};
            return bakeInputHash(asset);
        };
        QVERIFY(hashOf({CountBy::Density, 5.0}) != hashOf(5));
        QVERIFY(hashOf({CountBy::Density, 5.0}) != hashOf({CountBy::PieceSize, 5.0}));
    }
    void theHashIsOfThePicture() {
        const auto hashOf = [](const GreyImage& image) {
            Asset asset = hashedBox();
            asset.pattern.layers[0] = {.id = 30,
                                       .parameters = DensityImage{.image = std::make_shared<GreyImage>(image)}};
            return bakeInputHash(asset);
        };
        GreyImage other = *fourPixels();
        QVERIFY(hashOf(other) == hashOf(*fourPixels()));
        other.grey[3] = 1;
        QVERIFY(hashOf(other) != hashOf(*fourPixels()));
        other = *fourPixels();
        other.opacity.clear();
        QVERIFY(hashOf(other) != hashOf(*fourPixels()));
        QVERIFY(hashOf(other) != hashOf(*fourPixels()));
    }
    void theHashIsOfStrokes() {
        using Stroke = Strokes::Stroke;
        const auto hashOf = [](std::vector<Stroke> strokes) {
            Asset asset = hashedBox();
            asset.pattern.layers[0] = {.id = 30, .parameters = Strokes{std::move(strokes)}};
            return bakeInputHash(asset);
        };
        const std::vector<Stroke> drawn{{0, {{0.1, 0.2}, {0.3, 0.4}}}, {2, {{0.5, 0.6}, {0.7, 0.8}}}};
        const std::vector<std::vector<Stroke>> others{
            {},
            {drawn[0]},
            {drawn[1]},
            {drawn[0], {3, drawn[1].points}},
            {drawn[0], {2, {{0.5, 0.6}, {0.7, 0.9}}}},
            {drawn[0], {2, {{0.4, 0.6}, {0.7, 0.8}}}},
            {drawn[0], {2, {{0.5, 0.6}, {0.7, 0.8}, {0.9, 0.9}}}},
            {{0, {{0.1, 0.2}, {0.3, 0.4}, {0.5, 0.6}, {0.7, 0.8}}}},
            {drawn[0], drawn[1], {4, drawn[1].points}},
        };
        QVERIFY(hashOf(drawn) == hashOf(drawn));
        for (std::size_t k = 0; k < others.size(); ++k) {
            QVERIFY2(hashOf(others[k]) != hashOf(drawn), qPrintable(QString::number(k)));
        }
    }
    void theHashIsOfAllThatIsDoneToPieces_data() {
        QTest::addColumn<Change>("change");
        const auto row = [](const char* name, const Change& change) { QTest::newRow(name) << change; };
        const auto merge = [](Asset& a) -> FragmentMerge& { return std::get<FragmentMerge>(a.edits[0]); };
        const auto split = [](Asset& a) -> FragmentSplit& { return std::get<FragmentSplit>(a.edits[1]); };
        row("rule", [](Asset& a) { a.shaping.smallPieces.rule = SmallPieceRule::DropSeeds; });
        row("rule: kept", [](Asset& a) { a.shaping.smallPieces.rule = SmallPieceRule::Keep; });
        row("measure", [](Asset& a) { a.shaping.smallPieces.measure = PieceMeasure::Volume; });
        row("limit", [](Asset& a) { a.shaping.smallPieces.limit = 0.02; });
        row("gap", [](Asset& a) { a.shaping.gap = 0.002; });
        row("no gap", [](Asset& a) { a.shaping.gap = 0.0; });
        row("leaf", [](Asset& a) { a.leaves[0].fragment = "5.2"; });
        row("leaf kept whole", [](Asset& a) { a.leaves[0].level.reset(); });
        row("leaf broken", [](Asset& a) { a.leaves[1].level.emplace(); });
        row("leaf's volume", [](Asset& a) { a.leaves[0].level->minimumVolume = 0.2; });
        row("leaf's pattern", [](Asset& a) { a.leaves[0].level->pattern.layers[0].randomSeed = 9; });
        row("one leaf less", [](Asset& a) { a.leaves.pop_back(); });
        row("merge into", [merge](Asset& a) { merge(a).into = "5.1"; });
        row("merged", [merge](Asset& a) { merge(a).merged = {"5.4"}; });
        row("one more merged", [merge](Asset& a) { merge(a).merged.push_back("5.4"); });
        row("split", [split](Asset& a) { split(a).fragment = "5.1"; });
        row("line's point", [split](Asset& a) { split(a).line.point.y = 0.3; });
        row("line's direction", [split](Asset& a) { split(a).line.direction.x = 0.5; });
        row("order of edits", [](Asset& a) { std::swap(a.edits[0], a.edits[1]); });
        row("one edit less", [](Asset& a) { a.edits.pop_back(); });
        row("nothing is done", [](Asset& a) {
            a.shaping = {};
            a.leaves.clear();
            a.edits.clear();
        });
    }
    void theHashIsOfAllThatIsDoneToPieces() {
        QFETCH(Change, change);
        Asset asset = hashedBox();
        asset.shaping = {.smallPieces = {SmallPieceRule::Merge, PieceMeasure::Area, 0.01}, .gap = 0.001};
        asset.leaves = {{"5.0", Level{.pattern = {{{.id = 40, .randomSeed = 3, .parameters = UniformScatter{3}}}},
                                      .minimumVolume = 0.1}},
                        {"5.1", {}}};
        asset.edits = {FragmentMerge{"5.2", {"5.3"}}, FragmentSplit{"5.0", {{0.1, 0.2}, {1.0, 0.0}}}};
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
        row("cut at impact", [](Asset& a) { a.cutAtImpact.emplace(); });
        row("intents", [](Asset& a) { a.intents.resize(1); });
        row("contact time", [](Asset& a) { a.contactTime = 0.001; });
        row("inside material", [](Asset& a) { a.insideMaterial = 2; });
        row("roughness", [](Asset& a) { a.shaping.roughness = {.amplitude = 0.01, .randomSeed = 5}; });
        row("limit of pieces that are kept", [](Asset& a) {
            a.shaping.smallPieces = {SmallPieceRule::Keep, PieceMeasure::Volume, 0.5};
        });
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
        row("Asset \"box\": the whole is not broken.", [](Bake& b) { b.breakings.clear(); });
        row("Asset \"box\": the whole is not broken.", [](Bake& b) { b.breakings[0].parent = 1; });
        row("Asset \"box\": fragment 2 has another number.", [](Bake& b) { b.breakings[1].first = 3; });
        row("Asset \"box\": fragment 6 is not a piece of the next fragment that is broken.",
            [](Bake& b) { b.breakings[2].parent = 0; });
        row("Asset \"box\": fragment 6 is not a piece of the next fragment that is broken.",
            [](Bake& b) { b.breakings[2].parent = 6; });
        row("Asset \"box\": fragment 3/5.1 has pieces of another level than the next.",
            [](Bake& b) { b.breakings[2].level = 2; });
        row("Asset \"box\": fragment 3/5.1/6.3 has pieces below the last level.", [](Bake& b) {
            b.breakings.push_back(b.breakings[2]);
            b.breakings[3].parent = 9;
            b.breakings[3].first = 10;
        });
        row("Asset \"box\": Fragment 1 does not have its centre of mass as origin.", [](Bake& b) {
            Fragments& fragments = b.breakings[0].fragments;
            fragments.records[fragments.pieceOfFragment[1]].moments.centre.x += 0.5;
        });
        row("Asset \"box\": Fragment 3/5.7 is not the 3/5.1 it should be.",
            [](Bake& b) { b.breakings[0].seeds.ids[1].index = 7; });
        row("Asset \"box\": fragment 3/5.1: There are 3 fragments, but 4 when it is broken again.",
            [](Bake& b) { b.breakings[2].fragments.pieceOfFragment.pop_back(); });
        row("Asset \"box\": fragment 3/5.1: The fragments are not where it is.",
            [](Bake& b) { b.breakings[2].fragments.origin.x += 0.1; });
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
