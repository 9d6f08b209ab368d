// Tests editor/panels/inspector/LayerPage.cpp and editor/panels/inspector/LayerSection.cpp.
#include "editor/panels/inspector/LayerPage.h"

#include "editor/commands/AssetPatterns.h"
#include "editor/panels/inspector/PatternEditor.h"
#include "editor/widgets/RandomSeedField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshAsset.h"
#include "tests/support/editor/InspectorDesk.h"

#include <QPushButton>
#include <QToolButton>

#include <algorithm>

using namespace rubble;
using test::InspectorDesk;

class LayerPageTest : public QObject {
    Q_OBJECT
private slots:
    void everyParameterOfEveryKindIsEditable() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        for (const PatternKind* kind : patternKinds()) {
            editor.addLayer(kind->defaultsFor(domainBounds(desk.asset())));
            const PatternLayer added = desk.asset().pattern.layers.back();
            for (const LayerParameter& parameter : kind->parameters) {
                if (parameter.type != ParameterType::Real || !parameter.isUsed(added.parameters)) continue;
                auto& field = desk.control<NumberField>(parameter.caption);
                QVERIFY2(field.isVisible() == !parameter.isSpatial, parameter.caption);
                if (parameter.isSpatial) continue;           // of meshes only
                if (parameter.name == "minDepth") continue;  // below the other depth
                const bool isWithin = parameter.range.contains(0.75);
                desk.type(parameter.caption, isWithin ? "0.75" : "1.5");
                const double factor = parameter.quantity == Quantity::Angle ? 0x1.1df46a2529d39p-6 : 1.0;
                const auto typed = std::get<double>(parameter.read(desk.asset().pattern.layers.back().parameters));
                QVERIFY2(std::abs(typed - (isWithin ? 0.75 : 1.5) * factor) < 1e-15, parameter.caption);
            }
        }
        QCOMPARE(desk.refusals.count(), 0);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void pointAndOptionParametersAreEditable() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        editor.addLayer(RadialPattern{});
        desk.type("Centre y", "0.25");
        QVERIFY(std::get<RadialPattern>(desk.asset().pattern.layers.back().parameters).centre == Vec2(0.0, 0.25));
        editor.addLayer(JitteredGrid{});
        QVERIFY(desk.control<NumberField>("Columns").isVisible() &&
                !desk.control<NumberField>("Cell width").isVisible());
        auto& grid = desk.control<QComboBox>("Grid");
        grid.setCurrentIndex(1);
        emit grid.activated(1);
        QVERIFY(!desk.control<NumberField>("Columns").isVisible() &&
                desk.control<NumberField>("Cell width").isVisible());
        desk.type("Jitter", "1.5");
        QCOMPARE(std::get<JitteredGrid>(desk.asset().pattern.layers.back().parameters).jitter, 0.5);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void seedsOfMeshesAreScatteredInTheMesh() {
        const auto domains = [](InspectorDesk& desk, Id asset) {
            desk.selection.setAsset(asset);
            const auto& box = desk.control<QComboBox>("Domain");
            return QStringList{box.itemText(0), box.itemText(1)};
        };
        InspectorDesk desk;
        QCOMPARE(domains(desk, 9), (QStringList{"Outline", "Bounding box"}));
        InspectorDesk meshes(
            {.nextId = 9, .materials = {{.id = 1}}, .assets = {test::meshAsset(test::cubes({{0, 0, 0}}), 5)}});
        QCOMPARE(domains(meshes, 3), (QStringList{"Mesh", "Bounding box"}));
    }
    void countsAreExpressedInThreeWays() {
        InspectorDesk desk;
        desk.selection.setAsset(9);  // a square metre
        const auto count = [&] { return std::get<UniformScatter>(desk.asset().pattern.layers[0].parameters).count; };
        const auto select = [&](int way) {
            auto& box = desk.control<QComboBox>("Count by");
            box.setCurrentIndex(way);
            emit box.activated(way);
        };
        desk.type("Count", "25");
        select(1);
        QVERIFY(count() == SeedCount(CountBy::Density, 25.0));
        select(2);
        QVERIFY(count() == SeedCount(CountBy::FragmentSize, 0.2));
        desk.type("Fragment size", "0.1");
        select(0);
        QVERIFY(count() == SeedCount(100));
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void overridesAreRestoredAndSeedsRandomized() {
        InspectorDesk desk;
        desk.selection.setAsset(3);
        auto& editor = *desk.inspector.page().findChild<PatternEditor*>();
        editor.showLayer(4);
        const auto buttons = editor.findChildren<QPushButton*>();
        const auto restore = std::ranges::find(buttons, "Restore Seeds", &QPushButton::text);
        QVERIFY(restore != buttons.end());
        QTest::mouseClick(*restore, Qt::LeftButton);
        QVERIFY(desk.asset(3).pattern.layers[0].overrides.empty());
        QVERIFY(!(*restore)->isEnabled());
        auto& seed = *editor.findChild<RandomSeedField*>();
        QCOMPARE(seed.value(), ~quint64{0});
        QTest::mouseClick(&seed.randomizeButton(), Qt::LeftButton);
        QVERIFY(desk.asset(3).pattern.layers[0].randomSeed < 1'000'000u);
        seed.line().setFocus();
        seed.line().selectAll();
        QTest::keyClicks(&seed.line(), "-3");
        QTest::keyClick(&seed.line(), Qt::Key_Return);
        QCOMPARE(desk.refusals.count(), 1);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
};

RUBBLE_TEST_WITH(LayerPageTest, QApplication)
#include "LayerPageTest.moc"
