#include "core/io/PackFile.h"
#include "tests/support/Projects.h"
#include "tests/support/Schemas.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr double kDensity = 1800.0;

Material brick() { return {.id = 1, .name = "brick", .density = kDensity}; }

const std::vector<PackMeshFile>& meshes() {
    static const std::vector<PackMeshFile> files{{.name = "box.obj"}, {"box0.obj", PackMeshBodies::Fragment, 0, {}}};
    return files;
}

/// A square ring of two levels: cut-apart cells, several hulls a body, pieces of pieces.
Asset ringAsset() {
    Asset asset = boxAsset(3, 4, UniformScatter{.count = 5});
    asset.prism.outline = squareRing();
    asset.levels = {{.pattern = {{{.id = 5, .randomSeed = 2, .parameters = UniformScatter{.count = 3}}}}}};
    return asset;
}

std::string packOf(const Asset& asset, int threads = 1) {
    const Result<Bake> baked = bake(asset);
    TaskContext task;
    task.threads = threads;
    return packJson(*baked, asset, brick(), meshes(), task);
}

}  // namespace

class PackFileTest : public QObject {
    Q_OBJECT
private slots:
    void writtenPacksFitTheSchema() {
        const test::Schema schema("pack.schema.json");
        for (const Asset& asset :
             {boxAsset(3, 4, UniformScatter{.count = 9}), ringAsset(), boxAsset(3, 4, PlacedSeeds{})}) {
            const std::string json = packOf(asset);
            QCOMPARE(schema.fault(nlohmann::json::parse(json)), std::string());
        }
    }
    void threadsDoNotChangeTheBytes() {
        const Asset asset = boxAsset(3, 4, UniformScatter{.count = 300});
        QCOMPARE(packOf(asset, 4), packOf(asset, 1));
    }
    void wholeBoxIsWrittenAsComputedByHand() {
        const nlohmann::json whole = nlohmann::json::parse(packOf(boxAsset(3, 4, PlacedSeeds{})))["whole"];
        QVERIFY(whole["id"] == "3");
        QVERIFY(whole["name"] == "box");
        QVERIFY(whole["parent"].is_null());
        QVERIFY(whole["offset"] == nlohmann::json({0.5, 0.5, 0.0}));
        QVERIFY(whole["volume"] == 0.5);
        QVERIFY(whole["mass"] == 0.5 * kDensity);
        QVERIFY(whole["inertia"][2][2] == 0.5 * kDensity * (1.0 + 1.0) / 12.0);
        QCOMPARE(whole["hulls"].size(), std::size_t{1});
        QVERIFY(whole["hulls"][0]["planes"][0] == nlohmann::json({0.0, 0.0, 1.0, 0.25}));
        QVERIFY(whole["hulls"][0]["signedEdges"][1] == nlohmann::json::parse("[[6,-1],[5,-1],[4,-1],[7,-1]]"));
    }
    void hashDependsOnAllThatIsWritten() {
        const Asset asset = ringAsset();
        const ContentHash hash = packHash(asset, brick(), meshes());
        QCOMPARE(packHash(ringAsset(), brick(), meshes()), hash);
        Asset stronger = asset;
        stronger.threshold += 1.0;
        QVERIFY(packHash(stronger, brick(), meshes()) != hash);
        Asset deeper = asset;
        deeper.prism.depth += 1.0;
        QVERIFY(packHash(deeper, brick(), meshes()) != hash);
        Material heavier = brick();
        heavier.density += 1.0;
        QVERIFY(packHash(asset, heavier, meshes()) != hash);
        QVERIFY(packHash(asset, brick(), {}) != hash);
    }
};

QTEST_APPLESS_MAIN(PackFileTest)
#include "PackFileTest.moc"
