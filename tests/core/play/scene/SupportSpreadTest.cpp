// Tests core/play/scene/SupportSpread.cpp
#include "core/play/scene/SupportSpread.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/MortarArcade.h"

#include <algorithm>
#include <limits>

using namespace rubble;

namespace {

/// The structures of a scene, with damage that grows.
struct Damaged {
    std::shared_ptr<const PlayScene> scene;
    std::map<Id, std::vector<BondDamage>> damage;

    explicit Damaged(const Project& project) : scene(test::playSceneOf(project)) {
        for (const auto& [id, structure] : scene->structures) damage[id] = structure->initialDamage;
    }
    std::map<Id, JoinedStructure> joined() const {
        std::map<Id, JoinedStructure> all;
        for (const auto& [id, structure] : scene->structures) {
            all[id] =
                joinedAtStart(*structure, upIn(poseOf(*findInstance(scene->project, id)), scene->project.gravity));
            all[id].damage = damage.at(id);
        }
        return all;
    }
    NodeFractions limits() const {
        NodeFractions all;
        for (const auto& [id, structure] : scene->structures)
            if (structure->hasSpan()) all[id] = structure->supportLimits;
        return all;
    }
    /// Breaks bonds of an instance, and the other halves of those that are mortar.
    void breakBond(Id instance, std::uint32_t bond) {
        damage[instance][bond] = kBroken;
        if (const MortarLink* link = scene->structures.at(instance)->mortarOf(bond))
            damage[link->instance][link->bond] = kBroken;
    }
    void update(SupportSpread& support) const {
        for (const auto& [id, one] : damage) support.setDamage(id, one);
    }
};

/// A beam on one pier with a wall on it, and a block at the free end of both, which hangs on them: it gets support from
/// the wall, and gives it to the beam that carries the wall.
Project circle() {
    Project project = test::mortarArcade(1, 2.5);
    std::erase_if(project.instances, [](const Instance& instance) { return instance.name == "right"; });
    Asset block = project.assets[1];
    block.name = "block";
    block.prism().outline = {rectangle({-0.5, -1.0}, {0.5, 1.0}), {}};
    const Id id = test::addAsset(project, block, {UniformScatter{.count = 20}});
    test::addInstance(project, id, "block", {.position = {2.5, 4.0, 0.0}});
    return project;
}

/// Breaks a random bond.
void breakAny(Damaged& damaged, Random& random) {
    auto instance = damaged.damage.begin();
    std::advance(instance, random.below(damaged.damage.size()));
    damaged.breakBond(instance->first, static_cast<std::uint32_t>(random.below(instance->second.size())));
}

NodeFractions fractionsIn(const SupportSpread& support, const Damaged& damaged) {
    NodeFractions all;
    for (const auto& [id, one] : damaged.damage) all[id] = support.fractionsOf(id);
    return all;
}

std::size_t unreached(const NodeFractions& fractions) {
    std::size_t count = 0;
    for (const auto& [id, own] : fractions)
        count += static_cast<std::size_t>(std::ranges::count(own, std::numeric_limits<double>::infinity()));
    return count;
}

/// The visits after all mortar of a beam broke.
std::size_t visitsWithoutBeam(int portals, std::size_t portal) {
    const Project project = test::mortarArcade(portals);
    Damaged damaged(project);
    SupportSpread support = *damaged.scene->structures.begin()->second->supportAtStart;
    const std::size_t before = support.visits();
    const Id beam = project.instances[4 * portal + 2].id;
    const PlayStructure& structure = *damaged.scene->structures.at(beam);
    for (std::uint32_t bond = structure.firstMortar(); bond < structure.graph.bondCount(); ++bond)
        damaged.breakBond(beam, bond);
    damaged.update(support);
    if (support.spread().empty()) qFatal("nothing lost its support");
    return support.visits() - before;
}

}  // namespace

class SupportSpreadTest : public QObject {
    Q_OBJECT
private slots:
    /// Bond by bond until little is left: the same bits as computed anew.
    void breaksAreAsComputedAnew() {
        for (std::uint64_t seed = 1; seed <= 12; ++seed) {
            Random random(seed);
            Damaged damaged(seed % 2 == 0 ? circle() : test::mortarArcade(3, random.between(0.4, 1.5)));
            const NodeFractions limits = seed == 1 ? NodeFractions{} : damaged.limits();
            SupportSpread kept(damaged.joined(), limits);
            for (int round = 0; round < 150; ++round) {
                const NodeFractions before = fractionsIn(kept, damaged);
                const auto count = 1 + random.below(8);
                for (std::uint64_t k = 0; k < count; ++k) breakAny(damaged, random);
                damaged.update(kept);
                const std::vector<InstanceNode> lost = kept.spread();
                const NodeFractions after = fractionsIn(kept, damaged);
                const QByteArray place =
                    QByteArray("random seed ") + QByteArray::number(seed) + ", round " + QByteArray::number(round);
                QVERIFY2(after == supportFractions(damaged.joined(), limits), place);
                QCOMPARE(lost.size(), unreached(after) - unreached(before));
                QVERIFY(std::ranges::is_sorted(lost));
                for (const auto& [instance, node] : lost) QVERIFY(!(after.at(instance)[node] < 1e300));
            }
            QVERIFY(unreached(fractionsIn(kept, damaged)) > 30);
        }
    }
    void aCopyIsOfItsOwn() {
        Random random(4);
        Damaged damaged(test::mortarArcade(2));
        const SupportSpread first(damaged.joined(), damaged.limits());
        SupportSpread second = first;
        for (int k = 0; k < 100; ++k) breakAny(damaged, random);
        damaged.update(second);
        second.spread();
        QCOMPARE(unreached(fractionsIn(first, damaged)), std::size_t{0});
        QVERIFY(fractionsIn(second, damaged) == supportFractions(damaged.joined(), damaged.limits()));
    }
    void mendedBondsAreFound() {
        Damaged damaged(test::mortarArcade(1));
        const Id instance = damaged.damage.begin()->first;
        SupportSpread support(damaged.joined(), {});
        const std::vector<BondDamage> intact = damaged.damage[instance];
        damaged.breakBond(instance, 0);
        QVERIFY(!support.isMended(instance, damaged.damage[instance]));
        damaged.update(support);
        QVERIFY(support.isMended(instance, intact));
    }
    void whatBreaksCostsWhatItSupported() {
        const std::size_t visits = visitsWithoutBeam(12, 6);
        QVERIFY(visits > 0 && visits < 80);
        QCOMPARE(visitsWithoutBeam(40, 20), visits);
    }
};

RUBBLE_TEST(SupportSpreadTest)
#include "SupportSpreadTest.moc"
