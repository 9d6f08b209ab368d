// Tests core/io/pack/PackBinary.cpp, core/io/pack/PackBinaryReading.cpp, core/io/pack/PackHeaderJson.cpp and the
// binary part of docs/formats/rubble_pack.hpp.
#include "core/base/Random.h"
#include "core/io/pack/PackBinary.h"
#include "core/io/pack/PackBinaryFormat.h"
#include "core/io/pack/PackFile.h"
#include "docs/formats/rubble_pack.hpp"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Packs.h"
#include "tests/support/asset/RandomAssets.h"
#include "tests/support/fracture/PatternSamples.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <span>

using namespace rubble;

namespace {

std::string binaryOf(const Asset& asset, int threads = 1) {
    const Bake baked = bake(asset).value();
    TaskContext task;
    task.threads = threads;
    return packBinary(PackBuilder({baked, asset, heavyBrick(), packNames(asset), {}}), packMeshes(), task).value();
}

bool isNear(const Vec3& a, const rubble_pack::Vec3& b) {
    return glm::distance(a, Vec3(b.x, b.y, b.z)) <= 1e-6 * std::max(1.0, glm::length(a));
}

/// The bytes with a checksum that fits.
std::string withFittingChecksum(std::string bytes) {
    bytes.resize(bytes.size() - 8);
    const std::uint64_t checksum = contentHash(bytes).low;
    bytes.append(reinterpret_cast<const char*>(&checksum), sizeof(checksum));
    return bytes;
}

/// What the header says of a file after a change of its records of a kind; nothing if it opens it.
template <class Record>
std::string faultAfter(std::string bytes, BinarySection kind, const std::function<void(std::span<Record>)>& change) {
    BinarySectionEntry entry;
    std::memcpy(&entry, bytes.data() + sizeof(BinaryHead) + (static_cast<std::size_t>(kind) - 1) * sizeof(entry),
                sizeof(entry));
    std::vector<Record> records(entry.count);
    std::memcpy(records.data(), bytes.data() + entry.offset, entry.count * sizeof(Record));
    change(records);
    std::memcpy(bytes.data() + entry.offset, records.data(), entry.count * sizeof(Record));
    rubble_pack::BinaryPack pack;
    std::string fault;
    return rubble_pack::openBinary(withFittingChecksum(bytes), pack, fault) ? "" : fault;
}

}  // namespace

