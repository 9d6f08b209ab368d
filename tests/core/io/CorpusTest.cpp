// Tests the readers of core/io with the corpora of tests/corpus.
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/FuzzedReaders.h"

#include <QTest>

#include <algorithm>
#include <filesystem>

using namespace rubble;

namespace {

namespace fs = std::filesystem;
using Reader = test::Sentence (*)(std::string_view);

const std::vector<std::pair<const char*, Reader>> kReaders{{"FractureJson", test::fractureFault},
                                                           {"Project", test::projectFault},
                                                           {"Material", test::materialFault},
                                                           {"Pack", test::packFault},
                                                           {"BodiesJson", test::bodiesFault},
                                                           {"Replay", test::replayFault},
                                                           {"State", test::stateFault},
                                                           {"Shots", test::shotsFault},
                                                           {"Png", test::pngFault},
                                                           {"Radiance", test::radianceFault},
                                                           {"SourceScene", test::sourceSceneFault}};

std::vector<fs::path> inputsOf(const char* target) {
    std::vector<fs::path> paths;
    for (const auto& entry : fs::directory_iterator(fs::path(RUBBLE_SOURCE_DIR) / "tests/corpus" / target)) {
        paths.push_back(entry.path());
    }
    std::sort(paths.begin(), paths.end());
    return paths;
}

}  // namespace
Q_DECLARE_METATYPE(Reader)

/// Reads the seed corpus of the fuzz tests and everything they ever found.
class CorpusTest : public QObject {
    Q_OBJECT
private slots:
    void everyInputIsReadOrRejected_data() {
        QTest::addColumn<Reader>("reader");
        QTest::addColumn<QString>("path");
        for (const auto& [target, reader] : kReaders) {
            for (const fs::path& path : inputsOf(target)) {
                QTest::addRow("%s/%s", target, path.filename().c_str())
                    << reader << QString::fromStdString(path.string());
            }
        }
    }
    void everyInputIsReadOrRejected() {
        QFETCH(Reader, reader);
        QFETCH(QString, path);
        const Result<std::string> bytes = readFile(path.toStdString());
        QVERIFY(bytes);
        QCOMPARE(QString::fromStdString(reader(*bytes).value_or("")), QString());
    }
};

RUBBLE_TEST(CorpusTest)
#include "CorpusTest.moc"
