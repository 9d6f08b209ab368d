#include "core/io/play/QueryJson.h"

#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

#include <limits>

using namespace rubble;

class QueryJsonTest : public QObject {
    Q_OBJECT
private slots:
    void collapseHasNamesAndItsInfiniteTimesAreNull() {
        const Session session = test::sessionOf(test::floatingBlock());
        const std::uint32_t block = session.bodies().back().number;
        const Collapse collapse{.islands = {{{block}, 500.0}},
                                .mass = 500.0,
                                .first = 0.25,
                                .last = std::numeric_limits<double>::infinity()};
        QCOMPARE(QString::fromStdString(wouldFallJson(session, {}, collapse)), QString(R"({
  "step": 0,
  "removed": [],
  "islands": [
    {"mass": 500, "bodies": ["block"]}
  ],
  "mass": 500,
  "first": 0.25,
  "last": null
}
)"));
    }
    void fragmentsHaveTheirNames() {
        const Session session = test::sessionOf(test::bondedWall(4));
        const std::vector<BodyPart> removed{{1, {0}}};
        const Collapse collapse{.islands = {{.mass = 12.5, .parts = {{1, {1, 3}}}}}, .mass = 12.5};
        const QString text = QString::fromStdString(wouldFallJson(session, removed, collapse));
        const std::string id = session.body(1)->asset->bake->fragmentId(0);
        const QString first = QString::fromStdString(id.substr(id.find('/')));
        QVERIFY2(text.contains("\"wall" + first + "\""), qPrintable(text));
        QCOMPARE(text.count("\"wall/"), 3);
        QVERIFY(text.contains("\"mass\": 12.5, \"bodies\": [\"wall/"));
    }
    void boxesAreWrittenInTheirOrder() {
        const std::vector<Box3> boxes{{{0.0, -1.0, 0.5}, {1.0, 2.0, 3.0}}, {{4.0, 4.0, 4.0}, {5.0, 5.0, 5.0}}};
        QCOMPARE(QString::fromStdString(changedBoxesJson(3, 7, boxes)), QString(R"({
  "since": 3,
  "step": 7,
  "boxes": [
    {"min": [0, -1, 0.5], "max": [1, 2, 3]},
    {"min": [4, 4, 4], "max": [5, 5, 5]}
  ]
}
)"));
    }
};

RUBBLE_TEST(QueryJsonTest)
#include "QueryJsonTest.moc"