class PackBinaryTest : public QObject {
    Q_OBJECT
private slots:
    void itFollowsFromTheJson() {
        for (const Asset& asset : {twoLevelRing(), bondedRing(), boxAsset(3, 4, PlacedSeeds{})}) {
            const std::string binary = binaryOf(asset);
            QVERIFY(packBinary(readPack(packOf(asset)).value()).value() == binary);
            QVERIFY(packBinary(readPackBinary(binary).value()).value().size() == binary.size());
        }
    }
    void threadsDoNotChangeTheBytes() {
        const Asset asset = boxAsset(3, 4, UniformScatter{.count = 700});
        QVERIFY(binaryOf(asset, 4) == binaryOf(asset, 1));
    }
    void whatIsReadIsThePackInFloats() {
        const Pack pack = readPack(packOf(bondedRing())).value();
        const Pack read = readPackBinary(binaryOf(bondedRing())).value();
        QVERIFY(read.names == pack.names && read.hash == pack.hash && read.materials == pack.materials);
        QCOMPARE(read.fragments.size(), pack.fragments.size());
        for (std::size_t k = 0; k < pack.fragments.size(); ++k) {
            const PackBody &one = pack.fragments[k], &other = read.fragments[k];
            QVERIFY(one.id == other.id && one.name == other.name && one.offset == other.offset);
            QVERIFY(one.mass == other.mass && one.volume == other.volume && one.threshold == other.threshold);
            QVERIFY(one.parent == other.parent && one.childCount == other.childCount);
            QCOMPARE(one.neighbours.size(), other.neighbours.size());
            for (int axis = 0; axis < 3; ++axis)
                QVERIFY(std::abs(one.inertia[axis][axis] - other.inertia[axis][axis]) < 1e-5 * one.inertia[2][2]);
            for (std::size_t v = 0; v < one.hulls[0].polytope.vertices.size(); ++v)
                QVERIFY(glm::distance(one.hulls[0].polytope.vertices[v], other.hulls[0].polytope.vertices[v]) < 1e-6);
        }
        QCOMPARE(read.bonding->fractures.size(), pack.bonding->fractures.size());
        for (std::size_t k = 0; k < pack.bonding->fractures.size(); ++k)
            QCOMPARE(read.bonding->fractures[k].bonds.size(), pack.bonding->fractures[k].bonds.size());
    }
    void headerReadsItLikeTheJson() {
        for (std::uint64_t seed = 0; seed < 30; ++seed) {
            Random random(seed);
            Project project = test::randomAsset(random, static_cast<int>(seed));
            Asset asset = project.assets[0];
            asset.pattern = test::patternOf(project, {UniformScatter{.count = 20}});
            if (seed % 2 == 0) asset.breakAs = BreakAs::Bonded;
            rubble_pack::Pack text, binary;
            std::string fault;
            QVERIFY2(rubble_pack::parse(packOf(asset), text, fault), fault.c_str());
            QVERIFY2(rubble_pack::parseBinary(binaryOf(asset), binary, fault), fault.c_str());
            QCOMPARE(binary.name, text.name);
            QCOMPARE(binary.fragments.size(), text.fragments.size());
            QCOMPARE(binary.bonding.has_value(), text.bonding.has_value());
            for (std::size_t k = 0; k < text.fragments.size(); ++k) {
                const rubble_pack::Body &one = text.fragments[k], &other = binary.fragments[k];
                QVERIFY(one.id == other.id && one.mass == other.mass && one.level == other.level);
                QVERIFY(isNear(Vec3(one.offset.x, one.offset.y, one.offset.z), other.offset));
                QCOMPARE(one.neighbours.size(), other.neighbours.size());
                for (std::size_t n = 0; n < one.neighbours.size(); ++n) {
                    const rubble_pack::Vec3& normal = one.neighbours[n].normal;
                    QCOMPARE(one.neighbours[n].fragment, other.neighbours[n].fragment);
                    QVERIFY(isNear(Vec3(normal.x, normal.y, normal.z), other.neighbours[n].normal));
                }
                QCOMPARE(one.hulls[0].faces, other.hulls[0].faces);
                QCOMPARE(one.hulls[0].edges.size(), other.hulls[0].edges.size());
            }
        }
    }
    void recordsCanBeReadWithoutAPack() {
        const std::string bytes = binaryOf(twoLevelRing());
        rubble_pack::BinaryPack pack;
        std::string fault;
        QVERIFY2(rubble_pack::openBinary(bytes, pack, fault), fault.c_str());
        QCOMPARE(std::string(pack.text(pack.whole().name)), std::string("box_whole"));
        QCOMPARE(pack.fragmentCount(), std::uint32_t{20});
        QCOMPARE(pack.fragment(0).parent, rubble_pack::kNone);
        QCOMPARE((pack.bodies.data() - bytes.data()) % 16, 0);
    }
    void everyChangedByteIsFound() {
        const std::string bytes = binaryOf(boxAsset(3, 4, UniformScatter{.count = 3}));
        for (std::size_t at = 0; at < bytes.size(); ++at) {
            std::string changed = bytes;
            changed[at] = static_cast<char>(changed[at] ^ 0x10);
            rubble_pack::BinaryPack pack;
            std::string fault;
            QVERIFY2(!readPackBinary(changed), std::to_string(at).c_str());
            QVERIFY2(!rubble_pack::openBinary(changed, pack, fault), std::to_string(at).c_str());
        }
        for (std::size_t size = 0; size < bytes.size(); ++size)
            QVERIFY(!readPackBinary(std::string_view(bytes).substr(0, size)));
    }
    void childrenAreTheFragmentsOfTheirParents() {
        const std::string bytes = binaryOf(bondedRing());
        const auto faultOf = [&](const std::function<void(std::span<BinaryBody>)>& change) {
            return faultAfter<BinaryBody>(bytes, BinarySection::Bodies, change);
        };
        const std::string fault = "The fragments of a body are not consecutive.";
        QCOMPARE(faultOf([](std::span<BinaryBody>) {}), std::string());
        QCOMPARE(faultOf([](std::span<BinaryBody> bodies) { --bodies[0].childCount; }), fault);
        QCOMPARE(faultOf([](std::span<BinaryBody> bodies) { ++bodies[0].firstChild; }), fault);
        QCOMPARE(faultOf([](std::span<BinaryBody> bodies) { bodies.back().childCount = 1; }), fault);
        QCOMPARE(faultOf([](std::span<BinaryBody> bodies) { bodies.back().parent = kNone; }), fault);
        const auto joinLevels = [](std::span<BinaryContact> contacts) { contacts[0].second = contacts.back().second; };
        QCOMPARE(faultAfter<BinaryContact>(bytes, BinarySection::Contacts, joinLevels),
                 std::string("The fragments of a contact are wrong."));
    }
    /// Else some kilobytes could make a pack of many gigabytes.
    void nothingIsShared() {
        const std::string bytes = binaryOf(bondedRing());
        const auto shareHulls = [](std::span<BinaryBody> bodies) { bodies.back().firstHull = 0; };
        const auto shareMoreHulls = [](std::span<BinaryBody> bodies) {
            bodies.back().hullCount += bodies.back().firstHull;
            bodies.back().firstHull = 0;
        };
        QCOMPARE(faultAfter<BinaryBody>(bytes, BinarySection::Bodies, shareHulls), std::string());
        QCOMPARE(faultAfter<BinaryBody>(bytes, BinarySection::Bodies, shareMoreHulls),
                 std::string("Two bodies have the same hull."));
        const auto joinTexts = [](std::span<char> texts) {
            std::ranges::replace(texts.first(texts.size() - 1), '\0', '-');
        };
        QCOMPARE(faultAfter<char>(bytes, BinarySection::Texts, joinTexts),
                 std::string("Two bodies have the same text."));
        const auto shareVertices = [](std::span<BinaryHull> hulls) {
            hulls.back().vertexCount += hulls.back().firstVertex;
            hulls.back().firstVertex = 0;
        };
        QCOMPARE(faultAfter<BinaryHull>(bytes, BinarySection::Hulls, shareVertices),
                 std::string("Two hulls have the same vertex."));
        const auto shareFace = [](std::span<BinaryHull> hulls) { ++hulls[0].faceCount; };  // the first of the next
        QCOMPARE(faultAfter<BinaryHull>(bytes, BinarySection::Hulls, shareFace),
                 std::string("Two hulls have the same face."));
    }
    /// With checksums that fit: what is accepted has all of its indices in range.
    void damagedFilesAreReadOrRefused() {
        constexpr std::uint64_t kSeed = 20261127;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        const std::string bytes = binaryOf(bondedRing());
        Random random(kSeed);
        std::size_t refused = 0;
        const int rounds = qEnvironmentVariableIsSet("RUBBLE_LONG") ? 100000 : 3000;
        for (int round = 0; round < rounds; ++round) {
            std::string changed = bytes;
            for (std::size_t k = 1 + random.below(4); k-- > 0;) {
                const std::size_t at = random.below(changed.size());
                if (random.below(3) == 0) changed[at] = static_cast<char>(random.next());
                if (random.below(3) == 0 && at + 4 <= changed.size()) {
                    const std::uint32_t word =
                        random.below(2) == 0 ? 0xffffffffu : static_cast<std::uint32_t>(random.below(99));
                    std::memcpy(changed.data() + at / 4 * 4, &word, sizeof(word));
                }
            }
            if (random.below(20) == 0) changed.resize(random.below(changed.size()) + 8);
            changed = withFittingChecksum(changed);
            rubble_pack::Pack pack;
            std::string fault;
            const bool isRead = rubble_pack::parseBinary(changed, pack, fault);
            QVERIFY(isRead || !fault.empty());
            const Result<Pack> ours = readPackBinary(changed);
            if (ours) static_cast<void>(verifyPack(*ours));
            refused += !isRead;
        }
        QVERIFY(refused > 100);
    }
};

RUBBLE_TEST(PackBinaryTest)
#include "PackBinaryTest.moc"
