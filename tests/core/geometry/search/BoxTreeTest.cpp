#include "core/geometry/search/BoxTree.h"

#include "core/base/Index.h"
#include "core/base/Random.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "tests/support/TestProgram.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <numbers>

using namespace rubble;

namespace {

using Segment = std::array<Vec3, 2>;

std::vector<Box3> boxesOf(const std::vector<Segment>& segments) {
    std::vector<Box3> boxes;
    for (const Segment& segment : segments) {
        Box3& box = boxes.emplace_back();
        for (const Vec3 point : segment) box.include(point);
    }
    return boxes;
}

/// The segment nearest to a point, the first of equal ones.
struct Nearest {
    std::uint32_t item = kNone;
    double distance = 1e308;

    double visit(const std::vector<Segment>& segments, std::uint32_t k, Vec3 point) {
        const double value = distanceToSegment(point, segments[k][0], segments[k][1]);
        if (value < distance || (value == distance && k < item)) *this = {k, value};
        return distance;
    }
};

}  // namespace

class BoxTreeTest : public QObject {
    Q_OBJECT
private slots:
    void nearestIsThatOfALinearScan() {
        Random random(20261123);
        const auto point = [&] {
            return Vec3(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
        };
        for (const std::size_t count : {1u, 2u, 5u, 100u, 1000u}) {
            std::vector<Segment> segments;
            for (std::size_t k = 0; k < count; ++k) segments.push_back({point(), point()});
            segments.push_back(segments[0]);  // an equal one
            const BoxTree tree(boxesOf(segments));
            for (int query = 0; query < 200; ++query) {
                const Vec3 from = query % 2 == 0 ? point() : segments[random.below(count)][1];
                Nearest linear, found;
                for (std::uint32_t k = 0; k < segments.size(); ++k) linear.visit(segments, k, from);
                tree.visitNear(from, [&](std::uint32_t k) { return found.visit(segments, k, from); });
                QCOMPARE(found.item, linear.item);
                QCOMPARE(found.distance, linear.distance);
            }
        }
    }
    void nearestVisitsFewItems() {
        constexpr std::uint32_t kCount = 65536;
        std::vector<Segment> segments;
        const auto onCircle = [](std::uint32_t k) {
            const double angle = 2.0 * std::numbers::pi * k / kCount;
            return Vec3(std::cos(angle), std::sin(angle), 0.0);
        };
        for (std::uint32_t k = 0; k < kCount; ++k) segments.push_back({onCircle(k), onCircle(k + 1)});
        const BoxTree tree(boxesOf(segments));
        std::size_t visited = 0;
        for (std::uint32_t k = 0; k < kCount; ++k) {
            const Vec3 middle = (segments[k][0] + segments[k][1]) / 2.0;
            Nearest found;
            visited += tree.visitNear(middle, [&](std::uint32_t item) { return found.visit(segments, item, middle); });
            QCOMPARE(found.item, k);
        }
        QVERIFY2(visited < 16u * kCount, qPrintable(QString::number(visited)));
    }
    void overlappingAreThoseOfALinearScan() {
        const std::uint64_t seed = 4;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        for (const std::size_t count : {1u, 3u, 50u, 700u}) {
            std::vector<Box3> boxes;
            // On a coarse lattice, so that many boxes only touch.
            const auto coordinate = [&] { return static_cast<double>(random.below(40)); };
            const auto randomBox = [&](double size) {
                const Vec3 low(coordinate(), coordinate(), coordinate());
                return Box3{low, low + Vec3(size, size, 1.0)};
            };
            for (std::size_t k = 0; k < count; ++k) boxes.push_back(randomBox(static_cast<double>(random.below(6))));
            const BoxTree tree(boxes);
            for (int query = 0; query < 100; ++query) {
                const Box3 around = randomBox(5.0);
                std::vector<std::uint32_t> expected, found;
                for (std::uint32_t k = 0; k < count; ++k) {
                    bool isApart = false;
                    for (int axis = 0; axis < 3; ++axis)
                        isApart |= boxes[k].min[axis] > around.max[axis] || boxes[k].max[axis] < around.min[axis];
                    if (!isApart) expected.push_back(k);
                }
                tree.visitOverlapping(around, [&](std::uint32_t item) { found.push_back(item); });
                std::vector<std::uint32_t> withBoxes;
                tree.visitOverlapping(around, [&](std::uint32_t item, const Box3& box) {
                    if (box.min == boxes[item].min && box.max == boxes[item].max) withBoxes.push_back(item);
                });
                QCOMPARE(withBoxes, found);
                std::ranges::sort(found);
                QCOMPARE(found, expected);
            }
        }
    }
    void beyondAPlaneAreThoseOfALinearScan() {
        Random random(20261130);
        std::vector<Box3> boxes;
        for (int k = 0; k < 500; ++k) {
            const Vec3 low(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0));
            boxes.push_back({low, low + Vec3(0.1 * random.unit(), 0.1 * random.unit(), 0.0)});
        }
        const BoxTree tree(boxes);
        for (int round = 0; round < 200; ++round) {
            const Vec3 normal =
                glm::normalize(Vec3(random.between(-1.0, 1.0), random.between(-1.0, 1.0), random.between(-1.0, 1.0)));
            const double offset = random.between(-1.5, 1.5);
            std::vector<bool> isVisited(boxes.size(), false);
            tree.visitBeyond(normal, offset, [&](std::uint32_t item) { isVisited[item] = true; });
            for (std::size_t k = 0; k < boxes.size(); ++k) {
                bool isBeyond = false;
                for (int corner = 0; corner < 8; ++corner)
                    isBeyond |= glm::dot(normal, boxes[k].corner(corner)) > offset;
                QVERIFY(!isBeyond || isVisited[k]);
            }
        }
    }
    void beyondATangentAreFewItems() {
        constexpr int kCount = 20'000;
        std::vector<Box3> points;
        for (int k = 0; k < kCount; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kCount;
            const Vec3 point(std::cos(angle), std::sin(angle), 0.0);
            points.push_back({point, point});
        }
        int visited = 0;
        BoxTree(points).visitBeyond(glm::normalize(Vec3(1.0, 2.0, 0.0)), 1.0 + 1e-9, [&](std::uint32_t) { ++visited; });
        QVERIFY2(visited < 1000, qPrintable(QString::number(visited)));
    }
    void emptyTreeVisitsNothing() {
        BoxTree({}).visitOverlapping({Vec3(-1.0), Vec3(1.0)}, [](std::uint32_t) { QFAIL("there are no items"); });
        QCOMPARE(BoxTree({}).visitNear(Vec3(0.0), [](std::uint32_t) { return 0.0; }), std::size_t{0});
    }
};

RUBBLE_TEST(BoxTreeTest)
#include "BoxTreeTest.moc"
