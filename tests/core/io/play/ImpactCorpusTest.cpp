// Tests that what lands and what is hit does the same at any frame rate: projects in tests/corpus/Impacts.
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/JsonCases.h"
#include "tests/support/play/BrokenBonds.h"
#include "tests/support/play/Sessions.h"

#include <QJsonArray>
#include <QTest>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <map>
#include <set>

using namespace rubble;

namespace {

const QString kImpacts = RUBBLE_SOURCE_DIR "/tests/corpus/Impacts/";
constexpr std::array kRates{30, 60, 120, 240};  // steps/s
constexpr double kGrowth = 0.01;                // of the peak of energy, in a step
constexpr double kEqualBonds = 0.95;            // of all that break at one of two rates

QJsonArray impactCases() { return test::readJson(kImpacts + "cases.json")["cases"].toArray(); }

using test::Bonds;
using test::brokenBonds;

/// The part of the bonds in either set that is in both (Jaccard); 1 of none.
double equalPart(const Bonds& one, const Bonds& other) {
    const auto common = std::ranges::count_if(one, [&](const auto& bond) { return other.contains(bond); });
    const std::size_t all = one.size() + other.size() - static_cast<std::size_t>(common);
    return all == 0 ? 1.0 : static_cast<double>(common) / static_cast<double>(all);
}

/// What was seen of a simulation.
struct Played {
    double lowest = std::numeric_limits<double>::max();  // m above the ground, of any centre of mass
    double growth = 0.0;                                 // J, of the mechanical energy in a step without a source
    double peak = 0.0;                                   // J, of all that moved
    Bonds broken;
};

void addStep(const Session& session, double before, Played& played) {
    const Momenta momenta = session.world().momenta();
    const double moving = momenta.kinetic + momenta.potential, after = moving + session.heldPotential();
    played.peak = std::max(played.peak, moving);
    if (session.events().inputs.empty()) played.growth = std::max(played.growth, after - before);
    for (const PlayBody& body : session.bodies()) {
        if (session.world().kind(body.body) != BodyKind::Dynamic) continue;
        const double height = session.world().state(body.body).centre.y - session.scene().project.ground.height;
        played.lowest = std::min(played.lowest, height);
    }
}

Played played(const Project& project, double seconds, int rate) {
    Session session = test::sessionOf(project, {.dt = 1.0 / rate});
    for (const Shot& shot : project.shots)
        if (const Status added = session.add(shot); !added) qFatal("%s", added.error().message.c_str());
    Played played;
    for (int step = 0; step < seconds * rate; ++step) {
        const Momenta momenta = session.world().momenta();
        const double before = momenta.kinetic + momenta.potential + session.heldPotential();
        session.step();
        addStep(session, before, played);
    }
    played.broken = brokenBonds(session);
    return played;
}

}  // namespace

class ImpactCorpusTest : public QObject {
    Q_OBJECT
private slots:
    void impactsDoNotDependOnTheFrameRate_data() {
        QTest::addColumn<QJsonObject>("value");
        const QJsonArray cases = impactCases();
        for (const QJsonValue& one : cases) QTest::newRow(qPrintable(one["file"].toString())) << one.toObject();
    }
    /// Nothing falls through the ground, no energy appears, and a hit breaks the same bonds.
    void impactsDoNotDependOnTheFrameRate() {
        QFETCH(QJsonObject, value);
        const Result<Project> project = loadProject((kImpacts + value["file"].toString()).toStdString());
        QVERIFY2(project, project ? "" : project.error().message.c_str());
        const bool isCompared = value["sameBonds"].toBool();
        std::map<int, Played> all;
        QStringList faults;
        const auto require = [&](bool holds, const QString& fault) {
            faults += holds ? QStringList{} : QStringList{fault};
        };
        for (const int rate : kRates) {
            if (rate == 240 && !isCompared) continue;
            const Played& one = all[rate] = played(*project, value["seconds"].toDouble(), rate);
            qInfo("%d Hz: lowest %.3g m, energy grows by %.3g %% of the peak, %zu bonds broken", rate, one.lowest,
                  100.0 * one.growth / one.peak, one.broken.size());
            QVERIFY(!one.broken.empty());
            require(one.lowest > 0.0, QString("ground at %1 Hz").arg(rate));
            require(one.growth <= kGrowth * one.peak, QString("energy at %1 Hz").arg(rate));
        }
        if (isCompared) require(equalPart(all[60].broken, all[240].broken) >= kEqualBonds, "bonds");
        QCOMPARE(faults.join(", "), QString());
    }
    void everyFileIsACase() {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(kImpacts.toStdString()))
            count += entry.path().extension() == ".rubble" ? 1 : 0;
        QCOMPARE(static_cast<std::size_t>(impactCases().size()), count);
        QVERIFY(count >= 40);
    }
};

RUBBLE_TEST(ImpactCorpusTest)
#include "ImpactCorpusTest.moc"
