// Tests core/io/fracture/SolidFractureJson.cpp.
#include "core/io/fracture/SolidFractureJson.h"

#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTest>

using namespace rubble;

namespace {

constexpr const char* kTetrahedron =
    R"("mesh":{"points":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"triangles":[[0,2,1],[0,1,3],[1,2,3],[0,3,2]]})";

std::string solidJson(const std::string& seeds) {
    return std::string("{") + kTetrahedron + ",\"seeds\":" + seeds + "}";
}

QJsonObject cut(const std::string& seeds) {
    const Result<SolidFractureInput> input = readSolidFractureInput(solidJson(seeds));
    if (!input) return {};
    const Result<std::string> json = solidFractureJson(*input);
    return json ? QJsonDocument::fromJson(QByteArray::fromStdString(*json)).object() : QJsonObject();
}

}  // namespace

class SolidFractureJsonTest : public QObject {
    Q_OBJECT
private slots:
    void formsAreToldApart() {
        QVERIFY(hasMesh(solidJson("[]")));
        QVERIFY(!hasMesh(R"({"outline":[],"depth":1,"seeds":[]})"));
        QVERIFY(!hasMesh("[1]"));
        QVERIFY(!hasMesh("{"));
    }
    void fragmentsShareFaces() {
        const QJsonObject result = cut("[[0.1,0.1,0.1],[0.6,0.1,0.1]]");
        const QJsonArray fragments = result["fragments"].toArray(), faces = result["faces"].toArray();
        QCOMPARE(fragments.size(), 2);
        double volume = 0.0;
        for (const QJsonValue fragment : fragments) volume += fragment["volume"].toDouble();
        QVERIFY(std::abs(volume - 1.0 / 6.0) < 1e-15);
        QCOMPARE(fragments[0]["seed"].toInt(), 0);
        QCOMPARE(fragments[0]["neighbours"].toArray(), QJsonArray{1});
        int inside = 0;
        for (const QJsonValue face : faces) {
            inside += face.toObject().contains("behind");
            QVERIFY(face.toObject().contains("behind") != face.toObject().contains("source"));
        }
        QCOMPARE(inside, 1);
        QCOMPARE(result["points"].toArray()[3].toArray(), (QJsonArray{0, 0, 1}));
        QVERIFY(result["report"].toArray().isEmpty());
    }
    void seedsWithoutCellsAreReported() {
        const QJsonArray report = cut("[[0.1,0.1,0.1],[0.1,0.1,0.1],[50,50,50]]")["report"].toArray();
        QCOMPARE(report.size(), 2);
        QCOMPARE(report[0]["code"].toString(), QString("DuplicateSeed"));
        QCOMPARE(report[0]["of"].toInt(), 0);
        QCOMPARE(report[1]["code"].toString(), QString("SeedWithoutCell"));
        QCOMPARE(report[1]["seed"].toInt(), 2);
    }
    void meshesThatCannotBeCutAreRefused() {
        const std::string open =
            R"({"mesh":{"points":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"triangles":[[0,2,1],[0,1,3],[1,2,3]]},)"
            R"("seeds":[[0,0,0]]})";
        const Result<SolidFractureInput> input = readSolidFractureInput(open);
        QVERIFY(!input && input.error().code == ErrorCode::Degenerate);
        QVERIFY2(input.error().message.find("3 edges") != std::string::npos, input.error().message.c_str());
    }
    void whatIsTurnedIsReported() {
        const std::string inside =
            R"({"mesh":{"points":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]],"triangles":[[0,1,2],[0,3,1],[1,3,2],[0,2,3]]},)"
            R"("seeds":[[0.1,0.1,0.1]]})";
        const Result<SolidFractureInput> input = readSolidFractureInput(inside);
        QVERIFY(input);
        const std::string json = *solidFractureJson(*input);
        QVERIFY2(json.find("TurnedShells") != std::string::npos, json.c_str());
    }
    void inputIsChecked() {
        const auto fault = [](const std::string& text) { return errorText(readSolidFractureInput(text)); };
        QVERIFY(fault(solidJson("[]")).find("at least one seed") != std::string::npos);
        QVERIFY(fault(solidJson("[[1,2]]")).find("seeds[0]") != std::string::npos);
        QVERIFY(fault(R"({"mesh":{"points":[],"triangles":[]},"seeds":[[0,0,0]]})").find("points") !=
                std::string::npos);
        QVERIFY(
            fault(R"({"mesh":{"points":[[0,0,0]],"triangles":[[0,0,1]]},"seeds":[[0,0,0]]})").find("triangles[0]") !=
            std::string::npos);
        QVERIFY(!fault(R"({"mesh":{"points":[[0,0,0]],"triangles":[[0,0]]},"seeds":[[0,0,0]]})").empty());
        QVERIFY(!fault(R"({"mesh":{"points":[[0,0,0]]},"seeds":[[0,0,0]]})").empty());
    }
};

RUBBLE_TEST(SolidFractureJsonTest)
#include "SolidFractureJsonTest.moc"
