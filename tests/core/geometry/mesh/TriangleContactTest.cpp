// Tests core/geometry/mesh/TriangleContact.cpp.
#include "core/geometry/mesh/TriangleContact.h"

#include "core/base/Random.h"
#include "core/geometry/mesh/MeshVerdict.h"
#include "core/geometry/predicates/WideInteger.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/BrokenMeshes.h"
#include "tests/support/geometry/SolidShapes.h"

#include <QTest>

#include <algorithm>
#include <numeric>
#include <vector>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A fraction in lowest terms; the coordinates here are so small that all of them fit.
struct Fraction {
    Int128 over = 0, under = 1;
    Fraction(Int128 a = 0, Int128 b = 1) : over(b < 0 ? -a : a), under(b < 0 ? -b : b) {
        Int128 x = over < 0 ? -over : over, y = under;
        while (y != 0) x = std::exchange(y, x % y);
        over /= x, under /= x;
    }
    int sign() const { return over > 0 ? 1 : over < 0 ? -1 : 0; }
    friend Fraction operator+(Fraction a, Fraction b) {
        return {a.over * b.under + b.over * a.under, a.under * b.under};
    }
    friend Fraction operator-(Fraction a, Fraction b) { return a + Fraction(-b.over, b.under); }
    friend Fraction operator*(Fraction a, Fraction b) { return {a.over * b.over, a.under * b.under}; }
    friend Fraction operator/(Fraction a, Fraction b) { return {a.over * b.under, a.under * b.over}; }
};

struct Place {
    Fraction x, y, z;
    friend Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
    friend Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
    friend Place operator*(const Place& a, Fraction s) { return {a.x * s, a.y * s, a.z * s}; }
};
Fraction dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Place cross(const Place& a, const Place& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
using Shape = std::vector<Place>;

Shape shapeOf(const std::array<Vec3, 3>& triangle) {
    Shape shape;
    for (const Vec3 p : triangle) shape.push_back({Int128(p.x), Int128(p.y), Int128(p.z)});
    return shape;
}
Place normalOf(const Shape& triangle) { return cross(triangle[1] - triangle[0], triangle[2] - triangle[0]); }

Shape clipped(const Shape& shape, const Place& onPlane, const Place& normal) {
    Shape kept;
    for (std::size_t k = 0; k < shape.size(); ++k) {
        const Place &a = shape[k], &b = shape[(k + 1) % shape.size()];
        const Fraction da = dot(a - onPlane, normal), db = dot(b - onPlane, normal);
        if (da.sign() >= 0) kept.push_back(a);
        if (da.sign() * db.sign() < 0) kept.push_back(a + (b - a) * (da / (da - db)));
    }
    return kept;
}

/// The triangles' intersection.
Shape common(const Shape& a, const Shape& b) {
    const Place normal = normalOf(b);
    Shape rest = clipped(clipped(a, b[0], normal), b[0], normal * Fraction(-1));
    for (int k = 0; k < 3; ++k) rest = clipped(rest, b[k], cross(normal, b[(k + 1) % 3] - b[k]));
    return rest;
}

bool isStrictlyInside(const Shape& triangle, const Place& point) {
    const Place normal = normalOf(triangle);
    for (int k = 0; k < 3; ++k) {
        if (dot(cross(normal, triangle[(k + 1) % 3] - triangle[k]), point - triangle[k]).sign() <= 0) return false;
    }
    return true;
}

/// The contact of triangles that are not degenerate, from their intersection; `None` for Line, too, which is left to
/// what is around edges.
TriangleContact judgedContact(const std::array<Vec3, 3>& first, const std::array<Vec3, 3>& second) {
    const Shape a = shapeOf(first), b = shapeOf(second), rest = common(a, b);
    Place far = {}, area = {};
    for (std::size_t k = 1; k < rest.size(); ++k) {
        const Place step = rest[k] - rest[0];
        if (dot(step, step).sign() > 0) far = step;
        area = area + cross(rest[k - 1] - rest[0], step);
    }
    if (dot(area, area).sign() > 0)
        return dot(normalOf(a), normalOf(b)).sign() > 0 ? TriangleContact::Cross : TriangleContact::Face;
    if (dot(far, far).sign() == 0) return TriangleContact::None;
    // Two different points of a segment: the middle is inside it.
    const Place middle = rest[0] + far * Fraction(1, 2);
    return isStrictlyInside(a, middle) && isStrictlyInside(b, middle) ? TriangleContact::Cross : TriangleContact::None;
}

LatticeSurface surfaceOf(const TriangleMesh& mesh) {
    LatticeSurface surface{mesh.points, mesh.triangles, {}, {}};
    for (const auto& [a, b, c] : mesh.triangles)
        surface.views.push_back(viewOf(mesh.points[a], mesh.points[b], mesh.points[c]));
    return surface;
}
std::array<Vec3, 3> cornersOf(const TriangleMesh& mesh, std::uint32_t t) {
    const auto [a, b, c] = mesh.triangles[t];
    return {mesh.points[a], mesh.points[b], mesh.points[c]};
}
TriangleContact reduced(TriangleContact contact) {
    return contact == TriangleContact::Line ? TriangleContact::None : contact;
}

Vec3 randomPlace(Random& random, std::uint64_t size) {
    const double x = double(random.below(size)), y = double(random.below(size));
    return {x, y, double(random.below(size))};
}

TriangleMesh randomClosedMesh(Random& random, std::uint64_t size) {
    const std::array shapes = {box(Vec3(0.0), Vec3(1.0)), bumpySphere(4), torus(4, 3),
                               cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
                               tetrahedron({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})};
    TriangleMesh mesh = shapes[random.below(shapes.size())];
    for (Vec3& point : mesh.points) point = randomPlace(random, size);
    return mesh;
}

}  // namespace

