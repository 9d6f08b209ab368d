#include "core/fracture/pattern/PatternCuts.h"

#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

const CrackLines kLine{{{0, {{0.0, 0.5}, {1.0, 0.5}}}}};

}  // namespace

class PatternCutsTest : public QObject {
    Q_OBJECT
private slots:
    void enabledLayersCutInTheirOrder() {
        const Pattern pattern{{{.id = 2, .parameters = Slices{.cuts = 3}},
                               {.id = 5, .parameters = UniformScatter{.count = 4}},
                               {.id = 3, .isOn = false, .parameters = kLine},
                               {.id = 4, .parameters = kLine}}};
        const Result<CutSet> cuts = cutsOf(pattern, unitSquare());
        QVERIFY(cuts);
        QCOMPARE(cuts->layers.size(), std::size_t{2});
        QCOMPARE(cuts->layers[0].id, 2u);
        QCOMPARE(cuts->layers[0].edgesEnd, 3u);
        QCOMPARE(cuts->layers[1].id, 4u);
        QCOMPARE(cuts->edges.size(), std::size_t{4});
    }
    void seedsAreNoCuts() {
        QVERIFY(!hasCuts({{{.id = 1, .parameters = UniformScatter{.count = 4}}}}));
        QVERIFY(!hasCuts({{{.id = 1, .isOn = false, .parameters = kLine}}}));
        QVERIFY(hasCuts({{{.id = 1, .parameters = kLine}}}));
    }
    void jointIsTheWidestMortar() {
        QCOMPARE(jointWidthOf({}), 0.0);
        const Pattern pattern{{{.id = 1, .parameters = BrickBond{.mortar = 0.01}},
                               {.id = 2, .parameters = BrickBond{.mortar = 0.02}},
                               {.id = 3, .isOn = false, .parameters = BrickBond{.mortar = 0.04}}}};
        QCOMPARE(jointWidthOf(pattern), 0.02);
    }
    void invalidPatternIsRefused() {
        const Result<CutSet> cuts = cutsOf({{{.id = 6, .parameters = CrackLines{{{0, {{0.0, 0.5}}}}}}}}, unitSquare());
        QVERIFY(!cuts && cuts.error().code == ErrorCode::BadInput);
        QVERIFY2(cuts.error().message.find("crack line 0") != std::string::npos, cuts.error().message.c_str());
    }
    void cancelledTaskStops() {
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(cutsOf({{{.id = 1, .parameters = kLine}}}, unitSquare(), task).error().code, ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(PatternCutsTest)
#include "PatternCutsTest.moc"
