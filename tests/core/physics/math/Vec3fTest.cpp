#include "core/physics/math/Vec3f.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

bool isNear(Vec3f a, Vec3f b) { return length(a - b) < 1e-6f; }

/// A rotation by 90 degrees about z: x to y, y to -x.
const Quatf kQuarter{0.0f, 0.0f, std::sqrt(0.5f), std::sqrt(0.5f)};

}  // namespace

class Vec3fTest : public QObject {
    Q_OBJECT
private slots:
    void products() {
        QCOMPARE(dot(Vec3f(1.0f, 2.0f, 3.0f), Vec3f(4.0f, -5.0f, 6.0f)), 12.0f);
        QVERIFY(cross(Vec3f(1.0f, 2.0f, 3.0f), Vec3f(4.0f, -5.0f, 6.0f)) == Vec3f(27.0f, 6.0f, -13.0f));
        QCOMPARE(length(Vec3f(2.0f, 3.0f, 6.0f)), 7.0f);
        QVERIFY(isNear(normalized(Vec3f(0.0f, 3.0f, -4.0f)), Vec3f(0.0f, 0.6f, -0.8f)));
        QVERIFY(normalized(Vec3f(1e-21f, 0.0f, 0.0f)) == Vec3f(0.0f));
    }
    void componentsOfEach() {
        const Vec3f a(1.0f, -2.0f, 3.0f), b(0.0f, 5.0f, 3.0f);
        QVERIFY(componentMin(a, b) == Vec3f(0.0f, -2.0f, 3.0f));
        QVERIFY(componentMax(a, b) == Vec3f(1.0f, 5.0f, 3.0f));
        QVERIFY(componentAbs(a) == Vec3f(1.0f, 2.0f, 3.0f));
    }
    void rotationsOfAQuaternionAndItsMatrix() {
        const Mat3f matrix = kQuarter.matrix();
        QVERIFY(isNear(matrix * Vec3f(1.0f, 2.0f, 3.0f), Vec3f(-2.0f, 1.0f, 3.0f)));
        QVERIFY(isNear(matrix.transposedTimes(Vec3f(-2.0f, 1.0f, 3.0f)), Vec3f(1.0f, 2.0f, 3.0f)));
        QVERIFY(isNear(matrix.transposed() * Vec3f(-2.0f, 1.0f, 3.0f), Vec3f(1.0f, 2.0f, 3.0f)));
        QVERIFY(isNear((matrix * matrix) * Vec3f(1.0f, 2.0f, 3.0f), Vec3f(-1.0f, -2.0f, 3.0f)));
    }
    /// About z, then about x: x to y to z.
    void productOfQuaternionsRotatesByTheRightFirst() {
        const Quatf aboutX{std::sqrt(0.5f), 0.0f, 0.0f, std::sqrt(0.5f)};
        QVERIFY(isNear((aboutX * kQuarter).matrix() * Vec3f(1.0f, 0.0f, 0.0f), Vec3f(0.0f, 0.0f, 1.0f)));
        const Quatf none = kQuarter * kQuarter.conjugate();
        QVERIFY(isNear(none.vector(), Vec3f(0.0f)) && std::abs(none.w - 1.0f) < 1e-6f);
    }
    /// All products of i, j and k: i j = k, j k = i, k i = j, and i i = -1.
    void unitsMultiplyAsQuaternions() {
        const Quatf i{1, 0, 0, 0}, j{0, 1, 0, 0}, k{0, 0, 1, 0};
        const auto is = [](const Quatf& a, const Quatf& b) {
            return a.x == b.x && a.y == b.y && a.z == b.z && a.w == b.w;
        };
        QVERIFY(is(i * j, k) && is(j * k, i) && is(k * i, j));
        QVERIFY(is(j * i, k.conjugate()) && is(k * j, i.conjugate()) && is(i * k, j.conjugate()));
        QVERIFY(is(i * i, {0, 0, 0, -1}) && is(j * j, {0, 0, 0, -1}) && is(k * k, {0, 0, 0, -1}));
    }
    void quaternionsAreNormalized() {
        const Quatf q = Quatf{1.0f, 3.0f, 1.0f, 5.0f}.normalized();  // of length 6
        QVERIFY(isNear(q.vector(), Vec3f(1.0f, 3.0f, 1.0f) / 6.0f) && std::abs(q.w - 5.0f / 6.0f) < 1e-6f);
    }
    void symmetricMatrixTimesVector() {
        const SymMat3f m{1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f};
        QVERIFY(m * Vec3f(1.0f, 0.0f, 0.0f) == Vec3f(1.0f, 2.0f, 3.0f));
        QVERIFY(m * Vec3f(0.0f, 1.0f, 0.0f) == Vec3f(2.0f, 4.0f, 5.0f));
        QVERIFY(m * Vec3f(0.0f, 0.0f, 1.0f) == Vec3f(3.0f, 5.0f, 6.0f));
    }
    /// Axes x and y change places, up to the sign of one.
    void tensorInRotatedAxes() {
        const SymMat3f m = rotated({1.0f, 2.0f, 3.0f, 4.0f, 5.0f, 6.0f}, kQuarter.matrix());
        QVERIFY(isNear({m.xx, m.yy, m.zz}, {4.0f, 1.0f, 6.0f}));
        QVERIFY(isNear({m.xy, m.xz, m.yz}, {-2.0f, -5.0f, 3.0f}));
    }
    void conversionsKeepTheValues() {
        QVERIFY(toFloat(Vec3(1.0, 2.0, 3.0)) == Vec3f(1.0f, 2.0f, 3.0f));
        QVERIFY(toDouble(Vec3f(1.0f, 2.0f, 3.0f)) == Vec3(1.0, 2.0, 3.0));
        const Quat q = toDouble(toFloat(Quat{5.0 / 6.0, 1.0 / 6.0, 3.0 / 6.0, 1.0 / 6.0}));
        QVERIFY(std::abs(q.w - 5.0 / 6.0) < 1e-6 && std::abs(q.x - 1.0 / 6.0) < 1e-6);
        QVERIFY(std::abs(q.y - 3.0 / 6.0) < 1e-6 && std::abs(q.z - 1.0 / 6.0) < 1e-6);
        const SymMat3f m = toFloat(Mat3(Vec3(1, 2, 3), Vec3(2, 4, 5), Vec3(3, 5, 6)));
        QVERIFY(m.xx == 1.0f && m.xy == 2.0f && m.xz == 3.0f && m.yy == 4.0f && m.yz == 5.0f && m.zz == 6.0f);
    }
};

RUBBLE_TEST(Vec3fTest)
#include "Vec3fTest.moc"
