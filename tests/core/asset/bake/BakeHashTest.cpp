#include "core/asset/bake/BakeHash.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/LayeredBox.h"
#include "tests/support/fracture/PatternSamples.h"
#include "tests/support/geometry/Outlines.h"

#include <functional>

using namespace rubble;

namespace {

using AssetChange = std::function<void(Asset&)>;

}  // namespace
Q_DECLARE_METATYPE(AssetChange)

class BakeHashTest : public QObject {
    Q_OBJECT
private slots:
    void hashCoversTheAsset_data() {
        QTest::addColumn<AssetChange>("change");
        const auto row = [](const char* name, const AssetChange& change) { QTest::newRow(name) << change; };
        row("id", [](Asset& a) { a.id = 4; });
        row("depth", [](Asset& a) { a.prism().depth = 0.75; });
        row("corner", [](Asset& a) { a.prism().outline.outer[1].x = 1.5; });
        row("hole", [](Asset& a) { a.prism().outline.holes = {{{0.5, 0.5}, {0.5, 0.6}, {0.6, 0.6}}}; });
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
        row("placed height",
            [](Asset& a) { std::get<PlacedSeeds>(a.pattern.layers[0].parameters).seeds[1].height = 0.25; });
        row("override's height", [](Asset& a) { a.pattern.layers[1].overrides[0].height = 0.25; });
        row("override index", [](Asset& a) { a.pattern.layers[1].overrides[0].index = 1; });
        row("override deletes", [](Asset& a) { a.pattern.layers[1].overrides[0].isDeleted = true; });
        row("override moves", [](Asset& a) { a.pattern.layers[1].overrides[0].position.x = 0.5; });
        row("scattered in an earlier outline", [](Asset& a) { a.pattern.layers[1].scatteredIn = unitSquare(); });
        row("level's pattern", [](Asset& a) { a.levels[0].pattern.layers[0].randomSeed = 8; });
        row("level's volume", [](Asset& a) { a.levels[0].minimumVolume = 0.1; });
        row("another level", [](Asset& a) { a.levels.push_back({}); });
    }
    void hashCoversTheAsset() {
        QFETCH(AssetChange, change);
        Asset asset = hashedBox();
        const ContentHash before = bakeInputHash(asset);
        change(asset);
        QVERIFY(bakeInputHash(asset) != before);
    }
    void hashLeavesOutHowTheAssetBreaks() {
        Asset asset = hashedBox();
        const ContentHash before = bakeInputHash(asset);
        asset.breakAs = BreakAs::Bonded;
        asset.bonding = everyBonding("3");
        asset.levels[0].bondStrength = 2.0;
        QVERIFY(bakeInputHash(asset) == before);
    }
    void hashCoversEveryParameterOfEveryKind() {
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
        QVERIFY(hashOf({CountBy::Density, 5.0}) != hashOf({CountBy::FragmentSize, 5.0}));
    }
    void spatialDefaultsAreNotHashed() {
        // The hash of an asset of before there were spatial parameters.
        Asset asset = hashedBox();
        const auto hashOf = [&asset](const LayerParameters& parameters) {
            asset.pattern.layers[0] = {.id = 30, .randomSeed = 2, .parameters = parameters};
            return bakeInputHash(asset).hex();
        };
        QVERIFY2(hashOf(JitteredGrid{}) == "01ff86583b798100d672c0830b93dbef", hashOf(JitteredGrid{}).c_str());
        QVERIFY2(hashOf(Grain{}) == "056f2da0a6df9ea7ac32b6d9128db7e2", hashOf(Grain{}).c_str());
        QVERIFY2(hashOf(PlacedSeeds{{{0, {0.1, 0.2}}, {3, {0.4, 0.3}}}}) == "76c97ed184320f6775b160abefdd8853",
                 hashOf(PlacedSeeds{{{0, {0.1, 0.2}}, {3, {0.4, 0.3}}}}).c_str());
        QVERIFY(hashOf(JitteredGrid{.layers = 2}) != hashOf(JitteredGrid{}));
        QVERIFY(hashOf(RadialPattern{.layers = 3}) != hashOf(RadialPattern{.axis = CoordinateAxis::X}));
    }
    void hashCoversTheDensityImage() {
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
    void hashCoversCrackLines() {
        using CrackLine = CrackLines::CrackLine;
        const auto hashOf = [](std::vector<CrackLine> lines) {
            Asset asset = hashedBox();
            asset.pattern.layers[0] = {.id = 30, .parameters = CrackLines{std::move(lines)}};
            return bakeInputHash(asset);
        };
        const std::vector<CrackLine> drawn{{0, {{0.1, 0.2}, {0.3, 0.4}}}, {2, {{0.5, 0.6}, {0.7, 0.8}}}};
        const std::vector<std::vector<CrackLine>> others{
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
    void hashCoversShaping_data() {
        QTest::addColumn<AssetChange>("change");
        const auto row = [](const char* name, const AssetChange& change) { QTest::newRow(name) << change; };
        const auto merge = [](Asset& a) -> FragmentMerge& { return std::get<FragmentMerge>(a.edits[0]); };
        const auto split = [](Asset& a) -> FragmentSplit& { return std::get<FragmentSplit>(a.edits[1]); };
        row("rule", [](Asset& a) { a.shaping.smallPieces.rule = SmallPieceRule::DropSeeds; });
        row("rule: kept", [](Asset& a) { a.shaping.smallPieces.rule = SmallPieceRule::Keep; });
        row("measure", [](Asset& a) { a.shaping.smallPieces.measure = PieceMeasure::Volume; });
        row("limit", [](Asset& a) { a.shaping.smallPieces.limit = 0.02; });
        row("gap", [](Asset& a) { a.shaping.gap = 0.002; });
        row("no gap", [](Asset& a) { a.shaping.gap = 0.0; });
        row("leaf", [](Asset& a) { a.fragmentLevels[0].fragment = "5.2"; });
        row("leaf kept whole", [](Asset& a) { a.fragmentLevels[0].level.reset(); });
        row("leaf broken", [](Asset& a) { a.fragmentLevels[1].level.emplace(); });
        row("leaf's volume", [](Asset& a) { a.fragmentLevels[0].level->minimumVolume = 0.2; });
        row("leaf's pattern", [](Asset& a) { a.fragmentLevels[0].level->pattern.layers[0].randomSeed = 9; });
        row("one leaf less", [](Asset& a) { a.fragmentLevels.pop_back(); });
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
            a.fragmentLevels.clear();
            a.edits.clear();
        });
    }
    void hashCoversShaping() {
        QFETCH(AssetChange, change);
        Asset asset = hashedBox();
        asset.shaping = {.smallPieces = {SmallPieceRule::Merge, PieceMeasure::Area, 0.01}, .gap = 0.001};
        asset.fragmentLevels = {
            {"5.0",
             Level{.pattern = {{{.id = 40, .randomSeed = 3, .parameters = UniformScatter{3}}}}, .minimumVolume = 0.1}},
            {"5.1", {}}};
        asset.edits = {FragmentMerge{"5.2", {"5.3"}}, FragmentSplit{"5.0", {{0.1, 0.2}, {1.0, 0.0}}}};
        const ContentHash before = bakeInputHash(asset);
        change(asset);
        QVERIFY(bakeInputHash(asset) != before);
    }
    void hashIgnoresWhatDoesNotAffectTheBake_data() {
        QTest::addColumn<AssetChange>("change");
        const auto row = [](const char* name, const AssetChange& change) { QTest::newRow(name) << change; };
        row("name", [](Asset& a) { a.name = "wall"; });
        row("material", [](Asset& a) { a.material = 2; });
        row("threshold", [](Asset& a) { a.threshold = 7.0; });
        row("scale", [](Asset& a) { a.insideUvScale = 2.0; });
        row("cut at impact", [](Asset& a) { a.cutAtImpact.emplace(); });
        row("requirements", [](Asset& a) { a.requirements.resize(1); });
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
    void hashIgnoresWhatDoesNotAffectTheBake() {
        QFETCH(AssetChange, change);
        Asset asset = hashedBox();
        const ContentHash before = bakeInputHash(asset);
        change(asset);
        QVERIFY(bakeInputHash(asset) == before);
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

RUBBLE_TEST(BakeHashTest)
#include "BakeHashTest.moc"
