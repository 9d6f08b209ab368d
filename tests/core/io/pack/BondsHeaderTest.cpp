// Tests the bonds of docs/formats/rubble_pack.hpp, and bonded_wall_example.cpp.
#include "core/io/system/AtomicFile.h"
#include "core/play/damage/DamageBytes.h"
#include "core/structure/clusters/ClusterEditing.h"
#include "core/structure/graph/Islands.h"
#include "core/structure/graph/Support.h"
#include "core/structure/rule/SimpleRule.h"
#include "docs/formats/rubble_pack.hpp"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Packs.h"
#include "tests/support/files/WrongValues.h"
#include "tests/support/play/BondedWalls.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <fstream>

using namespace rubble;

namespace {

using Damages = std::vector<rubble_pack::Damage>;
using Indices = std::vector<std::uint32_t>;

/// A ring in fragments, of which the lower ones are anchored.
Asset ringOf(const LayerParameters& fragments, const Bonding& bonding) {
    Asset asset = bondedRing();
    asset.pattern.layers[0].parameters = fragments;
    asset.bonding = bonding;
    asset.bonding.strokes.push_back({.brush = BondBrush::Anchor, .radius = 0.1, .points = {{0.5, 0.0}, {2.5, 0.0}}});
    return asset;
}

Bonding randomBonding(Random& random) {
    return {.impulsePerArea = random.between(50.0, 200.0),
            .radius = random.between(0.2, 3.0),
            .falloff = static_cast<HitFalloff>(random.below(3)),
            .damageFrom = random.below(4) == 0 ? 1.0 : random.between(0.05, 0.7),
            .span = random.below(3) == 0 ? 0.0 : random.between(0.5, 4.0),
            .heightStrengths = {{.height = 0.0, .factor = 2.0}, {.height = 3.0, .factor = 0.0}},
            .neverBreaks = {"4.1", "4.2"}};
}

/// Every fourth is of squares of 0.5 m with bonds of the same strength that the distance does not count for: many of
/// the same utilization, many of these at the same distance from a hit at a multiple of 0.25 m.
Asset randomRing(Random& random, int round) {
    Bonding bonding = randomBonding(random);
    if (round % 4 != 0)
        return ringOf(UniformScatter{.count = 10 + static_cast<std::uint32_t>(random.below(60))}, bonding);
    bonding.falloff = HitFalloff::Constant;
    bonding.heightStrengths.clear();
    return ringOf(JitteredGrid{.columns = 8, .rows = 8, .jitter = 0.0}, bonding);
}

/// Clusters on no level, one or two.
void addRandomClusters(Random& random, Asset& asset) {
    const Bake baked = *bake(asset);
    const auto levels = static_cast<std::uint32_t>(random.below(3));
    for (std::uint32_t level = 0; level < levels; ++level) {
        const auto count = static_cast<std::uint32_t>(2 + random.below(6 * (level + 1)));
        asset.bonding.clusters = ClusterEditing(asset, baked, 0, level).propose({.value = count});
    }
}

rubble_pack::Pack headerPack(const std::string& json) {
    rubble_pack::Pack pack;
    std::string fault;
    if (!rubble_pack::parse(json, pack, fault)) qFatal("%s", fault.c_str());
    return pack;
}

/// The whole of an asset for play and for the header.
struct BothStructures {
    Asset asset;
    std::shared_ptr<const PlayAsset> ready = *playAsset(asset, std::make_shared<const Bake>(*bake(asset)));
    std::shared_ptr<const PlayStructure> ours = instanceStructure(*playStructure(asset, heavyBrick(), ready, kNone),
                                                                  asset, heavyBrick(), Instance{.id = 9}, {});
    rubble_pack::Pack pack = headerPack(packOf(asset));
    rubble_pack::Structure theirs = rubble_pack::structureOf(pack, 0);
};

rubble_pack::Vec3 asHeader(Vec3 v) { return {v.x, v.y, v.z}; }

/// A damage of the header as play has it, where bonds without capacity are broken.
Damages asInPlay(const BothStructures& both, Damages damage) {
    for (std::size_t bond = 0; bond < damage.size(); ++bond)
        damage[bond] = std::max(damage[bond], both.ours->initialDamage[bond]);
    return damage;
}

/// The islands of both; empty: they are the same.
std::string islandFault(const BothStructures& both, const Damages& damage, const Indices& body) {
    const Islands ours = islandsOf(both.ours->graph, damage, body);
    Damages held = damage;  // the header knows bonds without capacity by themselves
    for (std::size_t bond = 0; bond < held.size(); ++bond)
        if (both.ours->initialDamage[bond] == kBroken) held[bond] = kIntact;
    const std::vector<rubble_pack::Island> theirs = rubble_pack::islandsOf(both.theirs, held, body);
    if (theirs.size() != ours.count()) return "another number of islands";
    for (std::uint32_t k = 0; k < ours.count(); ++k) {
        if (!std::ranges::equal(theirs[k].fragments, ours[k].nodes)) return "other islands";
        if (theirs[k].isAnchored != ours[k].isAnchored) return "other anchored islands";
    }
    return "";
}

InstanceDamage asInstanceDamage(const std::string& bake, const std::vector<Damages>& damages) {
    InstanceDamage damage{.kind = DamageKind::Bonds, .bake = *parseContentHash(bake)};
    for (const Damages& one : damages) {
        for (const rubble_pack::Damage bond : one) {
            if (bond != 0 && bond != kBroken) damage.partial[static_cast<std::uint32_t>(damage.broken.size())] = bond;
            damage.broken.push_back(bond == kBroken);
        }
    }
    return damage;
}

Damages randomDamages(Random& random, std::size_t count) {
    Damages damages(count);
    for (rubble_pack::Damage& one : damages) {
        const std::uint64_t kind = random.below(3);
        one = kind == 0   ? rubble_pack::Damage{0}
              : kind == 1 ? kBroken
                          : static_cast<rubble_pack::Damage>(random.below(256));
    }
    return damages;
}

const std::string kBake = "00112233445566778899aabbccddeeff";

std::string readFault(std::string_view bytes, std::vector<Damages> damages, const std::string& bake = kBake) {
    std::string fault;
    return rubble_pack::readDamage(bytes, bake, damages, fault) ? "" : fault;
}

/// A damage with the right checksum after a change.
std::string sealed(std::string bytes) {
    bytes.resize(bytes.size() - 8);
    const std::uint64_t low = contentHash(bytes).low;
    for (int k = 0; k < 8; ++k) bytes.push_back(static_cast<char>(low >> (8 * k)));
    return bytes;
}

}  // namespace

