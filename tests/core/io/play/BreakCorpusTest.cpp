// Tests blows and thrown balls on assets that break: projects in tests/corpus/Breaks with the right values.
#include "core/asset/project/HammerPatch.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

using namespace rubble;

namespace {

constexpr int kSteps = 30;
const std::string kBreaks = RUBBLE_SOURCE_DIR "/tests/corpus/Breaks/";

nlohmann::json breakValues() {
    std::ifstream file(kBreaks + "values.json");
    return nlohmann::json::parse(file);
}

/// What a simulated break did.
struct BreakOutcome {
    std::uint32_t fragments = 0;
    double given = 0.0;     // J, by the source
    double momentum = 0.0;  // N·s along -z, of all bodies when it broke
    double gained = 0.0;    // J, by the solver afterwards
    double fastest = 0.0;   // m/s, of any body at any time
    bool isConserved = true;
    std::string left;  // of the world, and why
};

double mechanicalEnergy(const World& world) {
    const Momenta momenta = world.momenta();
    return momenta.kinetic + momenta.potential;
}

/// Adds a step. `initial`: the energy right after the break.
void addStep(const Session& session, std::optional<double>& initial, BreakOutcome& outcome) {
    for (const EnergyEntry& entry : session.events().energy) {
        outcome.given += entry.given;
        outcome.isConserved = outcome.isConserved && entry.isConserved();
    }
    for (const Diagnostic& one : session.events().diagnostics) {
        if (one.code == DiagnosticCode::LeftWorld) outcome.left += one.message + "\n";
    }
    for (const PlayBody& body : session.bodies()) {
        outcome.fastest = std::max(outcome.fastest, glm::length(session.world().state(body.body).velocity));
    }
    if (!session.events().breaks.empty()) {
        outcome.fragments += session.events().breaks[0].fragmentCount;
        outcome.momentum = -session.world().momenta().linear.z;
        initial = mechanicalEnergy(session.world());
    }
    if (initial) outcome.gained = std::max(outcome.gained, mechanicalEnergy(session.world()) - *initial);
}

BreakOutcome simulated(const Project& project) {
    Session session = test::sessionOf(project);
    for (const Shot& shot : project.shots) {
        if (const Status added = session.add(shot); !added) qFatal("%s", added.error().message.c_str());
    }
    BreakOutcome outcome;
    std::optional<double> initial;
    for (int step = 0; step < kSteps; ++step) {
        session.step();
        addStep(session, initial, outcome);
    }
    return outcome;
}

bool isClose(double found, double expected) { return std::abs(found - expected) <= 0.01 * std::abs(expected); }

}  // namespace

class BreakCorpusTest : public QObject {
    Q_OBJECT
private slots:
    void breaksConserveEnergy_data() {
        QTest::addColumn<QString>("file");
        QTest::addColumn<double>("fragments");
        QTest::addColumn<double>("given");
        QTest::addColumn<double>("momentum");
        for (const auto& one : breakValues()) {
            const auto file = QString::fromStdString(one["file"].get<std::string>());
            QTest::newRow(qPrintable(file)) << file << one["fragments"].get<double>() << one["given"].get<double>()
                                            << one["momentum"].get<double>();
        }
    }
    void breaksConserveEnergy() {
        QFETCH(QString, file);
        QFETCH(double, fragments);
        QFETCH(double, given);
        QFETCH(double, momentum);
        const Result<Project> project = loadProject(kBreaks + file.toStdString());
        QVERIFY2(project, project ? "" : project.error().message.c_str());
        const ShotAction& action = project->shots.at(0).action;
        const Throw* thrown = std::get_if<Throw>(&action);
        const BreakOutcome outcome = simulated(*project);
        qInfo("%u fragments, given %.6g J and %.6g N·s, gained %.3g J, fastest %.3g m/s", outcome.fragments,
              outcome.given, outcome.momentum, outcome.gained, outcome.fastest);
        QCOMPARE(double(outcome.fragments), fragments);
        QVERIFY(isClose(outcome.given, given));
        if (thrown == nullptr) {
            QVERIFY(given <= 0.5 * momentum * kHammerSpeed * 1.001);
            QVERIFY(outcome.momentum <= 1.01 * momentum &&
                    outcome.momentum >= 0.9 * momentum);  // the ground takes some
        }
        QVERIFY(outcome.isConserved);
        QVERIFY2(outcome.left.empty(), outcome.left.c_str());
        // By the solver: one percent, and a tenth of a joule where little is given to heavy bodies.
        QVERIFY2(outcome.gained <= 0.01 * given + 0.1, QByteArray::number(outcome.gained));
        // An elastic impact doubles a speed at most; several add to it.
        const double speed = thrown != nullptr ? thrown->speed : kHammerSpeed;
        QVERIFY2(outcome.fastest <= 2.5 * speed, QByteArray::number(outcome.fastest));
    }
    void everyFileHasValues() {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(kBreaks)) {
            count += entry.path().extension() == ".rubble" ? 1 : 0;
        }
        QCOMPARE(breakValues().size(), count);
        QVERIFY(count >= 22);
    }
};

RUBBLE_TEST(BreakCorpusTest)
#include "BreakCorpusTest.moc"
