#include "editor/panels/docks/StepGraph.h"

#include "tests/support/TestProgram.h"

#include <QApplication>

using namespace rubble;

class StepGraphTest : public QObject {
    Q_OBJECT
private slots:
    void lastStepIsReadOut() {
        StepGraph graph;
        graph.setCosts({{.step = 1, .solve = 9.0}, {.step = 2, .pairs = 0.5, .solve = 0.75}}, 10);
        QCOMPARE(graph.accessibleDescription(), QString("1.25\u00a0ms"));
    }
    void toolTipNamesTheUnit() { QVERIFY(StepGraph().toolTip().contains("milliseconds")); }
    /// Each stage has a colour; a stage that costs nothing has none in the graph.
    void stagesAreStackedByTheirCost() {
        const QColor solver(0, 158, 115);
        const auto solverPixels = [&](const StepCost& cost) {
            StepGraph graph;
            graph.resize(graph.sizeHint());
            graph.setCosts(std::vector(20, cost), 20);
            const QImage image = graph.grab().toImage();
            int count = 0;
            for (int y = 0; y < image.height(); ++y) {
                for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == solver ? 1 : 0;
            }
            return count;
        };
        const int most = solverPixels({.collide = 0.25, .solve = 0.75});
        const int half = solverPixels({.collide = 0.5, .solve = 0.5});
        const int none = solverPixels({.collide = 1.0});  // that of the legend
        QVERIFY2(most > half && half > none, qPrintable(QString("%1 %2 %3").arg(most).arg(half).arg(none)));
    }
};

RUBBLE_TEST_WITH(StepGraphTest, QApplication)
#include "StepGraphTest.moc"
