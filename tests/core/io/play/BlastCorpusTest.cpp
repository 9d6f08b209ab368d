// Tests core/play/session/ApplyBlast.cpp and core/physics/world/Blast.cpp with the projects of tests/corpus/Blast.
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <QTest>

#include <nlohmann/json.hpp>

using namespace rubble;

namespace {

const std::string kBlastFolder = RUBBLE_SOURCE_DIR "/tests/corpus/Blast/";

/// The momenta of the instances after the first step, by name.
std::map<std::string, Vec3> momentaOf(const Session& session) {
    std::map<std::string, Vec3> momenta;
    for (const PlayBody& body : session.bodies()) {
        const double mass = session.world().mass(body.body);
        momenta[session.origins()[body.origin].name] += mass * session.world().state(body.body).velocity;
    }
    return momenta;
}

}  // namespace

/// The expected momenta are integrals over the faces, computed by sampling them with lines of sight between boxes.
class BlastCorpusTest : public QObject {
    Q_OBJECT
private slots:
    void momentaAreThoseExpected_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<QString>("expected");
        const auto cases = nlohmann::json::parse(*readFile(kBlastFolder + "expected.json"));
        for (const auto& [name, expected] : cases.items()) {
            QTest::newRow(name.c_str()) << QString::fromStdString(name) << QString::fromStdString(expected.dump());
        }
    }
    void momentaAreThoseExpected() {
        QFETCH(QString, file);
        QFETCH(QString, expected);
        const Result<Project> project = loadProject(kBlastFolder + file.toStdString());
        QVERIFY2(project.hasValue(), project ? "" : project.error().message.c_str());
        Session session = test::sessionOf(*project, {.dt = 1e-3});  // before bodies touch others
        for (const Shot& shot : project->shots) test::addInput(session, ShotInput{shot.name, shot.action});
        session.step();
        const std::map<std::string, Vec3> momenta = momentaOf(session);
        const auto json = nlohmann::json::parse(expected.toStdString());
        for (const auto& [name, values] : json["momenta"].items()) {
            const Vec3 wanted(values[0], values[1], values[2]), found = momenta.at(name);
            const double most = json["within"].get<double>() * glm::length(wanted) + 1e-3;
            QVERIFY2(
                glm::distance(found, wanted) <= most,
                qPrintable(QString("%1: (%2, %3, %4) N·s").arg(name.c_str()).arg(found.x).arg(found.y).arg(found.z)));
        }
    }
};

RUBBLE_TEST(BlastCorpusTest)
#include "BlastCorpusTest.moc"
