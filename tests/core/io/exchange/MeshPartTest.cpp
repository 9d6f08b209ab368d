#include "core/io/exchange/MeshPart.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

Material brick() { return {.id = 1, .name = "brick", .outside = {0.5, 0.5, 0.5}, .inside = {1.0, 0.0, 0.0}}; }

std::vector<std::string> outsideNames(const MeshMaterials& materials) {
    std::vector<std::string> names;
    for (const MeshMaterial& material : materials.outside) names.push_back(material.name);
    return names;
}

}  // namespace

class MeshPartTest : public QObject {
    Q_OBJECT
private slots:
    void namesHaveNoSpaces() {
        QCOMPARE(meshName("wall"), std::string("wall"));
        QCOMPARE(meshName("old wall #2"), std::string("old_wall__2"));
        QCOMPARE(meshName("Größe"), std::string("Größe"));
        QCOMPARE(meshName(""), std::string("_"));
    }
    void materialsAreNamedAfterTheAssets() {
        const Material clay{.id = 7, .name = "red clay", .inside = {0.7, 0.2, 0.1}};
        const Material own = brick();
        QCOMPARE(meshMaterials({}, {own, clay}).inside.name, std::string("red_clay_inside"));
        QVERIFY(meshMaterials({}, {own, clay}).inside.colour == clay.inside);
        const MeshMaterials materials = meshMaterials({}, brick());
        QVERIFY(outsideNames(materials) == std::vector<std::string>{"brick_outside"});
        QCOMPARE(materials.inside.name, std::string("brick_inside"));
        QVERIFY(materials.inside.colour == brick().inside);
    }
    void importersActOnSomeNames() {
        for (const char* name : {"leaf_alpha", "leaf-Alpha", "Leaf$alpha_02", "glass_vcol 3"})
            QVERIFY(importerEffect(name));
        for (const char* name : {"alpha", "leafalpha", "alpha_leaf", "brick_outside", "glass_inside", ""})
            QVERIFY(!importerEffect(name));
        QCOMPARE(*importerEffect("leaf_alpha"), std::string("makes it transparent"));
    }
    void importedMeshKeepsItsMaterialNames() {
        Surface surface;
        surface.materials = {"plaster", "brick_inside", "plaster"};
        Asset asset;
        asset.surface = std::make_shared<const Surface>(surface);
        const MeshMaterials materials = meshMaterials(asset, brick());
        QVERIFY((outsideNames(materials) == std::vector<std::string>{"plaster", "brick_inside_2", "plaster_2"}));
        QVERIFY(materials.outside[2].colour == brick().outside);
    }
    void importedMeshWithoutMaterialsUsesTheAssets() {
        Asset asset;
        asset.surface = std::make_shared<const Surface>();
        QVERIFY(outsideNames(meshMaterials(asset, brick())) == std::vector<std::string>{"brick_outside"});
    }
};

RUBBLE_TEST(MeshPartTest)
#include "MeshPartTest.moc"
