// Tests docs/formats/rubble_pack.hpp and pack_example.cpp.
#include "core/physics/world/World.h"
#include "core/play/scene/Projectile.h"
#include "docs/formats/rubble_pack.hpp"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/LayeredBox.h"
#include "tests/support/asset/Packs.h"
#include "tests/support/files/WrongValues.h"

#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>

using namespace rubble;

namespace {

std::string headerFault(std::string_view json) {
    rubble_pack::Pack pack;
    std::string fault;
    return rubble_pack::parse(json, pack, fault) ? "" : fault;
}

bool isSame(const rubble_pack::Vec3& read, const Vec3& ours) {
    return read.x == ours.x && read.y == ours.y && read.z == ours.z;
}

bool isSame(const rubble_pack::Hull& read, const PackHull& ours) {
    bool same = read.edges == ours.polytope.edges && read.faces == ours.polytope.faces && read.inset == ours.inset;
    for (std::size_t k = 0; same && k < ours.polytope.vertices.size(); ++k)
        same = isSame(read.vertices.at(k), ours.polytope.vertices[k]);
    for (std::size_t f = 0; same && f < ours.signedEdges.size(); ++f) {
        same = isSame(read.planes.at(f).normal, ours.polytope.planes[f].normal) &&
               read.planes[f].offset == ours.polytope.planes[f].offset;
        for (std::size_t k = 0; same && k < ours.signedEdges[f].size(); ++k)
            same = read.signedEdges.at(f).at(k).edge == ours.signedEdges[f][k].edge &&
                   read.signedEdges[f][k].sign == ours.signedEdges[f][k].sign;
    }
    return same;
}

bool isSame(const rubble_pack::Body& read, const PackBody& ours) {
    bool same = read.id == ours.id && read.name == ours.name && read.parent == ours.parent &&
                isSame(read.offset, ours.offset) && read.volume == ours.volume && read.mass == ours.mass &&
                read.gap == ours.gap && read.lostMass == ours.lostMass && read.level == ours.level &&
                read.childCount == ours.childCount && read.firstChild == ours.firstChild &&
                read.threshold == ours.threshold.value_or(0.0) && read.radius == ours.bounds->radius &&
                isSame(read.bounds.min, ours.bounds->min) && isSame(read.principal.moments, ours.principal->moments) &&
                read.principal.rotation.w == ours.principal->rotation.w &&
                read.principal.rotation.x == ours.principal->rotation.x &&
                isSame(read.centreOfMass, ours.centreOfMass) && read.neighbours.size() == ours.neighbours.size() &&
                read.hulls.size() == ours.hulls.size();
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            same = same && read.inertia[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] ==
                               ours.inertia[column][row];
    for (std::size_t k = 0; same && k < ours.neighbours.size(); ++k)
        same = read.neighbours[k].fragment == ours.neighbours[k].fragment &&
               read.neighbours[k].area == ours.neighbours[k].area;
    for (std::size_t k = 0; same && k < ours.hulls.size(); ++k) same = isSame(read.hulls[k], ours.hulls[k]);
    return same;
}

}  // namespace

/// Compares the reader in docs/formats/rubble_pack.hpp with core/io.
class PackHeaderTest : public QObject {
    Q_OBJECT

    QTemporaryDir m_folder;

