#include "editor/commands/MaterialEdits.h"

#include "core/asset/library/StarterProject.h"
#include "core/asset/strength/Threshold.h"
#include "core/io/project/MaterialPresetFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/EditedProject.h"

#include <QTest>

using namespace rubble;

namespace {

MaterialPreset preset(const char* name) { return findMaterial(materialLibrary(), name)->preset; }

}  // namespace

class MaterialEditsTest : public QObject {
    Q_OBJECT
private slots:
    void presetIsAddedOnce() {
        Addition first = addMaterial(starterProject(), preset("glass"));
        const Project project = test::editedProject(starterProject(), first.edit);
        QCOMPARE(project.materials.size(), std::size_t{2});
        QCOMPARE(*findMaterial(project, first.id)->tensileStrength, 4.5e7);
        const Addition again = addMaterial(project, preset("glass"));
        QVERIFY(again.edit.isEmpty());
        QCOMPARE(again.id, first.id);
    }
    void takenNameGetsANumber() {
        Project before = starterProject();
        before.materials[0].density = 1300.0;  // differs from the plaster of the library
        const Addition added = addMaterial(before, preset("plaster"));
        const Project project = test::editedProject(before, added.edit);
        QCOMPARE(findMaterial(project, added.id)->name, std::string("plaster 2"));
    }
    void appliesPatternAndThreshold() {
        const Project before = starterProject();
        const Id wall = before.assets[0].id;
        const Project project = test::editedProject(before, applyPreset(before, wall, preset("glass"), {true, true}));
        const Asset& asset = *findAsset(project, wall);
        QCOMPARE(findMaterial(project, asset.material)->name, std::string("glass"));
        QCOMPARE(asset.pattern.layers.size(), std::size_t{1});
        QVERIFY(std::holds_alternative<RadialCracks>(asset.pattern.layers[0].parameters));
        QCOMPARE(asset.contactTime.value_or(0.0), kDefaultContactTime);
        QCOMPARE(thresholdOf(project, asset),
                 bendingStrength(asset, *findMaterial(project, asset.material))->threshold());
    }
    void cutsAreAsRoughAsThoseOfTheMaterial() {
        Project project = starterProject();
        const Id wall = project.assets[0].id;
        for (const auto& [name, amplitude] : {std::pair{"stone", 0.02}, {"concrete", 0.012}, {"glass", 0.0}}) {
            project = test::editedProject(project, applyPreset(project, wall, preset(name), {.appliesPattern = true}));
            QCOMPARE(findAsset(project, wall)->shaping.roughness.amplitude, amplitude);
            const Project kept = test::editedProject(project, applyPreset(project, wall, preset("plaster"), {}));
            QCOMPARE(findAsset(kept, wall)->shaping.roughness.amplitude, amplitude);
        }
    }
    void keepsTheContactTimeOfDerivedThresholds() {
        Project before = starterProject();
        before.assets[0].contactTime = 0.004;
        const Id wall = before.assets[0].id;
        const Project applied =
            test::editedProject(before, applyPreset(before, wall, preset("glass"), {.derivesThreshold = true}));
        QCOMPARE(applied.assets[0].contactTime.value_or(0.0), 0.004);
    }
    void appliesOnlyWhatTheOptionsSay() {
        Project before = starterProject();
        enterThreshold(before.assets[0], 100.0);
        const Id wall = before.assets[0].id;
        const Project project = test::editedProject(before, applyPreset(before, wall, preset("ice"), {}));
        QVERIFY(findAsset(project, wall)->pattern == before.assets[0].pattern);
        QVERIFY(!findAsset(project, wall)->contactTime);
    }
    void newPatternRemovesFragmentEdits() {
        Project before = starterProject();
        Asset& wall = before.assets[0];
        const std::string layer = std::to_string(wall.pattern.layers[0].id);
        wall.edits = {FragmentMerge{.into = layer + ".1", .merged = {layer + ".2"}}};
        wall.fragmentLevels = {{.fragment = layer + ".3", .level = {}}};
        wall.fragmentThresholds = {{layer + ".4", 2.5}};
        wall.bonding.neverBreaks = {layer + ".5"};
        wall.bonding.clusters = {{0, {layer + ".5", layer + ".6"}}};
        const Project project =
            test::editedProject(before, applyPreset(before, wall.id, preset("stone"), {.appliesPattern = true}));
        QVERIFY(project.assets[0].edits.empty() && project.assets[0].fragmentLevels.empty());
        QVERIFY(project.assets[0].fragmentThresholds.empty() && project.assets[0].bonding.neverBreaks.empty());
        QVERIFY(project.assets[0].bonding.clusters.empty());
        const Project kept = test::editedProject(before, applyPreset(before, wall.id, preset("stone"), {}));
        QVERIFY(!kept.assets[0].edits.empty() && !kept.assets[0].fragmentLevels.empty());
    }
    void presetHasThePatternOfAnAsset() {
        const Project before = starterProject();
        const MaterialPreset made = presetFrom(before, before.materials[0].id, 0);
        QCOMPARE(made.name, std::string("plaster"));
        QCOMPARE(made.pattern.layers.size(), std::size_t{1});
        QCOMPARE(made.pattern.layers[0].id, Id{1});
        QVERIFY(!verifyPreset(made));
        QVERIFY(made.roughness == before.assets[0].shaping.roughness);
        const Project alone = emptyProject();
        QVERIFY(presetFrom(alone, alone.materials[0].id, 0).pattern.layers.empty());
    }
};

RUBBLE_TEST_WITH(MaterialEditsTest, QCoreApplication)
#include "MaterialEditsTest.moc"
