// Tests what bonds hold: projects in tests/corpus/Structures with the right values.
#include "core/io/project/ProjectFile.h"
#include "core/structure/graph/Islands.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/JsonCases.h"
#include "tests/support/play/Sessions.h"

#include <QJsonArray>
#include <QTest>

#include <algorithm>
#include <filesystem>
#include <set>

using namespace rubble;

namespace {

const QString kStructures = RUBBLE_SOURCE_DIR "/tests/corpus/Structures/";

QJsonArray structureValues() { return test::readJson(kStructures + "values.json")["cases"].toArray(); }

Project loaded(const QString& file) {
    const Result<Project> project = loadProject((kStructures + file).toStdString());
    if (!project) qFatal("%s", project.error().message.c_str());
    return *project;
}

using HeldNodes = std::set<std::pair<std::uint32_t, std::uint32_t>>;  // by origin

HeldNodes heldNodes(const Session& session) {
    HeldNodes held;
    for (const PlayBody& body : session.bodies()) {
        if (!body.isHeld) continue;
        for (const std::uint32_t fragment : bondedFragments(body)) held.emplace(body.origin, fragment);
    }
    return held;
}

/// Whether unbroken bonds join all nodes of each body, and all of these have a strength.
bool areBodiesJoined(const Session& session) {
    return std::ranges::all_of(session.bodies(), [&](const PlayBody& body) {
        if (body.bondedFracture() == nullptr) return true;
        const PlayOrigin& origin = session.origins()[body.origin];
        const std::shared_ptr<const PlayStructure> structure = structureIn(session.scene(), origin, body.fragment);
        const bool isBegun = body.structure != kNone;
        std::vector<BondDamage> damage = isBegun ? session.structures()[body.structure].damage
                                                 : std::vector<BondDamage>(structure->capacities.size());
        for (std::size_t bond = 0; bond < damage.size(); ++bond)
            if (structure->capacities[bond] <= 0.0) damage[bond] = kBroken;
        std::vector<std::uint32_t> nodes = body.nodes;
        for (std::uint32_t node = 0; !isBegun && node < structure->nodeCount(); ++node) nodes.push_back(node);
        return islandsOf(structure->graph, damage, nodes).count() == 1;
    });
}

}  // namespace

class StructureCorpusTest : public QObject {
    Q_OBJECT
private slots:
    void onlyWhatIsHeldStays_data() {
        QTest::addColumn<QJsonObject>("value");
        const QJsonArray values = structureValues();
        for (const QJsonValue& one : values) QTest::newRow(qPrintable(one["file"].toString())) << one.toObject();
    }
    void onlyWhatIsHeldStays() {
        QFETCH(QJsonObject, value);
        const Project project = loaded(value["file"].toString());
        Session session = test::sessionOf(project);
        for (const Shot& shot : project.shots) QVERIFY(session.add(shot));
        QVERIFY(areBodiesJoined(session));
        QVERIFY(session.events().splits.empty() && session.damage().size() == project.instances.size());
        for (const auto& [instance, damage] : session.damage()) QVERIFY(damage.isIntact());
        const HeldNodes first = heldNodes(session);
        HeldNodes before = first;
        for (int step = 0; step < value["steps"].toInt(); ++step) {
            session.step();
            const HeldNodes now = heldNodes(session);
            QVERIFY2(std::ranges::includes(before, now), QByteArray::number(step));
            QVERIFY2(areBodiesJoined(session), QByteArray::number(step));
            before = now;
        }
        if (value.contains("lost")) QCOMPARE(static_cast<int>(first.size() - before.size()), value["lost"].toInt());
        if (!value.contains("joints")) return;
        QCOMPARE(session.scene().mortars.at(0).isHeld, value["joints"].toBool());
    }
    void everyFileHasValues() {
        std::size_t count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(kStructures.toStdString()))
            count += entry.path().extension() == ".rubble" ? 1 : 0;
        QCOMPARE(static_cast<std::size_t>(structureValues().size()), count);
        QVERIFY(count >= 24);
    }
};

RUBBLE_TEST(StructureCorpusTest)
#include "StructureCorpusTest.moc"
