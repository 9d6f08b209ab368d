// Tests editor/panels/inspector/AssetPage.cpp and editor/panels/inspector/ShapingSection.cpp.
#include "editor/panels/inspector/AssetPage.h"

#include "core/asset/checks/VerifyProject.h"
#include "editor/commands/ProjectEdits.h"
#include "editor/widgets/SliderField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/InspectorDesk.h"
#include "tests/support/files/TestImages.h"

#include <QLabel>
#include <QPushButton>

using namespace rubble;
using test::InspectorDesk;

class AssetPageTest : public QObject {
    Q_OBJECT
private slots:
    void typedNumbersChangeTheDocument() {
        InspectorDesk desk;
        desk.inspector.setLocale(QLocale(QLocale::German, QLocale::Germany));
        desk.selection.setAsset(9);
        desk.type("Threshold", "12,5");
        QCOMPARE(desk.asset().threshold, 12.5);
        desk.inspector.setUnits({LengthUnit::Centimetre});
        desk.type("Depth", "7,25");
        QCOMPARE(desk.asset().prism().depth, 0.0725);
        QCOMPARE(desk.document.undoStack().count(), 2);
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
        QCOMPARE(desk.control<NumberField>("Depth").value(), 0.5);
    }
    void assetsAreCutWhereTheyAreHit() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        QVERIFY(!desk.asset().cutAtImpact);
        auto& way = desk.control<QComboBox>("Break as");
        const auto select = [&](const char* text) {
            way.setCurrentIndex(way.findText(text));
            emit way.activated(way.currentIndex());
        };
        const auto note = [&] { return desk.inspector.findChild<QLabel*>("breakNote")->text(); };
        QVERIFY(note().contains("all of its fragments at once"));
        QVERIFY(!desk.control<NumberField>("Cut fragments").isVisible());
        select("Cut where hit");
        QVERIFY(note().contains("around the point of impact"));
        desk.type("Cut fragments", "50");
        desk.type("Cut radius", "0.75");
        QVERIFY((desk.asset().cutAtImpact == CutAtImpact{.fragments = 50, .falloffRadius = 0.75}));
        desk.type("Cut fragments", "1");
        QCOMPARE(desk.asset().cutAtImpact->fragments, 50U);
        select("Bonded");
        QVERIFY(desk.asset().breakAs == BreakAs::Bonded && note().contains("no longer held"));
        select("Whole");
        QVERIFY(desk.asset().breakAs == BreakAs::Whole && !desk.asset().cutAtImpact);
        QVERIFY(!verifyProject(desk.document.project()));
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
    void textureIsShownAndRemoved() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        auto* row = desk.inspector.findChild<QLabel*>("texture");
        QVERIFY(!row->isVisibleTo(&desk.inspector));
        Asset asset = desk.asset();
        asset.texture = Texture{.name = "checker.png",
                                .image = std::make_shared<const EncodedImage>(imageOf(checkerPng())),
                                .materials = {0}};
        desk.document.push(modify("import", asset));
        QVERIFY(row->isVisibleTo(&desk.inspector));
        QCOMPARE(row->text(), QString("checker.png (16 × 16)"));
        desk.inspector.findChild<QPushButton*>("removeTexture")->click();
        QVERIFY(!desk.asset().texture && !row->isVisibleTo(&desk.inspector));
        desk.document.undoStack().undo();
        QVERIFY(desk.asset().texture == asset.texture && row->isVisibleTo(&desk.inspector));
    }
    void fragmentsAreShaped() {
        InspectorDesk desk;
        desk.selection.setAsset(9);
        QVERIFY(!desk.control<SliderField>("Minimum size").isVisible());
        const auto select = [&](const QString& name, int row) {
            auto& box = desk.control<QComboBox>(name);
            box.setCurrentIndex(row);
            emit box.activated(row);
        };
        select("Small fragments", 1);
        QCOMPARE(desk.asset().shaping.smallPieces.rule, SmallPieceRule::Merge);
        QVERIFY(desk.control<SliderField>("Minimum size").isVisible());
        select("Measured by", 2);
        QCOMPARE(desk.asset().shaping.smallPieces.measure, PieceMeasure::Area);
        QCOMPARE(desk.asset().shaping.smallPieces.limit, 0.001);
        desk.type("Gap", "0.004");
        QCOMPARE(desk.asset().shaping.gap, 0.004);
        desk.type("Roughness", "0.01");
        QCOMPARE(desk.asset().shaping.roughness.amplitude, 0.01);
        select("Inside material", 2);
        QCOMPARE(desk.asset().insideMaterial, Id{2});
        QVERIFY(!verifyProject(desk.document.project()));
        desk.undoAll();
        QCOMPARE(desk.text(), projectText(fullProject()));
    }
};

RUBBLE_TEST_WITH(AssetPageTest, QApplication)
#include "AssetPageTest.moc"
