#include "core/base/Random.h"
#include "core/physics/broadphase/NearbyBoxes.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

Box randomCube(Random& random, float side) {
    const auto coordinate = [&] { return static_cast<float>(random.between(-5.0, 5.0)); };
    const Vec3f low(coordinate(), coordinate(), coordinate());
    return {low, low + Vec3f(side)};
}

std::vector<std::uint32_t> inTree(const DynamicBoxTree& tree, const Box& box) {
    std::vector<std::uint32_t> numbers;
    tree.visitOverlapping(box, [&](std::uint32_t number, const Box&) { numbers.push_back(number); });
    return numbers;
}

}  // namespace

class NearbyBoxesTest : public QObject {
    Q_OBJECT
private slots:
    /// In the same order, which determines contact indices.
    void findsTheSameAsTheTreeInTheSameOrder() {
        constexpr std::uint64_t kSeed = 81;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        DynamicBoxTree tree;
        for (std::uint32_t number = 0; number < 500; ++number) tree.insert(randomCube(random, 1.0f), number);
        tree.update();
        NearbyBoxes near;
        std::size_t found = 0;
        for (int round = 0; round < 200; ++round) {
            const Box first = randomCube(random, 0.5f), second = widened(first, 0.2f);
            near.gather(tree, joined(first, second));
            for (const Box& box : {first, second}) {
                const std::span<const std::uint32_t> numbers = near.overlapping(box);
                QVERIFY(std::ranges::equal(numbers, inTree(tree, box)));
                found += numbers.size();
            }
        }
        QVERIFY(found > 200);
    }
    void emptyTreeHasNoNearbyBoxes() {
        NearbyBoxes near;
        near.gather({}, {Vec3f(-1.0f), Vec3f(1.0f)});
        QVERIFY(near.overlapping({Vec3f(-1.0f), Vec3f(1.0f)}).empty());
    }
};

RUBBLE_TEST(NearbyBoxesTest)
#include "NearbyBoxesTest.moc"
