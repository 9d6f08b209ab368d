// Tests editor/actions/SelectActions.cpp, editor/actions/ViewActions.cpp and editor/document/CellSelection.cpp.
#include "core/fracture/pattern/PatternPartition.h"
#include "editor/canvas/tools/BrushTool.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/editor/EditorStory.h"

#include <set>

using namespace rubble;

namespace {

/// A box of 1 m of bricks, without seeds.
Project bricks() { return boxProject(BrickBond{.length = 0.49, .height = 0.24}); }

}  // namespace

/// Selecting cells of bricks and painting, by mouse and keys.
class PatternStoryTest : public EditorStory {
    Q_OBJECT
private slots:
    void initTestCase() { openBaked(bricks()); }
    void cleanupTestCase() { close(); }

    void bricksAreSelectedLikeSeeds() {
        canvas().setFocus();
        QTest::keyClick(&canvas(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(selection().seeds(), cells());
        QTest::keyClick(&canvas(), Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(selection().seeds().empty());
    }
    void boxSelectsBricksAndDeleteKeepsThem() {
        drag(canvas(), pixels({-0.02, 0.24}), pixels({1.02, -0.02}));
        QVERIFY(selection().seeds().size() >= 2 && selection().seeds().size() <= 3);  // the lowest course
        QTest::keyClick(&canvas(), Qt::Key_Delete);
        QTest::keyClick(&canvas(), Qt::Key_Right);
        QCOMPARE(text(), m_before);
        QTest::keyClick(&canvas(), Qt::Key_Escape);
        QVERIFY(selection().seeds().empty());
    }
    void neighboursOfABrickShareAnEdge() {
        QTest::mouseClick(&canvas(), Qt::LeftButton, {}, pixels({0.25, 0.375}));
        QCOMPARE(selection().seeds().size(), std::size_t{1});
        QTest::keyClick(&canvas(), Qt::Key_G, Qt::ControlModifier);
        const std::size_t count = selection().seeds().size();
        QVERIFY2(count >= 4 && count <= 7,
                 qPrintable(QString::number(count)));  // above, below and beside in running bond
    }
    void bracketsResizeTheActiveBrush() {
        QTest::keyClick(&canvas(), Qt::Key_B, Qt::AltModifier);
        const double radius = canvas().brushTool().radiusPixels();
        const Selection::Seeds selected = selection().seeds();
        QTest::keyClick(&canvas(), Qt::Key_BracketRight);
        QVERIFY(canvas().brushTool().radiusPixels() > radius);
        QTest::keyClick(&canvas(), Qt::Key_BracketLeft);
        QCOMPARE(canvas().brushTool().radiusPixels(), radius);
        QCOMPARE(selection().seeds(), selected);
    }

private:
    Selection::Seeds cells() {
        const auto pattern = window().workspace().bakes().findPattern(2);
        Selection::Seeds all;
        for (std::uint32_t piece = 0; piece < pattern->partition.pieceCount(); ++piece) {
            all.insert(cellId(pattern->partition, piece, pattern->seeds.ids));
        }
        return all;
    }
};

RUBBLE_TEST_WITH(PatternStoryTest, QApplication)
#include "PatternStoryTest.moc"
