#include "core/base/Random.h"
#include "core/physics/broadphase/DynamicBoxTree.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

Box randomBox(Random& random) {
    const auto coordinate = [&] { return static_cast<float>(random.between(-10.0, 10.0)); };
    const Vec3f low(coordinate(), coordinate(), coordinate());
    return {low, low + Vec3f(1.0f, 0.5f, 2.0f)};
}

std::vector<std::uint32_t> found(const DynamicBoxTree& tree, const Box& box) {
    std::vector<std::uint32_t> numbers;
    tree.visitOverlapping(box, [&](std::uint32_t number, const Box&) { numbers.push_back(number); });
    std::sort(numbers.begin(), numbers.end());
    return numbers;
}

}  // namespace

class DynamicBoxTreeTest : public QObject {
    Q_OBJECT
private slots:
    void emptyTreeFindsNothing() { QVERIFY(found({}, {Vec3f(-1e9f), Vec3f(1e9f)}).empty()); }
    void findsTheSameAsBruteForce() {
        Random random(7);
        DynamicBoxTree tree;
        std::vector<std::pair<std::uint32_t, Box>> kept;  // leaf and box, by number
        for (int round = 0; round < 4000; ++round) {
            const auto action = random.below(10);
            if (action < 4 || kept.empty()) {
                const Box box = randomBox(random);
                kept.push_back({tree.insert(box, static_cast<std::uint32_t>(kept.size())), box});
            } else if (action < 7) {
                auto& [leaf, box] = kept[random.below(kept.size())];
                if (leaf == kNone) continue;
                box = action == 4 ? joined(box, randomBox(random)) : randomBox(random);
                tree.move(leaf, box);
            } else if (action == 7) {
                auto& leaf = kept[random.below(kept.size())].first;
                if (leaf != kNone) tree.remove(leaf);
                leaf = kNone;
            } else if (action == 8) {
                tree.update();
            }
            const Box window = randomBox(random);
            std::vector<std::uint32_t> expected;
            for (std::uint32_t i = 0; i < kept.size(); ++i) {
                if (kept[i].first != kNone && kept[i].second.overlaps(window)) expected.push_back(i);
            }
            QVERIFY(found(tree, window) == expected);
        }
    }
    /// With so many, a search for each removed box would exceed the time limit of any test.
    void pendingBoxesKeepTheirOrderWhenOthersAreRemoved() {
        constexpr std::uint32_t kCount = 2'000'000;
        DynamicBoxTree tree;
        std::vector<std::uint32_t> leaves, expected, visited;
        for (std::uint32_t i = 0; i < kCount; ++i) leaves.push_back(tree.insert({Vec3f(0.0f), Vec3f(1.0f)}, i));
        for (std::uint32_t i = kCount; i-- > 0;) {
            if (i % 1000 != 7) tree.remove(leaves[i]);
        }
        for (std::uint32_t i = 7; i < kCount; i += 1000) expected.push_back(i);
        expected.push_back(kCount);
        tree.insert({Vec3f(0.0f), Vec3f(1.0f)}, kCount);
        const Box all{Vec3f(-1.0f), Vec3f(2.0f)};
        tree.visitOverlapping(all, [&](std::uint32_t number, const Box&) { visited.push_back(number); });
        QCOMPARE(visited, expected);
        QCOMPARE(tree.size(), expected.size());
        tree.update();
        QCOMPARE(found(tree, all), expected);
    }
    /// Of a grid of 1000 boxes, 400 are inserted one by one: a search for one box looks at a small part of the tree.
    void insertedBoxesKeepTheTreeBalanced() {
        const auto boxAt = [](std::uint32_t i) {
            const Vec3f low(static_cast<float>(i % 10), static_cast<float>(i / 10 % 10), static_cast<float>(i / 100));
            return Box{low, low + Vec3f(0.5f)};
        };
        DynamicBoxTree tree;
        for (std::uint32_t i = 0; i < 600; ++i) tree.insert(boxAt(i * 7 % 1000), i);
        tree.update();
        for (std::uint32_t i = 600; i < 1000; ++i) {
            tree.insert(boxAt(i * 7 % 1000), i);
            tree.update();
        }
        int tested = 0;
        for (std::uint32_t i = 0; i < 1000; ++i) {
            const auto overlaps = [&](const Box& box) {
                ++tested;
                return box.overlaps(boxAt(i));
            };
            int seen = 0;
            tree.visitIf(overlaps, [&](std::uint32_t, const Box&) { ++seen; });
            QCOMPARE(seen, 1);
        }
        QVERIFY2(tested < 1000 * 60, qPrintable(QString::number(tested)));
    }
    void enlargedBoxesAreFoundWhereTheyAreNow() {
        DynamicBoxTree tree;
        std::vector<std::uint32_t> leaves;
        for (std::uint32_t i = 0; i < 100; ++i) {
            const Vec3f low(static_cast<float>(i), 0.0f, 0.0f);
            leaves.push_back(tree.insert({low, low + Vec3f(0.5f)}, i));
        }
        tree.update();
        tree.enlarge(leaves[3], {Vec3f(3.0f, 5.0f, 0.0f), Vec3f(3.5f, 6.0f, 0.5f)});
        tree.enlarge(leaves[3], {Vec3f(3.1f, 5.1f, 0.1f), Vec3f(3.2f, 5.2f, 0.2f)});  // nothing new
        QCOMPARE(found(tree, {Vec3f(0.0f, 5.5f, 0.0f), Vec3f(100.0f, 5.6f, 0.1f)}), (std::vector<std::uint32_t>{3}));
        QCOMPARE(found(tree, {Vec3f(3.0f, 0.0f, 0.0f), Vec3f(3.1f, 0.1f, 0.1f)}), (std::vector<std::uint32_t>{3}));
        QVERIFY(tree.box(leaves[3]).high == Vec3f(3.5f, 6.0f, 0.5f));
    }
    void rowOfBoxesIsVisitedCompletely() {
        DynamicBoxTree tree;
        for (std::uint32_t i = 0; i < 5000; ++i) {
            const Vec3f low(static_cast<float>(i), 0.0f, 0.0f);
            tree.insert({low, low + Vec3f(0.5f)}, i);
        }
        QCOMPARE(found(tree, {Vec3f(-1.0f), Vec3f(1e6f)}).size(), std::size_t{5000});
    }
};

RUBBLE_TEST(DynamicBoxTreeTest)
#include "DynamicBoxTreeTest.moc"
