#include "editor/panels/models/ProblemModel.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QAbstractItemModelTester>
#include <QApplication>

using namespace rubble;

namespace {

/// A sliver in a fragment, and a gap at a point.
std::vector<Diagnostic> problems() {
    DiagnosticPlace fragment{.asset = 2, .fragment = 4}, point{.asset = 2};
    point.point = DiagnosticPlace::Point{0.25, -0.5};
    return {diagnostic(DiagnosticCode::Sliver, fragment, "The fragment is thin.", 12.0, 10.0),
            diagnostic(DiagnosticCode::Gap, point, "There is a gap.", 0.0004)};
}

}  // namespace

class ProblemModelTest : public QObject {
    Q_OBJECT
private slots:
    void rowsNameKindPlaceAndAsset() {
        const Document document(boxProject(UniformScatter{.count = 4}));
        ProblemModel model(document);
        const QAbstractItemModelTester tester(&model);
        model.setProblems(problems(), {"3.4", {}});
        QCOMPARE(text(model, 0, ProblemModel::kKind), "Sliver");
        QCOMPARE(text(model, 0, ProblemModel::kLocation), "3.4");
        QCOMPARE(text(model, 0, ProblemModel::kAsset), QString::fromStdString(document.project().assets[0].name));
        QCOMPARE(text(model, 0, ProblemModel::kText), "The fragment is thin.");
        QCOMPARE(text(model, 0, ProblemModel::kValue), "12 : 1");
        QCOMPARE(text(model, 0, ProblemModel::kLimit), "10 : 1");
        QCOMPARE(text(model, 1, ProblemModel::kLimit), "");
    }
    void pointsAndAreasFollowTheUnit() {
        const Document document(boxProject(UniformScatter{.count = 4}));
        ProblemModel model(document);
        model.setProblems(problems(), {"3.4", {}});
        QCOMPARE(text(model, 1, ProblemModel::kLocation), QString("0.25, -0.5\u00a0m"));
        model.setUnits({LengthUnit::Centimetre});
        QCOMPARE(text(model, 1, ProblemModel::kLocation), QString("25, -50\u00a0cm"));
        QCOMPARE(text(model, 1, ProblemModel::kValue), QString("4\u00a0cm²"));
    }
    /// A list sorted by value begins or ends with the worst, whatever their units are.
    void valuesAreSortedByBadness() {
        const Document document(boxProject(UniformScatter{.count = 4}));
        ProblemModel model(document);
        model.setProblems(problems(), {"3.4", {}});
        for (int row = 0; row < 2; ++row) {
            const QVariant key = model.data(model.index(row, ProblemModel::kValue), ProblemModel::kSortRole);
            QCOMPARE(key.toDouble(), badness(model.problem(row)));
        }
    }

private:
    static QString text(const ProblemModel& model, int row, int column) {
        return model.data(model.index(row, column), Qt::DisplayRole).toString();
    }
};

RUBBLE_TEST_WITH(ProblemModelTest, QApplication)
#include "ProblemModelTest.moc"
