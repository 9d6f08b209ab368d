#include "core/io/fracture/FractureJson.h"

#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/JsonCases.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

constexpr const char* kSquare = R"("outline":[[0,0],[1,0],[1,1],[0,1]],"depth":0.5)";

std::string inputJson(const std::string& members) { return std::string("{") + kSquare + "," + members + "}"; }

QJsonObject fractured(const FractureInput& input) {
    const Result<std::string> json = fractureJson(input);
    return json ? QJsonDocument::fromJson(QByteArray::fromStdString(*json)).object() : QJsonObject();
}

std::string inputFault(const std::string& text) { return errorText(readFractureInput(text)); }

ErrorCode inputErrorCode(const std::string& json) { return readFractureInput(json).error().code; }

std::vector<std::uint32_t> indicesOf(const QJsonValue& array) {
    std::vector<std::uint32_t> indices;
    for (const QJsonValue index : array.toArray()) indices.push_back(static_cast<std::uint32_t>(index.toInt()));
    return indices;
}

}  // namespace

class FractureJsonTest : public QObject {
    Q_OBJECT
private slots:
    void inputIsReadAndCanonicalized() {
        const Result<FractureInput> input =
            readFractureInput(R"({"seeds":[[0.5,0.25]],"depth":2,"outline":[[0,0],[0,4],[4,4],[4,0]],)"
                              R"("holes":[[[1,1],[3,1],[3,3],[1,3]]]})");
        QVERIFY(input.hasValue());
        QVERIFY(signedArea(input->prism.outline.outer) > 0.0 && signedArea(input->prism.outline.holes[0]) < 0.0);
        QCOMPARE(area(input->prism.outline), 12.0);
        QCOMPARE(input->prism.depth, 2.0);
        QCOMPARE(input->seeds, (std::vector<Vec2>{{0.5, 0.25}}));
    }
    void closingAndRepeatedPointsAreLeftOutAndReported() {
        const Result<FractureInput> input =
            readFractureInput(R"({"outline":[[0,0],[4,0],[4,0],[4,4],[0,4],[0,0]],"depth":1,"seeds":[],)"
                              R"("holes":[[[1,1],[1,2],[2,2],[1,1]]]})");
        QCOMPARE(input->prism.outline.outer, (Ring{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
        QCOMPARE(input->prism.outline.holes[0].size(), std::size_t{3});
        QCOMPARE(input->diagnostics.size(), std::size_t{3});
        QCOMPARE(input->diagnostics[0].message,
                 std::string("Point 2 of the outline repeats the point before it, at (4, 0), and was left out."));
        QCOMPARE(input->diagnostics[1].message,
                 std::string("Point 5 of the outline repeats its first point, at (0, 0), and was left out."));
        QCOMPARE(input->diagnostics[2].message,
                 std::string("Point 3 of hole 0 repeats its first point, at (1, 1), and was left out."));
        const QJsonArray report = fractured(*input)["report"].toArray();
        QCOMPARE(report[0].toObject()["code"].toString(), QString("RepeatedPoint"));
    }
    void faultsSayThatRepeatedPointsAreNotCounted() {
        QCOMPARE(inputFault(R"({"outline":[[0,0],[0,0],[2,2],[2,0],[0,2]],"depth":1,"seeds":[]})"),
                 std::string(
                     "The outline crosses itself between points 0 and 2, at (1, 1). Points are counted without those "
                     "that repeat others."));
    }
    void pointsThatAreAllEqualAreNoOutline() {
        QCOMPARE(inputErrorCode(R"({"outline":[[1,1],[1,1],[1,1],[1,1]],"depth":1,"seeds":[]})"), ErrorCode::BadInput);
    }
    void holesAreOptional() { QVERIFY(readFractureInput(inputJson(R"("seeds":[])"))->prism.outline.holes.empty()); }
    void faultsNameTheirPlace() {
        QCOMPARE(inputFault(inputJson(R"("seeds":[[0,0],[1]])")),
                 std::string("seeds[1]: expected an array of 2 numbers, found an array of 1."));
        QCOMPARE(inputFault(inputJson(R"("holes":[[[0.2,0.2],"x"]],"seeds":[])")),
                 std::string("holes[0][1]: expected an array of 2 numbers, found \"x\"."));
        QCOMPARE(inputErrorCode(inputJson(R"("seeds":{})")), ErrorCode::BadInput);
        QCOMPARE(inputErrorCode("{"), ErrorCode::BadInput);
        QCOMPARE(inputErrorCode(R"({"outline":[[0,0],[2,2],[2,0],[0,2]],"depth":1,"seeds":[]})"), ErrorCode::Crossing);
    }

    void counterexamplesOfTheThesisAreCorrect_data() {
        QTest::addColumn<int>("number");
        int number = 0;
        for (const test::Counterexample& example : test::counterexamples())
            QTest::newRow(example.name.c_str()) << number++;
        QCOMPARE(number, 18);
    }
    void counterexamplesOfTheThesisAreCorrect() {
        QFETCH(int, number);
        const test::Counterexample example = test::counterexamples()[static_cast<std::size_t>(number)];
        const QJsonObject output = fractured({{example.outline, 1.0}, example.seeds});
        const QJsonArray cells = output["cells"].toArray();
        double sum = 0.0;
        for (const QJsonValue cell : cells) {
            const auto seed = static_cast<std::size_t>(cell["seed"].toInt());
            const double exact = example.areas[seed];
            QVERIFY(std::abs(cell["area"].toDouble() - exact) <= 1e-12 * area(example.outline));
            QCOMPARE(indicesOf(cell["neighbours"]), example.neighbours[seed]);
            sum += exact;
        }
        QVERIFY(std::abs(sum - area(example.outline)) <= 1e-12 * area(example.outline));
    }
    void trianglesStartWithTheSmallestIndexAndAreSorted() {
        const std::vector<Vec2> seeds = {{0.75, 0.75}, {0.25, 0.25}, {0.8, 0.2}, {0.2, 0.9}};
        const QJsonArray triangles = fractured({{unitSquare(), 1.0}, seeds})["triangles"].toArray();
        QCOMPARE(triangles.size(), 2);
        QCOMPARE(indicesOf(triangles[0]), (std::vector<std::uint32_t>{0, 1, 2}));
        QCOMPARE(indicesOf(triangles[1]), (std::vector<std::uint32_t>{0, 3, 1}));
    }
    void reportsHaveCodeSeedsAndMessage() {
        const QJsonArray report = fractured({{unitSquare(), 1.0}, {{0.5, 0.5}, {0.5, 0.5}}})["report"].toArray();
        QCOMPARE(report.size(), 1);
        QCOMPARE(report[0]["code"].toString(), QString("DuplicateSeed"));
        QCOMPARE(report[0]["seed"].toInt(), 1);
        QCOMPARE(report[0]["of"].toInt(-1), 0);
        QVERIFY(report[0]["message"].toString().endsWith('.'));
    }
    void outputIsOneLine() {
        const Result<std::string> json = fractureJson({{unitSquare(), 1.0}, {{0.5, 0.5}}});
        QCOMPARE(json->find('\n'), json->size() - 1);
    }
    void cancellationStopsIt() {
        TaskContext task;
        task.cancel.cancel();
        const std::vector<Vec2> seeds = {{0.25, 0.5}, {0.75, 0.5}};
        QCOMPARE(fractureJson({{unitSquare(), 1.0}, seeds}, task).error().code, ErrorCode::Cancelled);
    }
};

RUBBLE_TEST(FractureJsonTest)
#include "FractureJsonTest.moc"
