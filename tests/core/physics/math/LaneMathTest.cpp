// Tests core/physics/math/LaneMath.h and core/physics/math/Lanes.cpp.
#include "core/physics/math/LaneMath.h"
#include "core/physics/math/Lanes.h"
#include "core/physics/math/Vec3f.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

// Four lanes, which every machine has that the tests run on.
constexpr int kW = 4;
using F = Floats<kW>;
using V = WideVec3<kW>;
using Q = WideQuat<kW>;

const V kA{F{1, -2, 3, 0.5f}, F{2, 4, -1, 0}, F{3, 1, 0, -1}};
const V kB{F{4, 1, 2, 2}, F{-5, 0, 2, 1}, F{6, 2, 1, -3}};

Vec3f at(const V& v, int lane) { return Vec3f(v.x[lane], v.y[lane], v.z[lane]); }
Quatf at(const Q& q, int lane) { return {q.x[lane], q.y[lane], q.z[lane], q.w[lane]}; }

}  // namespace

/// Every lane does what the scalar code does.
class LaneMathTest : public QObject {
    Q_OBJECT
private slots:
    void lanesAreLoadedAndStored() {
        const std::array<float, 5> row{9, 1, 2, 3, 4};
        std::array<float, 5> copy{};
        store<kW>(loaded<kW>(row.data() + 1), copy.data() + 1);
        QCOMPARE(copy, (std::array<float, 5>{0, 1, 2, 3, 4}));
        QCOMPARE(all<kW>(2.5f)[3], 2.5f);
    }
    void masksSelectLanes() {
        const F a{1, 2, 3, 4}, b{4, 3, 2, 1};
        QCOMPARE(bitsOf<kW>(a > b), 0b1100u);
        const F larger = select<kW>(a > b, a, b);
        for (int lane = 0; lane < kW; ++lane) {
            QCOMPARE(larger[lane], std::max(a[lane], b[lane]));
            QCOMPARE((greater<kW>(a, b))[lane], std::max(a[lane], b[lane]));
            QCOMPARE((lesser<kW>(a, b))[lane], std::min(a[lane], b[lane]));
        }
    }
    void rootsAndInverses() {
        QCOMPARE(squareRoot<kW>(F{0, 1, 4, 9})[3], 3.0f);
        const F inverse = inverseOrZero<kW>(F{-1, 0, 4, 0.5f});
        QVERIFY(inverse[0] == 0.0f && inverse[1] == 0.0f && inverse[2] == 0.25f && inverse[3] == 2.0f);
    }
    void matricesAreTransposed() {
        F rows[4] = {{0, 1, 2, 3}, {4, 5, 6, 7}, {8, 9, 10, 11}, {12, 13, 14, 15}};
        transpose<kW>(rows);
        for (int i = 0; i < 4; ++i) {
            for (int j = 0; j < 4; ++j) QCOMPARE(rows[i][j], static_cast<float>(4 * j + i));
        }
    }
    void vectors() {
        for (int lane = 0; lane < kW; ++lane) {
            QVERIFY(at(kA + kB, lane) == at(kA, lane) + at(kB, lane));
            QVERIFY(at(kA - kB, lane) == at(kA, lane) - at(kB, lane));
            QVERIFY(at(kA * kB.x, lane) == at(kA, lane) * kB.x[lane]);
            QCOMPARE((dot<kW>(kA, kB))[lane], dot(at(kA, lane), at(kB, lane)));
            QVERIFY(at(cross<kW>(kA, kB), lane) == cross(at(kA, lane), at(kB, lane)));
        }
    }
    void symmetricMatrices() {
        const WideSym3<kW> m{all<kW>(1), all<kW>(2), all<kW>(3), all<kW>(4), all<kW>(5), all<kW>(6)};
        const SymMat3f one{1, 2, 3, 4, 5, 6};
        for (int lane = 0; lane < kW; ++lane) QVERIFY(at(m * kA, lane) == one * at(kA, lane));
    }
    void quaternions() {
        const Q q{kA.x, kA.y, kA.z, kB.x}, r{kB.y, kB.z, kA.y, kA.x};
        for (int lane = 0; lane < kW; ++lane) {
            const Quatf product = at(q * r, lane), expected = at(q, lane) * at(r, lane);
            QVERIFY(product.vector() == expected.vector() && product.w == expected.w);
            const Quatf conjugate = at(q.conjugate(), lane);
            QVERIFY(conjugate.vector() == at(q, lane).vector() * -1.0f && conjugate.w == q.w[lane]);
        }
    }
    void rotationIsThatOfTheMatrix() {
        const Quatf unit = Quatf{1.0f, -2.0f, 0.5f, 3.0f}.normalized();
        const Q q{all<kW>(unit.x), all<kW>(unit.y), all<kW>(unit.z), all<kW>(unit.w)};
        for (int lane = 0; lane < kW; ++lane) {
            QVERIFY(length(at(rotated<kW>(q, kA), lane) - unit.matrix() * at(kA, lane)) < 1e-5f);
        }
    }
    void widthsAreListedNarrowestFirst() {
        const std::vector<SimdWidth> widths = availableSimdWidths();
        QCOMPARE(widths.front(), SimdWidth::Scalar);
        QCOMPARE(widths.back(), widestSimd());
        QVERIFY(std::is_sorted(widths.begin(), widths.end()));
        QCOMPARE(nameOf(SimdWidth::Scalar), "scalar");
        QCOMPARE(nameOf(SimdWidth::Four), "four lanes");
        QCOMPARE(nameOf(SimdWidth::Eight), "eight lanes");
    }
};

RUBBLE_TEST(LaneMathTest)
#include "LaneMathTest.moc"
