#include "editor/commands/BondStrokes.h"

#include "core/asset/project/Ranges.h"
#include "editor/document/Document.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QTest>

using namespace rubble;

class BondStrokesTest : public QObject {
    Q_OBJECT
private slots:
    void strengthsGoUpAndDownInSteps() {
        QCOMPARE(nextBrushStrength(2.0, 1), 3.0);
        QCOMPARE(nextBrushStrength(2.0, -1), 1.5);
        QCOMPARE(nextBrushStrength(2.5, 1), 3.0);
        QCOMPARE(nextBrushStrength(2.5, -1), 2.0);
        QCOMPARE(nextBrushStrength(10.0, 1), 10.0);
        QCOMPARE(nextBrushStrength(0.0, -1), 0.0);
    }
    void pathIsSimplifiedToAQuarterOfTheRadius() {
        BondStrokePath path({}, 0.1);
        for (const Vec2 point : {Vec2(0.0, 0.0), Vec2(0.5, 0.02), Vec2(1.0, 0.0)}) path.extend(point);
        QCOMPARE(path.stroke().points, (std::vector<Vec2>{{0.0, 0.0}, {1.0, 0.0}}));
        path.extend({1.0, 0.03});
        path.extend({1.0, 1.0});
        QCOMPARE(path.stroke().points, (std::vector<Vec2>{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}));
    }
    void onlyTheStrengthBrushHasAStrength() {
        QCOMPARE(BondStrokePath({.brush = BondBrush::Strength, .strength = 5.0}, 0.1).stroke().strength, 5.0);
        QCOMPARE(BondStrokePath({.brush = BondBrush::Anchor, .strength = 5.0}, 0.1).stroke().strength, 1.0);
        const BondBrushSettings erasing{.brush = BondBrush::Strength, .isErasing = true, .strength = 5.0};
        QCOMPARE(BondStrokePath(erasing, 0.1).stroke().strength, 1.0);
        QVERIFY(BondStrokePath(erasing, 0.1).stroke().isErasing);
    }
    void radiusIsInItsRange() {
        const NumberRange& range = rangeOf(ProjectNumber::BondBrushRadius);
        QVERIFY(range.contains(BondStrokePath({}, 1e9).stroke().radius));
        QVERIFY(range.contains(BondStrokePath({}, 1e-9).stroke().radius));
    }
    void strokesAreAppended() {
        Document document(boxProject(UniformScatter{.count = 8}));
        BondStrokePath path({.brush = BondBrush::NeverBreaks}, 0.1);
        path.extend({0.5, 0.5});
        QVERIFY(!hasStrokes(document.project().assets[0], BondBrush::NeverBreaks));
        QVERIFY(document.push(paintStroke(document.project().assets[0], path.stroke())));
        const Asset& painted = document.project().assets[0];
        QCOMPARE(painted.bonding.strokes, std::vector<BondStroke>{path.stroke()});
        QVERIFY(hasStrokes(painted, BondBrush::NeverBreaks) && !hasStrokes(painted, BondBrush::Anchor));
        QCOMPARE(document.undoStack().undoText(), QString("Paint Never Breaks"));
    }
};

RUBBLE_TEST(BondStrokesTest)
#include "BondStrokesTest.moc"
