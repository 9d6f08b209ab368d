// Tests core/play/breaking/DebrisRemoval.cpp with the projects of tests/corpus/Debris.
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

#include <nlohmann/json.hpp>

using namespace rubble;

namespace {

const std::string kDebrisFolder = RUBBLE_SOURCE_DIR "/tests/corpus/Debris/";

/// The names of whole bodies, and the numbers of fragments by what they are of.
nlohmann::json bodiesOf(const Session& session) {
    nlohmann::json bodies{{"whole", nlohmann::json::array()}, {"fragments", nlohmann::json::object()}};
    for (const PlayBody& body : session.bodies()) {
        const std::string& name = session.origins()[body.origin].name;
        if (body.role == PlayRole::Debris) bodies["fragments"][name] = bodies["fragments"].value(name, 0) + 1;
        if (body.role == PlayRole::Instance || body.role == PlayRole::Projectile) bodies["whole"].push_back(name);
    }
    return bodies;
}

}  // namespace

class DebrisCorpusTest : public QObject {
    Q_OBJECT
private slots:
    void onlyFragmentsAreRemoved_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("expected");
        const auto cases = nlohmann::json::parse(*readFile(kDebrisFolder + "expected.json"));
        for (const auto& [name, expected] : cases.items()) {
            QTest::newRow(name.c_str()) << QString::fromStdString(name) << QString::fromStdString(expected.dump());
        }
    }
    void onlyFragmentsAreRemoved() {
        QFETCH(QString, file);
        QFETCH(QString, expected);
        const Result<Project> project = loadProject(kDebrisFolder + file.toStdString());
        QVERIFY2(project.hasValue(), project ? "" : project.error().message.c_str());
        Session session = test::sessionOf(*project);
        for (const Shot& shot : project->shots) test::addInput(session, ShotInput{shot.name, shot.action});
        for (nlohmann::json wanted : nlohmann::json::parse(expected.toStdString())) {
            const auto step = wanted["step"].get<std::uint64_t>();
            while (session.stepsDone() < step) session.step();
            wanted.erase("step");
            QCOMPARE(QString::fromStdString(bodiesOf(session).dump()), QString::fromStdString(wanted.dump()));
        }
    }
};

RUBBLE_TEST(DebrisCorpusTest)
#include "DebrisCorpusTest.moc"
