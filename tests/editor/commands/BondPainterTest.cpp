#include "editor/commands/BondPainter.h"

#include "editor/commands/ProjectEdits.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

Project paintableProject() {
    Project project = boxProject(UniformScatter{.count = 8});
    project.assets[0].breakAs = BreakAs::Bonded;
    return project;
}

struct PainterBench {
    explicit PainterBench(Project project = paintableProject()) : document(std::move(project)) {
        selection.prune(document.project());
    }
    const std::vector<BondStroke>& strokes() const { return document.project().assets[0].bonding.strokes; }
    void begin() { painter.begin({0.25, 0.5}, 0.1, {}); }
    void rename() {
        Asset renamed = document.project().assets[0];
        renamed.name = "renamed";
        document.push(modify("Rename", std::move(renamed)));
    }

    Document document;
    Selection selection;
    BondPainter painter{document, selection};
};

}  // namespace

class BondPainterTest : public QObject {
    Q_OBJECT
private slots:
    void strokeIsOneEdit() {
        PainterBench bench;
        bench.begin();
        bench.painter.extend({0.75, 0.5});
        QCOMPARE(bench.painter.stroke()->points.size(), std::size_t{2});
        QVERIFY(bench.strokes().empty());
        bench.painter.finish();
        QCOMPARE(bench.painter.stroke(), nullptr);
        const BondStroke expected{.brush = BondBrush::Anchor, .radius = 0.1, .points = {{0.25, 0.5}, {0.75, 0.5}}};
        QCOMPARE(bench.strokes(), std::vector<BondStroke>{expected});
        QCOMPARE(bench.document.undoStack().count(), 1);
        QCOMPARE(bench.document.undoStack().undoText(), QString("Paint Anchors"));
    }
    void canceledStrokeIsNoEdit() {
        PainterBench bench;
        QVERIFY(!bench.painter.cancel());
        bench.begin();
        QVERIFY(bench.painter.cancel());
        bench.painter.extend({0.75, 0.5});
        bench.painter.finish();
        QVERIFY(bench.strokes().empty());
        QVERIFY(!bench.document.undoStack().canUndo());
    }
    void changesOfTheAssetCancelTheStroke() {
        PainterBench bench;
        bench.begin();
        bench.rename();
        QCOMPARE(bench.painter.stroke(), nullptr);
        bench.begin();
        bench.document.undoStack().undo();
        QCOMPARE(bench.painter.stroke(), nullptr);
        bench.begin();
        bench.selection.setAsset(0);
        QCOMPARE(bench.painter.stroke(), nullptr);
    }
    void secondStrokeReplacesAFirst() {
        PainterBench bench;
        bench.begin();
        bool wasCanceled = false;
        connect(&bench.painter, &BondPainter::changed, this,
                [&] { wasCanceled = wasCanceled || !bench.painter.stroke(); });
        bench.painter.begin({0.5, 0.5}, 0.2, {});
        QVERIFY(wasCanceled);
        bench.painter.finish();
        QCOMPARE(bench.strokes().size(), std::size_t{1});
        QCOMPARE(bench.strokes()[0].radius, 0.2);
    }
    void switchingOffCancelsTheStroke() {
        PainterBench bench;
        QVERIFY(!bench.painter.isOn());
        bench.painter.setOn(true);
        bench.begin();
        bench.painter.setOn(false);
        QCOMPARE(bench.painter.stroke(), nullptr);
    }
    void shiftInvertsErasing() {
        PainterBench bench;
        QVERIFY(bench.painter.erases(Qt::ShiftModifier) && !bench.painter.erases({}));
        bench.painter.setErasing(true);
        QVERIFY(!bench.painter.erases(Qt::ShiftModifier) && bench.painter.erases({}));
    }
    void onlyPaintedBondsAreErased() {
        PainterBench bench;
        QVERIFY(bench.painter.refusal(Qt::ShiftModifier).contains("no strokes of this brush"));
        QVERIFY(bench.painter.refusal({}).isEmpty());
        bench.begin();
        bench.painter.finish();
        QVERIFY(bench.painter.refusal(Qt::ShiftModifier).isEmpty());
        bench.painter.begin({0.25, 0.5}, 0.1, Qt::ShiftModifier);
        bench.painter.finish();
        QVERIFY(bench.strokes()[1].isErasing);
    }
    void wholeAssetsAreNotPainted() {
        PainterBench bench(boxProject(UniformScatter{.count = 8}));
        QCOMPARE(bench.painter.asset(), nullptr);
        QVERIFY(bench.painter.refusal({}).contains("breaks whole"));
    }
    void keysChangeTheSettings() {
        PainterBench bench;
        BondPainter& painter = bench.painter;
        QSignalSpy changes(&painter, &BondPainter::changed);
        const double radius = painter.radiusPixels();
        QVERIFY(painter.key(Qt::Key_BracketRight) && painter.radiusPixels() > radius);
        QVERIFY(painter.key(Qt::Key_BracketLeft) && painter.radiusPixels() == radius);
        QVERIFY(painter.key(Qt::Key_X) && painter.settings().isErasing);
        QCOMPARE(changes.count(), 3);
        QVERIFY(!painter.key(Qt::Key_Period) && !painter.key(Qt::Key_Escape));
        painter.setBrush(BondBrush::Strength);
        QVERIFY(painter.key(Qt::Key_Period) && painter.settings().strength == 3.0);
        QVERIFY(painter.key(Qt::Key_Comma) && painter.settings().strength == 2.0);
        painter.setStrength(99.0);
        QCOMPARE(painter.settings().strength, 10.0);
    }
};

RUBBLE_TEST(BondPainterTest)
#include "BondPainterTest.moc"
