// Tests the bonds of core/io/pack/SceneFile.cpp, and that docs/formats/rubble_pack.hpp makes of them what is played.
#include "core/base/Random.h"
#include "core/io/pack/SceneFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/play/session/Session.h"
#include "core/structure/rule/SimpleRule.h"
#include "docs/formats/rubble_pack.hpp"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/files/Schemas.h"

#include <QTemporaryDir>
#include <QTest>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <optional>
#include <set>

using namespace rubble;

namespace {

using FragmentList = std::vector<std::uint32_t>;

/// A demo project in play, and as its export describes it.
struct ExportedScene {
    Project project;
    std::shared_ptr<const PlayScene> played;
    std::string json;
    rubble_pack::Scene scene;
    std::vector<rubble_pack::Pack> packs;
    rubble_pack::SceneStructures read;

    explicit ExportedScene(const std::string& name) {
        project = readProjectText(readFile(RUBBLE_SOURCE_DIR "/projects/" + name).value()).value();
        played = playScene(project).value();
        const PackOptions options{.files = PackFiles::Json, .meshes = {.formats = {}}};
        json = sceneFileJson(project, options, played.get());
        std::string fault;
        if (!rubble_pack::parseScene(json, scene, fault)) qFatal("%s", fault.c_str());
        const QTemporaryDir place;
        const std::filesystem::path out = place.path().toStdString();
        std::vector<Id> assets;
        for (const Asset& asset : project.assets) assets.push_back(asset.id);
        if (!exportPacks(project, assets, out, options)) qFatal("the packs were not exported");
        packs.resize(scene.packs.size());
        for (std::size_t k = 0; k < packs.size(); ++k) {
            if (!rubble_pack::load((out / scene.packs[k].folder / "pack.json").string(), packs[k], fault))
                qFatal("%s", fault.c_str());
        }
        if (!rubble_pack::structuresOf(scene, packs, read, fault)) qFatal("%s", fault.c_str());
    }
    const PlayStructure* structureOf(std::size_t instance) const {
        const auto found = played->structures.find(project.instances[instance].id);
        return found != played->structures.end() ? found->second.get() : nullptr;
    }
};

bool isNear(const rubble_pack::Vec3& a, Vec3 b) { return glm::distance(Vec3(a.x, a.y, a.z), b) < 1e-12; }

/// Where a structure that was read is not the one that is played; nothing if it is.
std::optional<std::string> faultOfStructure(const PlayStructure& played, const rubble_pack::Structure& read) {
    if (read.fragments.size() != played.nodeCount()) return "fragments";
    if (read.bonds.size() != played.graph.bondCount()) return "bonds";
    for (std::uint32_t k = 0; k < read.bonds.size(); ++k) {
        const Bond& bond = played.graph.bonds[k];
        if (read.ends[k] != std::array{bond.first, bond.second}) return "ends of " + std::to_string(k);
        const double capacity = played.capacities[k], own = read.bonds[k].capacity;
        if (own != capacity && !(std::abs(own - capacity) <= 1e-12 * capacity))
            return "capacity of " + std::to_string(k);
        const bool isSame = isNear(read.bonds[k].centroid, bond.centroid) && isNear(read.bonds[k].normal, bond.normal);
        if (!isSame && std::isfinite(own)) return "face of " + std::to_string(k);
    }
    return std::nullopt;
}

/// Breaks bonds of some fragments of random instances. Returns their damages, by instance.
SessionDamage randomDamage(const ExportedScene& one, const Session& session, Random& random) {
    SessionDamage damages;
    for (std::uint64_t count = 1 + random.below(3); count > 0; --count) {
        const std::size_t k = random.below(one.project.instances.size());
        const PlayStructure* const structure = one.structureOf(k);
        if (structure == nullptr) continue;
        InstanceDamage& damage =
            damages.try_emplace(one.project.instances[k].id, session.damage().at(one.project.instances[k].id))
                .first->second;
        const std::uint64_t most = random.below(3) == 0 ? 20 * structure->nodeCount() : structure->nodeCount() / 4;
        for (std::uint64_t holes = 1 + random.below(1 + most); holes > 0; --holes) {
            const auto node = static_cast<std::uint32_t>(random.below(structure->nodeCount()));
            for (const BondLink& link : structure->graph.linksOf(node))
                if (std::isfinite(structure->capacities[link.bond])) damage.broken[link.bond] = true;
        }
    }
    return damages;
}

/// The fragments of each instance that a session holds, ascending, and whether they wait to collapse.
struct HeldInstance {
    std::set<std::uint32_t> fragments;
    bool isCollapsing = false;
};
std::map<Id, HeldInstance> heldIn(const Session& session) {
    std::map<Id, HeldInstance> held;
    for (const PlayBody& body : session.bodies()) {
        if (!body.isHeld || body.role == PlayRole::Ground) continue;
        HeldInstance& one = held[session.origins()[body.origin].instance];
        for (const std::uint32_t fragment : bondedFragments(body)) one.fragments.insert(fragment);
        one.isCollapsing |= body.collapseStep != PlayBody::kNever;
    }
    return held;
}

/// The same by the header.
std::map<Id, HeldInstance> heldBy(const ExportedScene& one, const SessionDamage& broken) {
    std::vector<std::vector<rubble_pack::Damage>> damages = rubble_pack::intactDamages(one.read);
    for (std::size_t k = 0; k < damages.size(); ++k) {
        const auto own = broken.find(one.project.instances[k].id);
        for (std::size_t bond = 0; own != broken.end() && bond < damages[k].size(); ++bond)
            if (own->second.broken[bond]) damages[k][bond] = rubble_pack::kBroken;
    }
    while (!rubble_pack::breakMortar(one.read, damages).empty()) {
    }
    std::vector<FragmentList> held(damages.size());
    for (std::size_t k = 0; k < damages.size(); ++k) {
        const rubble_pack::Structure& structure = one.read.structures[k];
        for (const rubble_pack::Island& island : rubble_pack::islandsOf(structure, damages[k], structure.fragments))
            if (island.isAnchored) held[k].insert(held[k].end(), island.fragments.begin(), island.fragments.end());
        std::ranges::sort(held[k]);
    }
    const std::vector<FragmentList> unsupported = rubble_pack::unsupported(one.read, damages, held);
    std::map<Id, HeldInstance> all;
    for (std::size_t k = 0; k < held.size(); ++k) {
        if (!held[k].empty())
            all[one.project.instances[k].id] = {{held[k].begin(), held[k].end()}, !unsupported[k].empty()};
    }
    return all;
}

/// Where a random hit on an instance does something else by the header than in play; nothing if it does not. Both
/// damages are changed.
std::optional<std::string> faultOfHit(const ExportedScene& one, std::size_t k, Random& random,
                                      std::vector<BondDamage>& played, std::vector<rubble_pack::Damage>& read) {
    const PlayStructure& structure = *one.structureOf(k);
    std::vector<Vec3> points;
    std::vector<rubble_pack::Vec3> readPoints;
    const Vec3 around = structure.graph.centres[random.below(structure.nodeCount())];
    for (std::uint64_t count = 1 + random.below(3); count > 0; --count) {
        const Vec3 point =
            around + Vec3(random.between(-0.4, 0.4), random.between(-0.4, 0.4), random.between(-0.4, 0.4));
        points.push_back(point);
        readPoints.push_back({point.x, point.y, point.z});
    }
    const double impulse = std::pow(10.0, random.between(0.0, 5.0));
    const std::vector<std::uint32_t> owners(structure.nodeCount(), 1);
    const HeldClusters held{
        structure.clusterLevels,
        breakingLevel(structure.graph, structure.capacities, structure.clusterLevels, played, structure.allNodes())};
    const HitOutcome outcome = applyHit(structure.graph, structure.capacities, structure.rule,
                                        {.points = points, .impulse = impulse, .held = held}, owners, 1, played);
    const rubble_pack::Structure& own = one.read.structures[k];
    const rubble_pack::Bonding& bonding = *one.packs[one.scene.instances[k].pack].bonding;
    const rubble_pack::HitOutcome same =
        rubble_pack::applyHit(own, bonding, {readPoints, impulse}, own.fragments, read);
    if (same.broken != outcome.broken || same.damaged != outcome.damaged) return "other bonds break or are damaged";
    if (std::abs(same.taken - outcome.taken) > 1e-6 * std::max(1.0, outcome.taken)) return "another impulse is taken";
    if (!std::ranges::equal(played, read)) return "the damages differ";
    return std::nullopt;
}

std::optional<std::string> faultOfHeld(const std::map<Id, HeldInstance>& held, const std::map<Id, HeldInstance>& read) {
    if (held.size() != read.size()) return "other instances are held";
    for (const auto& [id, one] : held) {
        if (!read.contains(id)) return "instance " + std::to_string(id) + " is held";
        if (read.at(id).fragments != one.fragments) return "other fragments of instance " + std::to_string(id);
        if (read.at(id).isCollapsing != one.isCollapsing) return "the collapse of instance " + std::to_string(id);
    }
    return std::nullopt;
}

}  // namespace

class SceneBondsTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase_data() {
        QTest::addColumn<QString>("name");
        for (const char* name :
             {"two-storey-house.rubble", "arcade.rubble", "dam.rubble", "joined-house.rubble", "rock-face.rubble"})
            QTest::newRow(name) << name;
    }
    void structuresAreThosePlayed() {
        QFETCH_GLOBAL(QString, name);
        const ExportedScene one(name.toStdString());
        QCOMPARE(test::Schema("scene.schema.json").fault(nlohmann::json::parse(one.json)), std::string());
        for (std::size_t k = 0; k < one.project.instances.size(); ++k) {
            const PlayStructure* const played = one.structureOf(k);
            const rubble_pack::Structure& read = one.read.structures[k];
            QCOMPARE(read.fragments.empty(), played == nullptr);
            if (played == nullptr) continue;
            const auto fault = faultOfStructure(*played, read);
            QVERIFY2(!fault, fault.value_or("").c_str());
        }
    }
    void whatIsHeldIsWhatIsHeldInPlay() {
        QFETCH_GLOBAL(QString, name);
        const ExportedScene one(name.toStdString());
        int collapsing = 0, released = 0;
        for (std::uint64_t seed = 0; seed < 40; ++seed) {
            Random random(seed);
            Session session = Session::start(one.played).value();
            const SessionDamage broken = randomDamage(one, session, random);
            const std::map<Id, HeldInstance> before = heldIn(session);
            QVERIFY(session.apply(broken));
            const std::map<Id, HeldInstance> held = heldIn(session);
            const auto fault = faultOfHeld(held, heldBy(one, broken));
            QVERIFY2(!fault, qPrintable(faultOfSeed(seed, fault.value_or(""))));
            for (const auto& [id, instance] : held) collapsing += instance.isCollapsing ? 1 : 0;
            for (const auto& [id, instance] : before) released += !held.contains(id) && !broken.contains(id) ? 1 : 0;
        }
        qInfo("%d instances collapse, %d come free for they hung on others", collapsing, released);
        if (name.startsWith("two-storey")) QVERIFY(collapsing > 0 && released > 0);
    }
    void hitsDoWhatTheyDoInPlay() {
        QFETCH_GLOBAL(QString, name);
        const ExportedScene one(name.toStdString());
        std::vector<std::size_t> bonded;
        for (std::size_t k = 0; k < one.project.instances.size(); ++k)
            if (one.structureOf(k) != nullptr) bonded.push_back(k);
        int broken = 0;
        for (std::uint64_t seed = 0; seed < 500; ++seed) {
            Random random(seed);
            const std::size_t k = bonded[random.below(bonded.size())];
            std::vector<BondDamage> played(one.structureOf(k)->graph.bondCount());
            std::vector<rubble_pack::Damage> read(played.size());
            for (int hit = 0; hit < 5; ++hit) {  // on what the hits before have left
                const std::optional<std::string> fault = faultOfHit(one, k, random, played, read);
                QVERIFY2(!fault, qPrintable(QString("seed %1, hit %2: %3").arg(seed).arg(hit).arg(fault->c_str())));
            }
            broken += static_cast<int>(std::ranges::count(played, kBroken));
        }
        QVERIFY(broken > 1000);
    }
    void scenesOfOtherPacksAreRefused() {
        QFETCH_GLOBAL(QString, name);
        const ExportedScene one(name.toStdString());
        const auto faultOf = [&](const rubble_pack::Scene& scene, const std::vector<rubble_pack::Pack>& packs) {
            rubble_pack::SceneStructures read;
            std::string fault;
            return rubble_pack::structuresOf(scene, packs, read, fault) ? std::string() : fault;
        };
        QCOMPARE(faultOf(one.scene, one.packs), std::string());
        QCOMPARE(faultOf(one.scene, {}), std::string("There must be a pack for each of the scene."));
        rubble_pack::Scene scene = one.scene;
        scene.packs[0].physicsHash[0] ^= 1;
        QVERIFY(faultOf(scene, one.packs).ends_with("is of another export than the scene."));
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Random random(seed);
            scene = one.scene;
            rubble_pack::SceneInstance& instance = scene.instances[random.below(scene.instances.size())];
            if (!instance.anchors.empty() && random.below(2) == 0) {
                instance.anchors[random.below(instance.anchors.size())].fragments[0] += 100000;
                QVERIFY(faultOf(scene, one.packs).starts_with("An anchor of "));
            } else if (!scene.joints.empty()) {
                rubble_pack::SceneJoint& joint = scene.joints[random.below(scene.joints.size())];
                joint.fragments[0] += 100000 + static_cast<std::uint32_t>(random.below(2000000000));
                QVERIFY(faultOf(scene, one.packs).starts_with("A joint of "));
            }
        }
    }
    void massesOfIslandsAreThosePlayed() {
        QFETCH_GLOBAL(QString, name);
        const ExportedScene one(name.toStdString());
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Random random(seed);
            const std::size_t k = random.below(one.project.instances.size());
            const PlayStructure* const structure = one.structureOf(k);
            if (structure == nullptr) continue;
            std::vector<std::uint32_t> island;
            std::vector<MassProperties> parts;
            for (std::uint32_t node = 0; node < structure->nodeCount(); ++node) {
                if (random.below(3) > 0) continue;
                island.push_back(structure->fragmentOf(node));
                parts.push_back(structure->solidOf(node).shape->mass);
                parts.back().centre = structure->graph.centres[node];
            }
            if (island.empty()) continue;
            const MassProperties expected = combined(parts);
            const Asset& asset = *findAsset(one.project, one.project.instances[k].asset);
            const double density = findMaterial(one.project, asset.material)->density;
            const rubble_pack::IslandMass read = rubble_pack::massOf(one.packs[one.scene.instances[k].pack], island);
            const QString fault = faultOfSeed(seed, "another mass");
            QVERIFY2(std::abs(read.mass - density * expected.volume) <= 1e-9 * read.mass, qPrintable(fault));
            const Vec3 centre{read.centre.x, read.centre.y, read.centre.z};
            QVERIFY2(glm::distance(centre, expected.centre) < 1e-9, qPrintable(fault));
            for (int row = 0; row < 3; ++row) {
                for (int column = 0; column < 3; ++column) {
                    const double difference = read.inertia[row][column] - density * expected.inertia[column][row];
                    QVERIFY2(std::abs(difference) <= 1e-8 * read.inertia[row][row], qPrintable(fault));
                }
            }
        }
    }
    void sourceChangesWithTheScene() {
        QFETCH_GLOBAL(QString, name);
        Project project =
            readProjectText(readFile(RUBBLE_SOURCE_DIR "/projects/" + name.toStdString()).value()).value();
        const ContentHash source = sceneSource(project, {});
        QVERIFY(source == sceneSource(project, {}) && hasSceneBonds(project));
        project.instances[0].pose.position.x += 1e-3;
        QVERIFY(source != sceneSource(project, {}));
    }
};

RUBBLE_TEST(SceneBondsTest)
#include "SceneBondsTest.moc"