class TriangleContactTest : public QObject {
    Q_OBJECT
private slots:
    void contactsHaveFourKinds() {
        const TriangleMesh mesh = {
            {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {9, 1, 0}, {1, 2, 0}, {2, 1, 0}, {1, 1, 0}},
            {{0, 1, 2}, {3, 4, 5}, {4, 6, 7}, {8, 6, 7}, {8, 7, 6}, {0, 4, 1}}};
        const LatticeSurface surface = surfaceOf(mesh);
        QCOMPARE(contactOf(surface, 0, 1), TriangleContact::Cross);
        QCOMPARE(contactOf(surface, 0, 2), TriangleContact::Line);
        QCOMPARE(contactOf(surface, 0, 3), TriangleContact::Face);
        QCOMPARE(contactOf(surface, 0, 4), TriangleContact::Cross);
        QCOMPARE(contactOf(surface, 0, 5), TriangleContact::None);  // neighbours
        QCOMPARE(contactOf(surface, 1, 5), TriangleContact::None);  // a common corner
    }
    /// 20,000 pairs on lattices of 2³ to 8³ points, where most things tie.
    void contactsAreThoseOfFractions() {
        std::array<int, 4> counts{};
        for (std::uint64_t seed = 0; seed < 20'000; ++seed) {
            Random random(seed);
            const std::uint64_t size = 2 + random.below(7);
            TriangleMesh mesh{{}, {{0, 1, 2}, {3, 4, 5}}};
            for (int k = 0; k < 6; ++k) mesh.points.push_back(randomPlace(random, size));
            for (int k = 0; k < 3; ++k) {  // common corners, by index
                if (random.below(4) == 0) mesh.triangles[1][k] = static_cast<std::uint32_t>(random.below(3));
            }
            const LatticeSurface surface = surfaceOf(mesh);
            if (surface.isDegenerate(0) || surface.isDegenerate(1)) continue;
            const TriangleContact contact = contactOf(surface, 0, 1);
            ++counts[std::size_t(contact)];
            const TriangleContact expected = judgedContact(cornersOf(mesh, 0), cornersOf(mesh, 1));
            QVERIFY2(reduced(contact) == expected, qPrintable(QString("seed %1").arg(seed)));
            QCOMPARE(contactOf(surface, 1, 0), contact);
        }
        for (const int count : counts) QVERIFY(count > 100);
    }
    /// 2,000 random closed meshes on small lattices: all pairs by fractions, and windings of random points.
    void verdictsAreThoseOfAllPairs() {
        int fit = 0, crossing = 0;
        for (std::uint64_t seed = 0; seed < 2'000; ++seed) {
            Random random(seed);
            const std::uint64_t size = 2 + random.below(5);
            const TriangleMesh mesh = randomClosedMesh(random, size);
            const LatticeSurface surface = surfaceOf(mesh);
            std::size_t pairs = 0;
            for (std::uint32_t a = 0; a < mesh.triangles.size(); ++a) {
                for (std::uint32_t b = a + 1; b < mesh.triangles.size(); ++b) {
                    if (surface.isDegenerate(a) || surface.isDegenerate(b)) continue;
                    pairs += judgedContact(cornersOf(mesh, a), cornersOf(mesh, b)) == TriangleContact::Cross;
                }
            }
            const Result<MeshVerdict> verdict = judgeMesh(mesh);
            const QByteArray name = QString("seed %1").arg(seed).toUtf8();
            QVERIFY2(verdict, name);
            if (!verdict->isFit()) {
                const MeshFinding& fault = verdict->findings[0];
                if (fault.kind == MeshFindingKind::Crossing) QVERIFY2(fault.count >= pairs, name);
                if (fault.kind == MeshFindingKind::NoThickness) QVERIFY2(pairs == 0, name);
                crossing += fault.kind == MeshFindingKind::Crossing;
                continue;
            }
            ++fit;
            QVERIFY2(pairs == 0, name);
            for (int k = 0; k < 300; ++k) {
                const double most = double(size) - 1.0, x = random.between(0.0, most), y = random.between(0.0, most);
                const int number = windingNumber(verdict->mesh, {x, y, random.between(0.0, most)});
                QVERIFY2(number == 0 || number == 1, name);
            }
        }
        QVERIFY(fit > 200 && crossing > 500);
    }
    void commonPointsAreOnBoth() {
        const TriangleMesh mesh = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, -1}, {1, 1, 1}, {2, 1, -1}},
                                   {{0, 1, 2}, {3, 4, 5}}};
        const Vec3 point = commonPoint(surfaceOf(mesh), 0, 1);
        QCOMPARE(point, Vec3(1.25, 1, 0));
    }
};

RUBBLE_TEST(TriangleContactTest)
#include "TriangleContactTest.moc"
