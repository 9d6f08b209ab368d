#include "editor/panels/models/ImpactModel.h"

#include "tests/support/TestProgram.h"

#include <QAbstractItemModelTester>
#include <QGuiApplication>
#include <QSignalSpy>

using namespace rubble;

namespace {

const ImpactRecord kBreak{.step = 30, .name = "wall", .impact = 200.0, .threshold = 100.0, .fragmentCount = 40};
const ImpactRecord kWithstood{.step = 60, .name = "pane", .impact = 50.0, .threshold = 100.0};

}  // namespace

class ImpactModelTest : public QObject {
    Q_OBJECT
private slots:
    void rowsShowTimeBodyAndRatio() {
        ImpactModel model;
        const QAbstractItemModelTester tester(&model);
        model.setImpacts({kBreak, kWithstood}, 1.0 / 60.0);
        QCOMPARE(text(model, 0, ImpactModel::kTime), "0.50");
        QCOMPARE(text(model, 0, ImpactModel::kName), "wall");
        QCOMPARE(text(model, 0, ImpactModel::kRatio), "2×");
        QCOMPARE(text(model, 0, ImpactModel::kFragments), "40");
        QCOMPARE(text(model, 1, ImpactModel::kRatio), "0.5×");
        QCOMPARE(text(model, 1, ImpactModel::kFragments), "intact");
    }
    /// So that a list keeps its place while the simulation runs.
    void newImpactsAreInserted() {
        ImpactModel model;
        const QSignalSpy resets(&model, &QAbstractItemModel::modelReset), rows(&model, &ImpactModel::rowsInserted);
        model.setImpacts({kBreak}, 1.0 / 60.0);
        model.setImpacts({kBreak, kWithstood}, 1.0 / 60.0);
        QCOMPARE(rows.count(), 2);
        QCOMPARE(resets.count(), 0);
        model.setImpacts({kWithstood}, 1.0 / 60.0);  // another course of the simulation
        QCOMPARE(resets.count(), 1);
        QCOMPARE(model.rowCount(), 1);
    }
    void whatStayedIntactIsFaint() {
        ImpactModel model;
        model.setImpacts({kBreak, kWithstood}, 1.0 / 60.0);
        QVERIFY(!model.data(model.index(0, 0), Qt::ForegroundRole).isValid());
        QVERIFY(model.data(model.index(1, 0), Qt::ForegroundRole).isValid());
    }

private:
    static QString text(const ImpactModel& model, int row, int column) {
        return model.data(model.index(row, column), Qt::DisplayRole).toString();
    }
};

RUBBLE_TEST_WITH(ImpactModelTest, QGuiApplication)
#include "ImpactModelTest.moc"