/// Compares the bonds of docs/formats/rubble_pack.hpp with core/structure and core/play.
class BondsHeaderTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    /// Runs the example program.
    QProcess* example(const QStringList& arguments) {
        auto* program = new QProcess(this);
        program->start(RUBBLE_BONDED_WALL_EXAMPLE, arguments);
        program->waitForFinished(kPatience);
        return program;
    }
    QString written(const std::string& json) const {
        const QString path = m_folder.filePath("pack.json");
        std::ofstream(path.toStdString(), std::ios::binary) << json;
        return path;
    }

private slots:
    void structuresAreThoseOfPlay() {
        Asset ring = ringOf(UniformScatter{.count = 40}, everyBonding("4"));
        ring.bonding.clusters = {};
        for (const std::uint32_t level : {0, 1})
            ring.bonding.clusters = ClusterEditing(ring, *bake(ring), 0, level).propose({.value = 4 * (level + 1)});
        const BothStructures both{ring};
        QCOMPARE(both.pack.bonding->anchored.size() > 3, true);
        QCOMPARE(both.theirs.bonds.size(), std::size_t{both.ours->graph.bondCount()});
        QCOMPARE(both.theirs.fragments.size(), std::size_t{both.ours->nodeCount()});
        for (std::uint32_t bond = 0; bond < both.ours->graph.bondCount(); ++bond) {
            QCOMPARE(both.theirs.ends[bond][0], both.ours->graph.bonds[bond].first);
            QCOMPARE(both.theirs.ends[bond][1], both.ours->graph.bonds[bond].second);
            QCOMPARE(both.theirs.bonds[bond].capacity, both.ours->capacities[bond]);
            const std::vector<ClusterLevel>& levels = both.ours->clusterLevels;
            QCOMPARE(both.theirs.bonds[bond].clusterLevel, bond < levels.size() ? levels[bond] : 0u);
        }
        QVERIFY(std::ranges::count(both.ours->clusterLevels, 2) > 0);
        const rubble_pack::Structure doubled = rubble_pack::structureOf(both.pack, 0, 2.0);
        const auto strong = strengthened(*both.ours, 2.0);
        for (std::uint32_t bond = 0; bond < both.ours->graph.bondCount(); ++bond)
            QCOMPARE(doubled.bonds[bond].capacity, strong->capacities[bond]);
    }
    /// Hits on random parts of walls, which keep their damage.
    void randomHitsHaveTheSameEffect() {
        constexpr std::uint64_t kSeed = 20261127;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        std::size_t broken = 0, damaged = 0, islands = 0, unsupported = 0;
        std::ptrdiff_t unbonded = 0;
        for (int round = 0; round < 100; ++round) {
            Asset ring = randomRing(random, round);
            addRandomClusters(random, ring);
            BothStructures both{std::move(ring)};
            Damages ours = both.ours->initialDamage, theirs(ours.size());
            unbonded += std::ranges::count(ours, kBroken);
            for (int hit = 0; hit < 10; ++hit) {
                std::vector<std::uint32_t> owners(both.ours->nodeCount());
                if (hit % 2 == 1) {
                    for (std::uint32_t& owner : owners) owner = static_cast<std::uint32_t>(random.below(4) / 3);
                }
                Indices body;
                for (std::uint32_t node = 0; node < owners.size(); ++node) {
                    if (owners[node] == 0) body.push_back(node);
                }
                std::vector<Vec3> points;
                rubble_pack::Hit theirHit{{}, random.between(0.0, 100.0) * random.between(0.0, 0.5)};
                for (std::uint64_t k = random.below(4); k < 4; ++k) {
                    const Vec2 at = round % 4 == 0 ? Vec2(0.25 * static_cast<double>(random.below(17)),
                                                          0.25 * static_cast<double>(random.below(17)))
                                                   : Vec2(random.between(0.0, 4.0), random.between(0.0, 4.0));
                    points.emplace_back(at, 0.25);
                    theirHit.points.push_back(asHeader(points.back()));
                }
                const auto clusters = [&] {
                    return HeldClusters{both.ours->clusterLevels, breakingLevel(both.ours->graph, both.ours->capacities,
                                                                                both.ours->clusterLevels, ours, body)};
                };
                const HitOutcome our = applyHit(both.ours->graph, both.ours->capacities, both.ours->rule,
                                                {points, theirHit.impulse, clusters()}, owners, 0, ours);
                const rubble_pack::HitOutcome their =
                    rubble_pack::applyHit(both.theirs, *both.pack.bonding, theirHit, body, theirs);
                QCOMPARE(their.broken, our.broken);
                QCOMPARE(their.damaged, our.damaged);
                QVERIFY(their.taken == our.taken);
                QCOMPARE(asInPlay(both, theirs), ours);
                QCOMPARE(islandFault(both, ours, body), std::string());
                const Vec3 up = glm::normalize(
                    Vec3{random.between(-1.0, 1.0), random.between(0.1, 1.0), random.between(-1.0, 1.0)});
                const Indices fallen =
                    wholeClusters(unsupportedNodes(both.ours->graph, ours, body, supportLimitsOf(*both.ours, up), up),
                                  both.ours->graph, clusters(), ours, body);
                QCOMPARE(rubble_pack::unsupported(both.theirs, theirs, body, both.pack.bonding->span, asHeader(up)),
                         fallen);
                broken += our.broken.size();
                damaged += our.damaged.size();
                islands += islandsOf(both.ours->graph, ours, body).count();
                if (fallen.size() != body.size()) unsupported += fallen.size();
            }
        }
        qInfo("broken %zu, damaged %zu, islands %zu, unsupported %zu", broken, damaged, islands, unsupported);
        QVERIFY(broken > 500 && damaged > 200 && islands > 1000 && unsupported > 500 && unbonded > 100);
    }
    void ofFragmentsAtTheSameDistanceTheFirstIsHit() {
        BothStructures both{ringOf(UniformScatter{.count = 20}, {.impulsePerArea = 100.0, .radius = 0.01})};
        const BondGraph graph = bondGraph(std::vector<Vec3>(both.ours->nodeCount()), both.ours->graph.bonds);
        both.theirs.centres.assign(both.theirs.fragments.size(), {});
        const Vec3 point{1.0, 2.0, 0.0};
        const std::vector<std::uint32_t> owners(both.ours->nodeCount());
        Damages ours(both.theirs.bonds.size()), theirs = ours;
        applyHit(graph, both.ours->capacities, both.ours->rule, {{&point, 1}, 1e6}, owners, 0, ours);
        rubble_pack::applyHit(both.theirs, *both.pack.bonding, {{asHeader(point)}, 1e6}, both.theirs.fragments, theirs);
        QVERIFY(std::ranges::count(ours, kBroken) > 0);
        QCOMPARE(theirs, ours);
    }
    /// Of all lengths at which XXH3 goes on in another way.
    void damagesOfOneAreReadByTheOther() {
        constexpr std::uint64_t kSeed = 20261128;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        for (std::size_t round = 0; round < 400; ++round) {
            const std::vector<Damages> damages{randomDamages(random, round < 200 ? round : random.below(3000)),
                                               randomDamages(random, random.below(3))};
            const InstanceDamage ours = asInstanceDamage(kBake, damages);
            const std::string bytes = damageBytes(ours);
            QVERIFY2(rubble_pack::damageBytes(kBake, damages) == bytes, std::to_string(bytes.size()).c_str());
            QVERIFY(*damageOfBytes(rubble_pack::damageBytes(kBake, damages)) == ours);
            std::vector<Damages> read{Damages(damages[0].size(), 7), Damages(damages[1].size(), kBroken)};
            std::string fault;
            QVERIFY2(rubble_pack::readDamage(bytes, kBake, read, fault), fault.c_str());
            QCOMPARE(read, damages);
        }
    }
    /// Play counts bonds as the header does: those of the whole, with painted anchors, then those of its fragments.
    void damagesOfPlayAreRead() {
        Project project = test::bondedWall(60);
        Asset& asset = project.assets[0];
        asset.levels = {{.pattern = test::patternOf(project, {UniformScatter{.count = 4}})}};
        asset.bonding.strokes = {{.points = {{-1.9, -1.45}, {1.9, -1.45}}}};
        project.instances[0].isAnchored = false;
        const auto scene = test::playSceneOf(project);
        Session session = *Session::start(scene);
        test::addInput(session, ShotInput{"ball", test::ballAtWall()});
        for (int step = 0; step < 40; ++step) session.step();
        const Instance& instance = project.instances[0];
        const InstanceDamage ours = session.damage().at(instance.id);
        const rubble_pack::Pack pack = headerPack(packOf(asset));
        std::vector<Damages> damages;
        for (std::size_t k = 0; k < pack.bonding->fractures.size(); ++k)
            damages.emplace_back(rubble_pack::structureOf(pack, k).bonds.size());
        QVERIFY(damages.size() > 30);
        std::string fault;
        QVERIFY2(rubble_pack::readDamage(damageBytes(ours), pack.bonding->bake, damages, fault), fault.c_str());
        QVERIFY(std::ranges::count(damages[0], kBroken) > 0);
        QVERIFY(asInstanceDamage(pack.bonding->bake, damages) == ours);
    }
    void anchorsCanBeAdded() {
        BothStructures both{ringOf(UniformScatter{.count = 20}, {})};
        const std::uint32_t last = both.theirs.fragments.back();
        Damages damage(both.theirs.bonds.size());
        for (std::size_t bond = 0; bond < damage.size(); ++bond) damage[bond] = kBroken;
        QVERIFY(!rubble_pack::islandsOf(both.theirs, damage, {last}).front().isAnchored);
        rubble_pack::addAnchor(both.theirs, {{last, rubble_pack::kNone}, 0.5, {}, {0.0, -1.0, 0.0}, 100.0});
        damage.push_back(0);
        QVERIFY(rubble_pack::islandsOf(both.theirs, damage, {last}).front().isAnchored);
        QVERIFY(rubble_pack::unsupported(both.theirs, damage, {last}, 1.0, {0.0, 1.0, 0.0}).empty());
    }
    void fragmentsBreakOff() {
        const BothStructures both{ringOf(UniformScatter{.count = 20}, {})};
        const Indices off{0, 3, 4, 11};
        Damages damage(both.theirs.bonds.size(), 100);
        damage[2] = kBroken;
        const Indices broken = rubble_pack::breakOff(both.theirs, off, damage);
        for (std::uint32_t k = 0; k < damage.size(); ++k) {
            const Bond& bond = both.ours->graph.bonds[k];
            const bool leaves =
                std::isfinite(both.ours->capacities[k]) &&  // not to a painted anchor
                (std::ranges::binary_search(off, bond.first) || std::ranges::binary_search(off, bond.second));
            QCOMPARE(std::ranges::binary_search(broken, k), leaves && k != 2);
            QCOMPARE(damage[k] == kBroken, leaves || k == 2);
        }
        for (const rubble_pack::Island& island : rubble_pack::islandsOf(both.theirs, damage, both.theirs.fragments)) {
            const bool isOff = std::ranges::binary_search(off, island.fragments.front());
            QVERIFY(!isOff || island.fragments.size() == 1);
            QVERIFY(!isOff || island.isAnchored ==
                                  std::ranges::binary_search(both.pack.bonding->anchored, island.fragments.front()));
        }
    }
    void wrongDamagesAreRefused() {
        const std::vector<Damages> damages{{0, kBroken, 3}, {0, 200}};
        const std::string bytes = rubble_pack::damageBytes(kBake, damages);
        QCOMPARE(readFault(bytes, damages), std::string());
        const auto changed = [&](std::size_t at, char byte) {
            std::string other = bytes;
            other[at] = byte;
            return sealed(other);
        };
        QCOMPARE(readFault("", damages), std::string("The damage is too short."));
        QCOMPARE(readFault(changed(0, 'X'), damages), std::string("The text is not a damage."));
        for (std::size_t at = 4; at < bytes.size(); ++at) {
            std::string other = bytes;
            other[at] = static_cast<char>(other[at] ^ 1);
            QCOMPARE(readFault(other, damages),
                     std::string("The damage was changed on its way: its checksum does not fit."));
        }
        const std::string otherKind = "The damage is not of bonds, or of another version.";
        for (const std::size_t at : {4, 5, 6}) QCOMPARE(readFault(changed(at, 9), damages), otherKind);
        const std::string otherBake = "The damage is of another bake.";
        QCOMPARE(readFault(bytes, damages, std::string(32, '1')), otherBake);
        QCOMPARE(readFault(bytes, {{0, 0, 0}}), std::string("The damage is of another number of bonds."));
        QCOMPARE(readFault(changed(28, 9), damages), std::string("The damage has another size than its bonds take."));
        QCOMPARE(readFault(changed(27, 0x22), damages), std::string("The damage has bits beyond its last bond."));
        const std::string wrongBond = "A damaged bond is broken, out of order or does not exist.";
        for (const char bond : {'\1', '\4', '\5'}) QCOMPARE(readFault(changed(32, bond), damages), wrongBond);
        for (const char one : {'\0', '\xff'}) QCOMPARE(readFault(changed(35, one), damages), wrongBond);
        std::vector<Damages> kept{{1, 2, 3}, {4, 5}};
        std::string fault;
        QVERIFY(!rubble_pack::readDamage(changed(35, 0), kBake, kept, fault));
        QCOMPARE(kept, (std::vector<Damages>{{1, 2, 3}, {4, 5}}));
    }
    void clustersBreakOffAsOne() {
        BothStructures both{ringOf(UniformScatter{.count = 20}, {})};
        for (rubble_pack::Bond& bond : both.theirs.bonds) bond.clusterLevel = bond.fragments[1] == kNone ? 0 : 2;
        both.theirs.bonds[0].clusterLevel = 1;
        Damages damage(both.theirs.bonds.size());
        const Indices& all = both.theirs.fragments;
        QCOMPARE(rubble_pack::breakingLevel(both.theirs, damage, all), 1u);
        QCOMPARE(rubble_pack::breakOff(both.theirs, all, damage, 1), Indices{0});
        QCOMPARE(rubble_pack::breakingLevel(both.theirs, damage, all), 2u);
        QVERIFY(!rubble_pack::breakOff(both.theirs, all, damage, 2).empty());
        QCOMPARE(rubble_pack::breakingLevel(both.theirs, damage, all), rubble_pack::kNone);
    }
    /// Three holes above the ground; what they carried comes off, too.
    void exampleHitsAWall() {
        Asset wall = boxAsset(3, 4, UniformScatter{.count = 40});
        wall.name = "wall";
        wall.shape = Prism{{rectangle({-2.0, 0.0}, {2.0, 3.0}), {}}, 0.25};
        wall.breakAs = BreakAs::Bonded;
        wall.bonding.impulsePerArea = 100.0;
        wall.bonding.radius = 1.2;
        wall.bonding.span = 0.8;
        wall.bonding.minimumIsland = 3;
        wall.bonding.strokes = {{.radius = 0.05, .points = {{-2.0, 0.0}, {2.0, 0.0}}}};
        QProcess* program = example({written(packOf(wall)), "700", "-1.2", "0.5", "0", "0.6", "1.2", "0.5"});
        QCOMPARE(program->readAllStandardError(), QByteArray());
        QCOMPARE(program->exitCode(), 0);
        const QByteArray output = program->readAllStandardOutput();
        const std::string expected = *readFile(RUBBLE_SOURCE_DIR "/tests/corpus/BondedWall/output.txt");
        QVERIFY2(output == QByteArray::fromStdString(expected), output.constData());
    }
    void exampleTellsWhatIsWrong() {
        QProcess* program = example({"none/pack.json", "1", "0", "0"});
        QCOMPARE(program->exitCode(), 1);
        QCOMPARE(program->readAllStandardError(), QByteArray("Cannot read \"none/pack.json\".\n"));
        program = example({written(packOf(twoLevelRing())), "1", "0", "0"});
        QCOMPARE(program->exitCode(), 1);
        QCOMPARE(program->readAllStandardError(), QByteArray("box has no bonds.\n"));
        program = example({"pack.json", "1", "0"});
        QCOMPARE(program->exitCode(), 2);
        QVERIFY(program->readAllStandardError().startsWith("usage: bonded_wall_example pack.json"));
    }
    void wrongBondsAreReported_data() {
        test::addWrongValueColumns();
        test::addWrongValue("bonding.falloff: \"round\" is not known to this reader.", "/bonding/falloff", "\"round\"");
        test::addWrongValue("bonding: the key \"damageFrom\" is above 1.", "/bonding/damageFrom", "1.5");
        test::addWrongValue("bonding.bake: expected 32 hexadecimal digits.", "/bonding/bake", "\"12\"");
        test::addWrongValue("bonding.fractures[0].bonds[0].fragments: expected 2 fragments.",
                            "/bonding/fractures/0/bonds/0/fragments", "[1]");
        test::addWrongValue("bonding.fractures[0].bonds[0].fragments: expected ascending fragments.",
                            "/bonding/fractures/0/bonds/0/fragments", "[1, 0]");
        test::addWrongValue("bonding.fractures[0].bonds[0].fragments[1]: expected a fragment of the body.",
                            "/bonding/fractures/0/bonds/0/fragments", "[0, 19]");
        test::addWrongValue("bonding.fractures[0].bonds[0].fragments[1]: expected a whole number below 20.",
                            "/bonding/fractures/0/bonds/0/fragments", "[0, 20]");
        test::addWrongValue("bonding.fractures[0].bonds[0].capacity: expected a number of at least 0.",
                            "/bonding/fractures/0/bonds/0/capacity", "-1");
        test::addWrongValue("bonding.fractures[0].bonds[0].clusterLevel: expected a whole number below 4294967295.",
                            "/bonding/fractures/0/bonds/0/clusterLevel", "-1");
        test::addWrongValue("bonding.anchored[0]: expected a fragment of the whole.", "/bonding/anchored/0", "19");
    }
    void wrongBondsAreReported() {
        const std::string wrong = test::withWrongValue(nlohmann::json::parse(packOf(bondedRing())));
        rubble_pack::Pack pack;
        std::string fault;
        QVERIFY(!rubble_pack::parse(wrong, pack, fault));
        QCOMPARE(fault, std::string(QTest::currentDataTag()));
    }
};

RUBBLE_TEST_WITH(BondsHeaderTest, QCoreApplication)
#include "BondsHeaderTest.moc"
