#include "app/thesis/ThesisCells.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/JsonCases.h"

#include <QTest>

#include <limits>

using namespace rubble;

class ThesisCellsTest : public QObject {
    Q_OBJECT
private slots:
    void thesisMethodReproducesItsErrors() {
        const test::Counterexample example = test::counterexamples()[0];  // R1_origin_square3
        const std::string json = thesisJson({{example.outline, 1.0}, example.seeds});
        const QJsonObject output = QJsonDocument::fromJson(QByteArray::fromStdString(json)).object();
        QVERIFY(std::abs(output["cells"][0]["area"].toDouble() - 0.370606061) < 1e-9);
        QVERIFY(std::abs(example.areas[0] - 0.2956060606060606) < 1e-15);
    }
    void thesisCellsNeedThreeFiniteCorners() {
        const double nan = std::numeric_limits<double>::quiet_NaN();
        ThesisDiagram diagram;
        diagram.triangles = {{0, 1, 2}, {1, 3, 2}};
        diagram.cells = {
            {{0, 0}, {0, 2}, {2, 0}}, {{0, 0}, {1, 1}}, {{0, 0}, {nan, 1}, {1, 0}}, {{0, 0}, {1, 0}, {0, 1}}};
        const std::vector<Cell> cells = thesisCells(diagram);
        QCOMPARE(cells.size(), std::size_t{2});
        QCOMPARE(cells[0].area, 2.0);
        QVERIFY(signedArea(cells[0].pieces[0].outer) > 0.0);
        QCOMPARE(cells[0].neighbours, (std::vector<std::uint32_t>{1, 2}));
        QCOMPARE(cells[1].seed, 3u);
        QCOMPARE(cells[1].neighbours, (std::vector<std::uint32_t>{1, 2}));
    }
};

RUBBLE_TEST(ThesisCellsTest)
#include "ThesisCellsTest.moc"
