#include "app/thesis/ThesisMethod.h"

#include "tests/support/TestProgram.h"
#include "tests/support/files/JsonCases.h"

#include <QTest>

using namespace rubble;

namespace {

QJsonArray cases() {
    return test::readJson(RUBBLE_SOURCE_DIR "/tests/data/thesis-counterexamples.json")["cases"].toArray();
}

}  // namespace

class ThesisMethodTest : public QObject {
    Q_OBJECT
private slots:
    void areasMatchTheReference_data() {
        QTest::addColumn<QJsonObject>("example");
        for (const QJsonValue& example : cases()) {
            QTest::newRow(qPrintable(example["name"].toString())) << example.toObject();
        }
    }
    void areasMatchTheReference() {
        QFETCH(QJsonObject, example);
        const QJsonArray expected = example["thesisMethodAreas"].toArray();
        const ThesisDiagram diagram =
            thesisDiagram(test::pointsOf(example["outline"]), test::pointsOf(example["seeds"]));
        QCOMPARE(diagram.cells.size(), std::size_t(expected.size()));
        for (qsizetype seed = 0; seed < expected.size(); ++seed) {
            const double area = std::abs(signedArea(diagram.cells[std::size_t(seed)]));
            if (expected[seed].isNull()) {
                QVERIFY2(std::isnan(area), qPrintable(QString::number(area)));
            } else {  // the listed areas have nine digits
                const double listed = expected[seed].toDouble();
                QVERIFY2(std::abs(area - listed) <= 1e-8 * std::max(listed, 1e-3),
                         qPrintable(QString("seed %1: %2, listed %3").arg(seed).arg(area, 0, 'g', 12).arg(listed)));
            }
        }
    }
    void fileHasEighteenCases() { QCOMPARE(cases().size(), 18); }
    void noSeedsGiveNoCells() {
        const Ring square{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
        QVERIFY(thesisDiagram(square, {}).cells.empty());
    }
    void trianglesAreSeedIndices() {
        const Ring square{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
        const std::vector<Vec2> seeds{{0.3, 0.4}, {0.6, 0.45}, {0.45, 0.7}};
        const ThesisDiagram diagram = thesisDiagram(square, seeds);
        QCOMPARE(diagram.triangles.size(), std::size_t{1});
        std::array<std::uint32_t, 3> corners = diagram.triangles[0];
        std::ranges::sort(corners);
        QCOMPARE(corners, (std::array<std::uint32_t, 3>{0, 1, 2}));
    }
};

RUBBLE_TEST(ThesisMethodTest)
#include "ThesisMethodTest.moc"
