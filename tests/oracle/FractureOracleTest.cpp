#include "tests/oracle/Comparison.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/JsonCases.h"

#include <QDir>
#include <QTest>

using namespace rubble;
using namespace rubble::oracle;

namespace {

constexpr const char* kFirst = "RUBBLE_ORACLE_FIRST";  // number of the first random case
constexpr const char* kCount = "RUBBLE_ORACLE_CASES";
constexpr std::uint64_t kDefaultCount = 2000;
constexpr int kMaxFaults = 10;

std::uint64_t environmentNumber(const char* name, std::uint64_t fallback) {
    bool isNumber = false;
    const std::uint64_t number = qEnvironmentVariable(name).toULongLong(&isNumber);
    return isNumber ? number : fallback;
}

/// Prints a fault with its minimized input.
void print(const FractureCase& faulty, const std::string& fault) {
    const FractureCase small = shrunk(faulty);
    qWarning("Case %llu (%s): %s\nShrunk to %s\n%s", static_cast<unsigned long long>(faulty.number),
             faulty.family.c_str(), fault.c_str(), fractureFault(small).value_or("no fault").c_str(),
             jsonOf(small).c_str());
}

}  // namespace

/// Compares all stages from outline and seeds to the partition with exact rational arithmetic.
class FractureOracleTest : public QObject {
    Q_OBJECT
private slots:
    void corpusCasesAgree() {
        const QDir corpus(RUBBLE_SOURCE_DIR "/tests/corpus/fracture");
        for (const QString& name : corpus.entryList({"*.json"}, QDir::Files, QDir::Name)) {
            const auto input = test::seededOutline(test::readJson(corpus.filePath(name)));
            const auto fault = fractureFault({0, name.toStdString(), input.outline, input.seeds});
            QVERIFY2(!fault, qPrintable(name + ": " + fault.value_or("").c_str()));
        }
    }
    void randomCasesAgree() {
        const std::uint64_t first = environmentNumber(kFirst, 0), count = environmentNumber(kCount, kDefaultCount);
        qInfo("Cases %llu to %llu; %s and %s select others.", static_cast<unsigned long long>(first),
              static_cast<unsigned long long>(first + count - 1), kFirst, kCount);
        int faults = 0;
        for (std::uint64_t number = first; number < first + count && faults < kMaxFaults; ++number) {
            const FractureCase input = fractureCase(number);
            const std::optional<std::string> fault = fractureFault(input);
            if (!fault) continue;
            print(input, *fault);
            ++faults;
        }
        QCOMPARE(faults, 0);
    }
};

RUBBLE_TEST(FractureOracleTest)
#include "FractureOracleTest.moc"
