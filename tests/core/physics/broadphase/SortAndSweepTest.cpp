#include "core/base/Random.h"
#include "core/physics/broadphase/SortAndSweep.h"
#include "tests/support/TestProgram.h"

#include <QTest>

#include <set>
#include <utility>

using namespace rubble;

namespace {

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

Box randomBoxIn(Random& random, Vec3f room) {
    const auto between = [&](float least, float most) { return static_cast<float>(random.between(least, most)); };
    const Vec3f low(between(-room.x, room.x), between(-room.y, room.y), between(-room.z, room.z));
    return {low, low + Vec3f(between(0.1f, 1.0f), between(0.1f, 1.0f), between(0.1f, 1.0f))};
}

/// The pairs found by the sweep, sorted; none must be found twice.
Pairs sweptPairs(const std::vector<Box>& boxes) {
    SortAndSweep sweep;
    for (std::size_t i = 0; i < boxes.size(); ++i) sweep.add(static_cast<std::uint32_t>(i), boxes[i]);
    sweep.sort();
    SortAndSweep::Scratch scratch;
    Pairs pairs;
    for (std::size_t place = 0; place < sweep.size(); ++place) {
        const std::uint32_t number = sweep.number(place);
        for (const std::uint32_t other : sweep.overlappingLater(place, scratch)) {
            const bool isNew = pairs.insert(std::minmax(number, other)).second;
            if (!isNew) qFatal("a pair was reported twice");
        }
    }
    return pairs;
}

Pairs triedPairs(const std::vector<Box>& boxes) {
    Pairs pairs;
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
            if (boxes[i].overlaps(boxes[j])) pairs.insert({i, j});
        }
    }
    return pairs;
}

}  // namespace

class SortAndSweepTest : public QObject {
    Q_OBJECT
private slots:
    void findsEachOverlappingPairOnce() {
        constexpr std::uint64_t kSeed = 117;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        std::size_t found = 0;
        for (const Vec3f room : {Vec3f(5.0f, 1.0f, 1.0f), Vec3f(1.0f, 5.0f, 2.0f), Vec3f(1.0f, 1.0f, 9.0f)}) {
            for (int count = 0; count < 200; count += 7) {
                std::vector<Box> boxes;
                for (int i = 0; i < count; ++i) boxes.push_back(randomBoxIn(random, room));
                if (count > 0) boxes.push_back({Vec3f(-20.0f), Vec3f(20.0f)});  // as the ground is
                const Pairs pairs = sweptPairs(boxes);
                QVERIFY(pairs == triedPairs(boxes));
                found += pairs.size();
            }
        }
        QVERIFY(found > 10000);
    }
    void touchingBoxesOverlap() {
        const Box box{Vec3f(-0.0f), Vec3f(1.0f)}, above{Vec3f(0.0f, 1.0f, 0.0f), Vec3f(1.0f, 2.0f, 1.0f)};
        QVERIFY((sweptPairs({box, above, box}) == Pairs{{0, 1}, {0, 2}, {1, 2}}));
    }
    void ranksFollowTheLowEnds() {
        SortAndSweep sweep;
        for (const float low : {3.0f, -2.0f, 0.0f, -0.0f, -7.5f}) {
            sweep.add(static_cast<std::uint32_t>(sweep.size()),
                      {Vec3f(low, 0.0f, 0.0f), Vec3f(low + 0.5f, 1.0f, 1.0f)});
        }
        sweep.sort();
        const std::vector<std::uint32_t> expected{4, 1, 2, 3, 0};  // of equal ones, as they were added
        for (std::size_t place = 0; place < expected.size(); ++place) QCOMPARE(sweep.number(place), expected[place]);
        sweep.clear();
        sweep.sort();
        QCOMPARE(sweep.size(), std::size_t{0});
    }
};

RUBBLE_TEST(SortAndSweepTest)
#include "SortAndSweepTest.moc"
