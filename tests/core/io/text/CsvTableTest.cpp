#include "core/io/text/CsvTable.h"

#include "tests/support/TestProgram.h"

#include <QTest>

#include <array>

using namespace rubble;

class CsvTableTest : public QObject {
    Q_OBJECT
private slots:
    void fieldsAreQuotedWhereTheyMustBe() {
        QCOMPARE(csvField("front 1.1"), std::string("front 1.1"));
        QCOMPARE(csvField(""), std::string());
        QCOMPARE(csvField("a,b"), std::string(R"("a,b")"));
        QCOMPARE(csvField(R"(a "b")"), std::string(R"("a ""b""")"));
        QCOMPARE(csvField("a\nb"), std::string("\"a\nb\""));
        QCOMPARE(csvField("a\rb"), std::string("\"a\rb\""));
    }
    void columnsAreTheValuesPlaces() {
        const std::array<std::string, 7> columns{"name",      "point[0]", "point[1]", "ids[0]",
                                                 "box[1][0]", "sum.rest", "sum.count"};
        CsvTable table(columns);
        table.openObject();
        table.text("name", "a,b");
        table.numbers("point", {0.1, -0.0});
        table.openArray("box");
        table.openArray();
        table.close();
        table.numbers({}, {2.5});
        table.close();
        table.close();
        table.openObject();
        table.openObject("sum");
        table.wholeNumber("count", 18446744073709551615U);
        table.number("rest", 1e-7);  // before it in the table
        table.close();
        table.wholeNumbers("ids", std::array<std::uint32_t, 1>{7});
        table.close();
        QCOMPARE(std::move(table).finished(), std::string("name,point[0],point[1],ids[0],box[1][0],sum.rest,sum.count\n"
                                                          "\"a,b\",0.1,0,,2.5,,\n"
                                                          ",,,7,,1e-07,18446744073709551615\n"));
    }
    void noObjectIsAHeaderOnly() {
        const std::array<std::string, 2> columns{"a", "b,c"};
        QCOMPARE(CsvTable(columns).finished(), std::string("a,\"b,c\"\n"));
    }
};

RUBBLE_TEST(CsvTableTest)
#include "CsvTableTest.moc"
