#include "core/play/damage/DamageBytes.h"

#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;

namespace {

constexpr std::uint64_t kBytesSeed = 5;

InstanceDamage anyBits(Random& random) {
    InstanceDamage damage{.bake = {random.next(), random.next()}, .broken = std::vector<bool>(random.below(600))};
    for (std::size_t k = 0; k < damage.broken.size(); ++k) damage.broken[k] = random.below(2) == 0;
    if (random.below(2) == 0) damage.cut = ImpactCut{{random.unit(), -random.unit()}, random.below(1000)};
    if (damage.cut && random.below(2) == 0) damage.cut->height = random.below(5) == 0 ? -0.0 : random.unit();
    return damage;
}

/// The bytes with a checksum that fits.
std::string sealed(std::string bytes) {
    bytes.resize(bytes.size() - 8);
    const std::uint64_t sum = contentHash(bytes).low;
    for (int k = 0; k < 8; ++k) bytes.push_back(static_cast<char>(sum >> (8 * k)));
    return bytes;
}

std::string reasonIn(const std::string& bytes) {
    const Result<InstanceDamage> read = damageOfBytes(bytes);
    return read ? std::string() : read.error().message;
}

}  // namespace

class DamageBytesTest : public QObject {
    Q_OBJECT
private slots:
    void isReadAsWrittenAndSmall() {
        qInfo("seed %d", static_cast<int>(kBytesSeed));
        Random random(kBytesSeed);
        for (int round = 0; round < 500; ++round) {
            const InstanceDamage damage = anyBits(random);
            const std::string bytes = damageBytes(damage);
            QVERIFY(static_cast<double>(bytes.size()) <= static_cast<double>(damage.broken.size()) / 8.0 + 72.0);
            const Result<InstanceDamage> read = damageOfBytes(bytes);
            QVERIFY(read.hasValue());
            QVERIFY(*read == damage);
        }
    }
    /// As before there were cuts of meshes; programs of that time refuse those.
    void heightsAreWrittenOfCutsOfMeshesOnly() {
        InstanceDamage damage{.bake = {1, 2}, .cut = ImpactCut{{0.5, 0.25}, 7}, .broken = {true}};
        const std::string flat = damageBytes(damage);
        QCOMPARE(flat.size(), std::size_t{60});
        QCOMPARE(static_cast<int>(flat[6]), 1);
        QCOMPARE(QByteArray::fromStdString(flat).left(52).toHex(),
                 QByteArray("52444d470101010100000000000000020000000000000001000000000000000000e03f000000000000d03f0700"
                            "00000000000001"));
        damage.cut->height = -0.5;
        const std::string high = damageBytes(damage);
        QCOMPARE(high.size(), std::size_t{68});
        QCOMPARE(static_cast<int>(high[6]), 2);
        QVERIFY(*damageOfBytes(high) == damage);
        std::string zero = high, infinite = high;
        for (std::size_t k = 51; k < 59; ++k) zero[k] = 0;
        QCOMPARE(reasonIn(sealed(zero)), std::string("The damage cannot be read: the height of its cut is zero."));
        infinite[57] = static_cast<char>(0xf0);
        infinite[58] = 0x7f;
        QCOMPARE(reasonIn(sealed(infinite)),
                 std::string("The damage cannot be read: the point of its cut is not finite."));
    }
    void everyChangedByteIsRefused() {
        qInfo("seed %d", static_cast<int>(kBytesSeed));
        Random random(kBytesSeed);
        for (int round = 0; round < 20; ++round) {
            const std::string bytes = damageBytes(anyBits(random));
            for (std::size_t k = 0; k < bytes.size(); ++k) {
                std::string changed = bytes;
                changed[k] = static_cast<char>(changed[k] ^ static_cast<char>(1 + random.below(255)));
                QVERIFY2(!damageOfBytes(changed), QByteArray::number(static_cast<int>(k)));
                QVERIFY(!damageOfBytes(bytes.substr(0, k)));
            }
        }
    }
    /// Also where the checksum fits: only the bits, the bake and a finite cut may be anything.
    void changedBytesNeverGiveADamageThatIsWrittenOtherwise() {
        qInfo("seed %d", static_cast<int>(kBytesSeed));
        Random random(kBytesSeed);
        for (int round = 0; round < 5000; ++round) {
            std::string bytes = damageBytes(anyBits(random));
            const std::size_t place = random.below(bytes.size());
            bytes[place] = static_cast<char>(random.below(256));
            bytes = sealed(bytes);
            if (const Result<InstanceDamage> read = damageOfBytes(bytes)) QCOMPARE(damageBytes(*read), bytes);
        }
    }
    /// A bond's index has three bytes.
    void moreBondsThanAnIndexCountsAreRefused() {
        const InstanceDamage most{.kind = DamageKind::Bonds, .broken = std::vector<bool>(std::size_t{1} << 24)};
        std::string bytes = damageBytes(most);
        QVERIFY(damageOfBytes(bytes).hasValue());
        bytes[23] = 8;
        bytes.insert(bytes.size() - 12, 1, '\0');
        QCOMPARE(reasonIn(sealed(bytes)),
                 std::string("The damage cannot be read: it has 16777224 bonds, but 16777216 are the most."));
    }
    void theReasonIsNamed() {
        const std::string bytes = damageBytes({.bake = {1, 2}, .broken = {true, false, true}});
        QCOMPARE(bytes.size(), std::size_t{36});
        QCOMPARE(reasonIn("RDMG"), std::string("The damage cannot be read: it has 4 bytes only."));
        QCOMPARE(reasonIn(std::string(60, 'x')),
                 std::string("The damage cannot be read: it does not start with RDMG."));
        std::string newer = bytes, unknown = bytes, longer = bytes, beyond = bytes;
        newer[4] = 2;
        QCOMPARE(reasonIn(sealed(newer)), std::string("The damage is of version 2, but only version 1 can be read."));
        unknown[5] = 9;
        QCOMPARE(reasonIn(sealed(unknown)), std::string("The damage is of the unknown kind 9."));
        longer[23] = 9;
        QCOMPARE(reasonIn(sealed(longer)),
                 std::string("The damage cannot be read: of 9 fractures it must have 37 bytes, but it has 36."));
        beyond[27] = 8;
        QCOMPARE(reasonIn(sealed(beyond)),
                 std::string("The damage cannot be read: it has bits beyond its last fracture."));
    }
};

RUBBLE_TEST(DamageBytesTest)
#include "DamageBytesTest.moc"