    /// Runs the example program on a pack.
    QProcess* example(const std::string& json) {
        const QString path = m_folder.filePath("pack.json");
        std::ofstream(path.toStdString(), std::ios::binary) << json;
        auto* program = new QProcess(this);
        program->start(RUBBLE_PACK_EXAMPLE, {path});
        program->waitForFinished(kPatience);
        return program;
    }

private slots:
    void headerAndLibraryReadTheSame() {
        const std::string json = packOf(twoLevelRing());
        const Pack ours = *readPack(json);
        rubble_pack::Pack pack;
        std::string fault;
        QVERIFY2(rubble_pack::parse(json, pack, fault), fault.c_str());
        QCOMPARE(pack.asset, ours.asset);
        QCOMPARE(pack.name, ours.names.name);
        QCOMPARE(pack.base, ours.names.base);
        QCOMPARE(pack.folder, ours.names.folder);
        QCOMPARE(pack.physicsHash, ours.physicsHash);
        QCOMPARE(pack.inset, ours.inset);
        QCOMPARE(pack.hash, ours.hash);
        QCOMPARE(pack.threshold, ours.threshold);
        QCOMPARE(pack.material.name, ours.own().name);
        QCOMPARE(pack.material.density, ours.own().density);
        QCOMPARE(pack.material.friction, ours.own().friction);
        QCOMPARE(pack.material.outside[0], ours.own().outside.red);
        QCOMPARE(pack.meshes.size(), std::size_t{2});
        QCOMPARE(pack.meshes[1].file, std::string("box0.obj"));
        QVERIFY(pack.meshes[1].bodies == rubble_pack::MeshBodies::Fragment);
        QCOMPARE(pack.meshes[1].fragment, 0u);
        QVERIFY(isSame(pack.whole, ours.whole));
        QCOMPARE(pack.fragments.size(), ours.fragments.size());
        for (std::size_t k = 0; k < ours.fragments.size(); ++k) QVERIFY(isSame(pack.fragments[k], ours.fragments[k]));
        QCOMPARE(pack.piecesOf(rubble_pack::kNone).size() + pack.piecesOf(0).size() > 5, true);
    }
    /// Halves of half the volume.
    void thresholdsAreSetOrFollowFromTheVolume() {
        Asset asset = layeredBox();
        asset.threshold = 80.0;
        asset.fragmentThresholds = {{"5.1", 3.25}};
        rubble_pack::Pack pack;
        std::string fault;
        QVERIFY2(rubble_pack::parse(packOf(asset), pack, fault), fault.c_str());
        QCOMPARE(pack.thresholdOf(rubble_pack::kNone), 80.0);
        QVERIFY(std::abs(pack.thresholdOf(0) - 80.0 * std::pow(0.5, 2.0 / 3.0)) < 1e-12);
        QCOMPARE(pack.thresholdOf(1), 3.25);
    }
    /// Turning a point and converting it is converting both.
    /// As those of a cube that falls on the ground in a world.
    void impactsAreThoseOfAWorld() {
        rubble_pack::Pack pack;
        for (const double speed : {0.3, 0.5, 0.6, 0.9, 1.1, 12.0}) {
            for (const double restitution : {0.0, 0.1, 0.4}) {
                World world({.gravity = Vec3(0.0)});
                const Polytope cube = projectileHull({.size = Vec3(1.0)});
                const std::shared_ptr<const Shape> shape = makeShape({&cube, 1}).value();
                const BodyId falling = world
                                           .addBody({.shape = shape,
                                                     .pose = {.position = {0.0, 1.0, 0.0}},
                                                     .velocity = {0.0, -speed, 0.0},
                                                     .density = 1000.0,
                                                     .restitution = 0.2})
                                           .value();
                QVERIFY(world.addBody({.shape = shape, .kind = BodyKind::Static, .restitution = restitution}));
                world.collide(1e-4);
                double impulse = 0.0;
                for (const Impact& impact : world.impacts())
                    if (impact.first == falling || impact.second == falling) impulse = impact.impulse();
                pack.material.restitution = 0.2;
                QVERIFY2(isNear(pack.impactOf(speed, 1000.0, restitution), impulse, 1e-5), QByteArray::number(speed));
            }
        }
    }
    void conversionsKeepRotations() {
        using rubble_pack::Quaternion;
        const auto rotated = [](const Quaternion& q, const rubble_pack::Vec3& v) {
            const Vec3 turned = Quat(q.w, q.x, q.y, q.z) * Vec3(v.x, v.y, v.z);
            return rubble_pack::Vec3{turned.x, turned.y, turned.z};
        };
        const auto isNear = [](const rubble_pack::Vec3& a, const rubble_pack::Vec3& b) {
            return glm::distance(Vec3(a.x, a.y, a.z), Vec3(b.x, b.y, b.z)) < 1e-12;
        };
        const Quat unit = glm::normalize(Quat(0.4, 0.1, -0.7, 0.5));
        const Quaternion q{unit.x, unit.y, unit.z, unit.w};
        const rubble_pack::Vec3 v{0.3, -1.25, 2.0};
        QVERIFY(isNear(rubble_pack::toUnity(rotated(q, v)), rotated(rubble_pack::toUnity(q), rubble_pack::toUnity(v))));
        QVERIFY(
            isNear(rubble_pack::toUnreal(rotated(q, v)), rotated(rubble_pack::toUnreal(q), rubble_pack::toUnreal(v))));
        QVERIFY(isNear(rubble_pack::toUnreal(v), {30.0, 200.0, -125.0}));
        // The velocity of a point of a rotating body, w x r.
        const rubble_pack::Vec3 w{0.5, -2.0, 0.75};
        const auto cross = [](const rubble_pack::Vec3& a, const rubble_pack::Vec3& b) {
            const Vec3 product = glm::cross(Vec3(a.x, a.y, a.z), Vec3(b.x, b.y, b.z));
            return rubble_pack::Vec3{product.x, product.y, product.z};
        };
        QVERIFY(
            isNear(rubble_pack::toUnity(cross(w, v)), cross(rubble_pack::angularToUnity(w), rubble_pack::toUnity(v))));
        QVERIFY(isNear(rubble_pack::toUnreal(cross(w, v)),
                       cross(rubble_pack::angularToUnreal(w), rubble_pack::toUnreal(v))));
    }
    /// Packs without edges, signed edges and planes, and of version 1, give the same bodies.
    void topologyAndEarlierVersionsAreCompleted() {
        rubble_pack::Pack full, loops, earlier;
        std::string fault;
        QVERIFY2(rubble_pack::parse(packOf(twoLevelRing()), full, fault), fault.c_str());
        const std::string text = packOf(twoLevelRing(), heavyBrick(), {}, PackTopology::Loops);
        QVERIFY(text.find("\"planes\"") == std::string::npos);
        QVERIFY2(rubble_pack::parse(text, loops, fault), fault.c_str());
        QVERIFY(!verifyPack(readPack(text).value()));
        for (std::size_t k = 0; k < full.fragments.size(); ++k) {
            const rubble_pack::Hull &one = full.fragments[k].hulls[0], &other = loops.fragments[k].hulls[0];
            QCOMPARE(other.edges.size(), one.edges.size());
            for (std::size_t f = 0; f < one.planes.size(); ++f)
                QVERIFY(std::abs(one.planes[f].offset - other.planes[f].offset) < 1e-12);
        }
        QVERIFY2(rubble_pack::load(RUBBLE_SOURCE_DIR "/tests/corpus/Pack/halves.json", earlier, fault), fault.c_str());
        QCOMPARE(earlier.version, 1u);
        QCOMPARE(earlier.fragmentsOf(rubble_pack::kNone).size(), std::size_t{2});
        QVERIFY(earlier.whole.principal.moments.x >= earlier.whole.principal.moments.y);
        QVERIFY(earlier.whole.radius > 0.0);
    }
    void contactsHaveTheirNormalsOnBothSides() {
        rubble_pack::Pack pack;
        std::string fault;
        QVERIFY2(rubble_pack::parse(packOf(twoLevelRing()), pack, fault), fault.c_str());
        std::size_t contacts = 0;
        for (std::uint32_t k = 0; k < pack.fragments.size(); ++k) {
            for (const rubble_pack::Neighbour& neighbour : pack.fragments[k].neighbours) {
                for (const rubble_pack::Neighbour& back : pack.fragments[neighbour.fragment].neighbours) {
                    if (back.fragment != k) continue;
                    QCOMPARE(back.normal.x, -neighbour.normal.x);
                    QCOMPARE(back.centroid.y, neighbour.centroid.y);
                    ++contacts;
                }
            }
        }
        QVERIFY(contacts > 10);
    }
    void meshesOfBodiesAreFound() {
        rubble_pack::Pack pack;
        pack.fragments.resize(3);
        pack.fragments[0].childCount = 2;
        pack.fragments[1].level = pack.fragments[2].level = 1;
        using rubble_pack::MeshBodies;
        pack.meshes = {{"a-intact.glb", MeshBodies::Whole, rubble_pack::kNone, {}, rubble_pack::kNone},
                       {"a-fragments.obj", MeshBodies::Fragments, rubble_pack::kNone, {}, rubble_pack::kNone},
                       {"a-fragments.glb", MeshBodies::Fragments, rubble_pack::kNone, {}, rubble_pack::kNone},
                       {"a-fragments-level-0.glb", MeshBodies::Fragments, rubble_pack::kNone, {}, 0}};
        QCOMPARE(pack.meshOf(rubble_pack::kNone, ".glb")->file, std::string("a-intact.glb"));
        QCOMPARE(pack.meshOf(0, ".glb")->file, std::string("a-fragments-level-0.glb"));
        QCOMPARE(pack.meshOf(2, ".glb")->file, std::string("a-fragments.glb"));
        QCOMPARE(pack.meshOf(2, ".obj")->file, std::string("a-fragments.obj"));
        QVERIFY(pack.meshOf(0, ".obj") == nullptr);
    }
    void allEscapesAreRead() {
        nlohmann::json json = nlohmann::json::parse(packOf(twoLevelRing()));
        const std::string name = "a\"\\/\b\f\n\r\t\x01\xc3\xa9\xe2\x82\xac\xf0\x9f\xa7\xb1";
        json["asset"]["name"] = name;
        for (const bool isAscii : {false, true}) {  // as UTF-8, and as \u with surrogates
            rubble_pack::Pack pack;
            std::string fault;
            QVERIFY2(rubble_pack::parse(json.dump(1, ' ', isAscii), pack, fault), fault.c_str());
            QCOMPARE(pack.name, name);
        }
    }
    /// As the JSON reader of the program: what is too small for a double is 0.
    void smallNumbersAreRead() {
        const std::string json = packOf(boxAsset(3, 4, PlacedSeeds{}));
        const std::string zeros(400, '0');
        const std::pair<std::string, double> numbers[] = {{"1e-999", 0.0},
                                                          {"2e-324", 0.0},
                                                          {"5e-324", 5e-324},
                                                          {"-1.5E-400", 0.0},
                                                          {"0." + zeros + "1", 0.0},
                                                          {"0." + zeros + "1e401", 1.0},
                                                          {"1e-9999999999999999999", 0.0},
                                                          {"0e9999999999999999999", 0.0}};
        for (const auto& [digits, value] : numbers) {
            std::string changed = json;
            changed.replace(changed.find("\"offset\":[0.5"), 13, "\"offset\":[" + digits);
            rubble_pack::Pack pack;
            std::string fault;
            QVERIFY2(rubble_pack::parse(changed, pack, fault), (digits + ": " + fault).c_str());
            QCOMPARE(pack.whole.offset.x, value);
        }
    }
    void everyWrongTypeIsReportedWithItsPath() {
        const Asset halves = boxAsset(3, 4, PlacedSeeds{{{0, {0.25, 0.25}}, {1, {0.75, 0.75}}}});
        const auto isLink = [](const std::string& place, const nlohmann::json& value) {
            if (place == "checksum" || place == "generator") return true;  // not read
            if (value.is_discarded()) {
                const auto isKey = [&](const char* key) { return place.ends_with(key); };
                return place != "collision.inset" &&
                       (isKey("bonding") || isKey(".inset") || isKey(".firstChild") || isKey(".level") ||
                        isKey(".opacity") || isKey(".centroid") || isKey(".normal") || isKey(".threshold"));
            }
            return value.is_null() &&
                   (place.ends_with(".parent") || place.starts_with("meshes[") || place.ends_with(".capacity"));
        };
        Asset bonded = halves;
        bonded.breakAs = BreakAs::Bonded;
        bonded.bonding.strokes = {{.points = {{0.1, 0.1}}}};
        std::vector<test::JsonMutation> mutations = test::mutationsOf(nlohmann::json::parse(packOf(halves)), isLink);
        for (test::JsonMutation& mutation : test::mutationsOf(nlohmann::json::parse(packOf(bonded)), isLink))
            mutations.push_back(std::move(mutation));
        for (const test::JsonMutation& mutation : mutations) {
            if (mutation.name.ends_with("one more key")) continue;  // unknown keys are ignored
            const std::string fault = headerFault(mutation.document.dump());
            const std::string place = fault.substr(0, fault.find(": "));  // or the path of its container
            QVERIFY2(!fault.empty() && mutation.place.starts_with(place), (mutation.name + " gives: " + fault).c_str());
        }
    }
    void indicesOutOfRangeAreRejected_data() {
        test::addWrongValueColumns();
        test::addWrongValue("version: this header reads versions up to 2.", "/version", "3");
        test::addWrongValue("units.length: \"cm\" is not known to this reader.", "/units/length", "\"cm\"");
        test::addWrongValue("meshes[1].fragment: expected a whole number below 20.", "/meshes/1/fragment", "20");
        test::addWrongValue("fragments[0].parent: expected a whole number below 0.", "/fragments/0/parent", "0");
        test::addWrongValue("fragments[9].parent: expected a whole number below 9.", "/fragments/9/parent", "1.5");
        test::addWrongValue("fragments[0].neighbours[0].fragment: expected a whole number below 20.",
                            "/fragments/0/neighbours/0/fragment", "20");
        test::addWrongValue("fragments[0].hulls[0].edges[0][1]: expected a whole number below 10.",
                            "/fragments/0/hulls/0/edges/0/1", "10");
        test::addWrongValue("fragments[0].hulls[0].faces[1][0]: expected a whole number below 10.",
                            "/fragments/0/hulls/0/faces/1/0", "-1");
        test::addWrongValue("fragments[0].hulls[0].signedEdges[1][0]: expected an edge that is there.",
                            "/fragments/0/hulls/0/signedEdges/1/0/0", "99");
        test::addWrongValue("fragments[0].hulls[0].signedEdges[1][0]: expected an edge, then 1 or -1.",
                            "/fragments/0/hulls/0/signedEdges/1/0/1", "0");
        test::addWrongValue("fragments[0].hulls[0]: faces, signed edges and planes do not agree.",
                            "/fragments/0/hulls/0/planes", "[]");
        test::addWrongValue("fragments[0]: expected at least one hull.", "/fragments/0/hulls", "[]");
    }
    void indicesOutOfRangeAreRejected() {
        const nlohmann::json json = nlohmann::json::parse(packOf(twoLevelRing()));
        QCOMPARE(headerFault(test::withWrongValue(json)), std::string(QTest::currentDataTag()));
    }
    /// Bonds are between children, which engines walk through: neither may leave the pack or end where it began.
    void childrenAreTheFragmentsOfTheirParents() {
        const nlohmann::json json = nlohmann::json::parse(packOf(bondedRing()));
        QVERIFY(headerFault(json.dump()).empty());
        const std::string last = std::to_string(json["fragments"].size() - 1);
        const std::pair<std::string, const char*> changes[] = {{"/whole/childCount", "0"},
                                                               {"/whole/childCount", "2"},
                                                               {"/whole/firstChild", "1"},
                                                               {"/fragments/0/childCount", "0"},
                                                               {"/fragments/" + last + "/childCount", "1"},
                                                               {"/fragments/" + last + "/parent", "null"}};
        for (const auto& [pointer, value] : changes) {
            QCOMPARE(headerFault(test::changedText(json, pointer, value)),
                     std::string("The document: the fragments of a body are not consecutive."));
        }
    }
    void invalidJsonIsRejected() {
        const std::string json = packOf(boxAsset(3, 4, PlacedSeeds{}));
        for (std::size_t size = 0; size + 2 < json.size(); ++size)
            QVERIFY(headerFault(std::string_view(json).substr(0, size)).starts_with("The text is not JSON at byte "));
        for (const char* text : {"", "{\"a\" 1}", "[1,]", "{,}", "[01]", "[1.]", "[1e]", "[+1]", "[\"\\x\"]",
                                 "[\"\\ud800\"]", "[\"\n\"]", "nul", "[1] 2", "[1e999]", "[\"\\u12\"]"})
            QVERIFY2(headerFault(text).starts_with("The text is not JSON at byte "), text);
        QVERIFY(headerFault(std::string(100000, '[')).ends_with("expected fewer levels."));
    }
    /// Of a text with numbers in place of fragments, which take a hundred times their size.
    void wrongElementsTakeLittleMemory() {
#if defined(__SANITIZE_ADDRESS__)
        QSKIP("The sanitizer reserves terabytes of address space.");
#endif
        constexpr std::size_t kElements = 3000000;
        constexpr rlim_t kMemory = rlim_t{1} << 30;  // bytes; the nodes of the text take a quarter
        std::string json = packOf(boxAsset(3, 4, PlacedSeeds{})), numbers;
        for (std::size_t k = 0; k < kElements; ++k) numbers += "0,";
        json.insert(json.find('[', json.find("\"fragments\":")) + 1, numbers);
        const pid_t child = ::fork();
        if (child == 0) {
            std::size_t pages = 0;
            std::ifstream("/proc/self/statm") >> pages;
            const rlim_t limit = pages * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) + kMemory;
            const rlimit memory{limit, limit};
            ::setrlimit(RLIMIT_AS, &memory);
            ::_exit(headerFault(json) == "fragments[0]: expected an object." ? 0 : 1);
        }
        int status = 0;
        QCOMPARE(::waitpid(child, &status, 0), child);
        QCOMPARE(status, 0);
    }
    void errorDoesNotChangeThePack() {
        rubble_pack::Pack pack;
        pack.name = "kept";
        std::string fault;
        QVERIFY(!rubble_pack::parse("{}", pack, fault));
        QCOMPARE(pack.name, std::string("kept"));
        QVERIFY(!rubble_pack::load("none/pack.json", pack, fault));
        QCOMPARE(fault, std::string("Cannot read \"none/pack.json\"."));
    }
    void examplePrintsThePack() {
        QProcess* program = example(packOf(boxAsset(3, 4, PlacedSeeds{{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}})));
        QCOMPARE(program->exitCode(), 0);
        QCOMPARE(program->readAllStandardOutput(),
                 QByteArray("box, made of brick, breaks at 100 N·s\n"
                            "box_whole: 900 kg at (0.5, 0.5, 0), hulls 1, vertices 8, neighbours 0\n"
                            "  box_f4_0: 450 kg at (0.25, 0.5, 0), hulls 1, vertices 8, neighbours 1\n"
                            "  box_f4_1: 450 kg at (0.75, 0.5, 0), hulls 1, vertices 8, neighbours 1\n"));
    }
    void examplePrintsErrors() {
        QProcess* program = example("{\"format\": \"rubble-project\"}");
        QCOMPARE(program->exitCode(), 1);
        QVERIFY(program->readAllStandardError().endsWith(
            "pack.json\": format: \"rubble-project\" is not known to this reader.\n"));
    }
};

RUBBLE_TEST_WITH(PackHeaderTest, QCoreApplication)
#include "PackHeaderTest.moc"
