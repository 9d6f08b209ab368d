// Tests core/io/pack/VerifyPack.cpp, core/io/pack/VerifyPackContacts.cpp, core/io/pack/VerifyPackBonding.cpp,
// core/io/pack/ConvexOverlap.cpp and core/io/pack/PackChecksum.cpp: packs in which one value is wrong.
#include "core/base/Random.h"
#include "core/io/system/AtomicFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Packs.h"
#include "tests/support/asset/RandomAssets.h"
#include "tests/support/files/JsonMutations.h"
#include "tests/support/fracture/PatternSamples.h"

#include <QTest>

#include <map>
#include <set>

using namespace rubble;

namespace {

using Json = nlohmann::json;

/// What may be different without contradicting the rest of pack.json. Only the checksum protects it.
const std::set<std::string> kFree{"asset.name",
                                  "asset.base",
                                  "asset.variant",
                                  "asset.folder",
                                  "generator",
                                  "hash",
                                  "physicsHash",
                                  "break.as",
                                  "break.rule",
                                  "break.leastSpeed",
                                  "break.restitutionSpeed",
                                  "collision.inset",
                                  "threshold",
                                  "materials.name",
                                  "materials.friction",
                                  "materials.restitution",
                                  "materials.outside",
                                  "materials.inside",
                                  "materials.opacity",
                                  "surfaces.name",
                                  "surfaces.side",
                                  "surfaces.colour",
                                  "surfaces.opacity",
                                  "surfaces.roughness",
                                  "meshes.file",
                                  "meshes.bodies",
                                  "meshes.fragment",
                                  "meshes.place",
                                  "meshes",
                                  "meshes.level",
                                  "whole.bounds.min",
                                  "whole.bounds.max",
                                  "whole.bounds.radius",
                                  "whole.bounds.thinnest",
                                  "fragments.bounds.min",
                                  "fragments.bounds.max",
                                  "fragments.bounds.radius",
                                  "fragments.bounds.thinnest",
                                  "fragments.threshold",
                                  "fragments.neighbours.centroid",
                                  "fragments.neighbours.normal",
                                  "whole.name",
                                  "fragments.name",
                                  "fragments.id",
                                  "bonding.falloffRadius",
                                  "bonding.falloff",
                                  "bonding.damageFrom",
                                  "bonding.span",
                                  "bonding.collapseDelay",
                                  "bonding.minimumIsland",
                                  "bonding.bake",
                                  "bonding.fractures.bonds.centroid",
                                  "bonding.fractures.bonds.normal",
                                  "bonding.fractures.bonds.capacity",
                                  "bonding.fractures.bonds.clusterLevel",
                                  "bonding.anchored"};
/// Beside a gap, only bounds of contact areas are known.
const std::set<std::string> kFreeBesideGaps{"fragments.neighbours.area"};

/// A path without indices: "fragments.hulls.vertices".
std::string kindOf(const Json::json_pointer& place) {
    std::string kind;
    for (const QByteArray& step : QByteArray::fromStdString(place.to_string()).split('/')) {
        bool isIndex = false;
        step.toUInt(&isIndex);
        if (!isIndex && !step.isEmpty()) kind += (kind.empty() ? "" : ".") + step.toStdString();
    }
    return kind;
}

/// The packs that are changed: with several levels, bonded, with concave fragments, with mortar, and with a gap.
std::vector<std::string> soundPacks() {
    Asset gap = twoLevelRing();
    gap.shaping.gap = 0.004;
    Asset mortar = boxAsset(3, 4, BrickBond{.length = 0.3, .height = 0.2});
    mortar.levels = {{.pattern = {{{.id = 5, .randomSeed = 2, .parameters = UniformScatter{.count = 3}}}}}};
    return {packOf(twoLevelRing()), packOf(bondedRing()), packOf(boxAsset(3, 4, UniformScatter{.count = 24})),
            packOf(mortar), packOf(gap)};
}

std::optional<std::string> faultOf(const std::string& text) {
    const Result<Pack> pack = readPack(text);
    if (!pack) return pack.error().message;
    if (std::optional<std::string> fault = verifyPack(*pack)) return fault;
    return verifyPackText(text, *pack);
}

/// Another value, by so much that an engine would notice it.
Json changed(const Json& value, Random& random) {
    const std::array factors{1.001, 0.5, 2.0, -1.0, 0.0, 1e9, 1e-9};
    if (value.is_number_integer()) return value.get<std::int64_t>() + (random.below(2) == 0 ? 1 : -1);
    if (value.is_string()) {
        std::string text = value.get<std::string>();
        if (text.empty()) return "x";
        char& letter = text[random.below(text.size())];
        letter = letter == '7' ? '8' : '7';
        return text;
    }
    if (value.is_null()) return 0;
    const double number = value.get<double>();
    if (std::abs(number) < 1e-3) return number + 0.01;
    return number * factors[random.below(factors.size())];
}

/// The positions of all values that are no containers.
std::vector<Json::json_pointer> leavesOf(const Json& document) {
    std::vector<Json::json_pointer> leaves;
    test::mutation::forEachPlace(document, Json::json_pointer(), [&](const Json& value, const auto& at) {
        if (!value.is_structured()) leaves.push_back(at);
    });
    return leaves;
}

/// Leaves by kind, so that each kind is changed as often as any other.
std::vector<std::vector<Json::json_pointer>> leavesByKind(const Json& document) {
    std::map<std::string, std::vector<Json::json_pointer>> kinds;
    for (const Json::json_pointer& leaf : leavesOf(document)) kinds[kindOf(leaf)].push_back(leaf);
    std::vector<std::vector<Json::json_pointer>> lists;
    for (auto& [kind, leaves] : kinds) lists.push_back(std::move(leaves));
    return lists;
}

}  // namespace

class PackMutationTest : public QObject {
    Q_OBJECT

private slots:
    void soundPacksPass() {
        for (const std::string& text : soundPacks()) {
            const std::optional<std::string> fault = faultOf(text);
            QVERIFY2(!fault, fault.value_or("").c_str());
        }
    }
    /// Patterns of all kinds, in outlines of all kinds, with gaps and small fragments merged, on two levels.
    void randomPacksPass() {
        constexpr std::uint64_t kSeed = 20261125;
        qInfo("seed %llu", static_cast<unsigned long long>(kSeed));
        Random random(kSeed);
        const std::vector<LayerParameters> samples = patternSamples();
        for (int round = 0; round < 120; ++round) {
            Project project = test::randomAsset(random, round);
            Asset& asset = project.assets[0];
            std::vector<LayerParameters> layers{
                UniformScatter{.count = 1 + static_cast<std::uint32_t>(random.below(30))}};
            if (round % 3 != 0) layers.push_back(samples[random.below(samples.size())]);
            asset.pattern = test::patternOf(project, layers);
            if (round % 4 == 1) asset.levels = {{.pattern = test::patternOf(project, {UniformScatter{.count = 4}})}};
            if (round % 2 == 0) asset.shaping.gap = random.between(1e-4, 0.02);
            if (round % 5 == 0) asset.shaping.smallPieces = {SmallPieceRule::Merge, PieceMeasure::FractionOfMean, 0.4};
            if (round % 3 == 1) asset.breakAs = BreakAs::Bonded;
            const std::optional<std::string> fault = faultOf(packOf(asset));
            QVERIFY2(!fault, (std::to_string(round) + ": " + fault.value_or("")).c_str());
        }
    }
    void everyChangeIsFound() {
        constexpr std::uint64_t kSeed = 20261126;
        constexpr int kChanges = 1000;
        Random random(kSeed);
        std::map<std::string, int> unseen;  // without the checksum
        const std::vector<std::string> packs = soundPacks();
        for (std::size_t pack = 0; pack < packs.size(); ++pack) {
            const Json sound = Json::parse(packs[pack]);
            const auto kinds = leavesByKind(sound);
            for (int change = 0; change < kChanges / 5; ++change) {
                const auto& places = kinds[static_cast<std::size_t>(change) % kinds.size()];
                const Json::json_pointer place = places[random.below(places.size())];
                Json json = sound;
                json[place] = changed(json[place], random);
                if (json == sound) continue;
                const std::string what = place.to_string() + " = " + json[place].dump();
                QVERIFY2(faultOf(json.dump()), (what + " is not found").c_str());
                const std::string kind = kindOf(place);
                if (kind == "checksum" || faultOf(withChecksum(json.dump()))) continue;
                const bool isFree = kFree.contains(kind) || (pack >= 3 && kFreeBesideGaps.contains(kind));
                QVERIFY2(isFree, (what + " contradicts nothing in pack " + std::to_string(pack)).c_str());
                ++unseen[kind];
            }
        }
        std::string text;
        for (const auto& [kind, count] : unseen) text += " " + kind + " " + std::to_string(count);
        qInfo("seed %llu; found by the checksum only:%s", static_cast<unsigned long long>(kSeed), text.c_str());
    }
    void exchangedOffsetsAreFound() {
        for (const std::string& text : soundPacks()) {
            const Json sound = Json::parse(text);
            const std::size_t count = sound["fragments"].size();
            for (std::size_t k = 0; k + 1 < count; ++k) {
                Json json = sound;
                std::swap(json["fragments"][k]["offset"], json["fragments"][k + 1]["offset"]);
                QVERIFY2(faultOf(withChecksum(json.dump())), std::to_string(k).c_str());
            }
        }
    }
    void missingNeighboursAreFound() {
        for (const std::string& text : soundPacks()) {
            Json json = Json::parse(text);
            Json& first = json["fragments"][0]["neighbours"];
            const std::size_t other = first[0]["fragment"];
            first.erase(0);
            Json& second = json["fragments"][other]["neighbours"];
            for (std::size_t k = 0; k < second.size(); ++k) {
                if (second[k]["fragment"] == 0) second.erase(k);
            }
            const std::optional<std::string> fault = faultOf(withChecksum(json.dump()));
            QVERIFY2(fault && fault->find("which is not listed as a neighbour") != std::string::npos,
                     fault.value_or("").c_str());
        }
    }
    void areasOfBothSidesAreFound() {
        for (const double factor : {1e12, 2.0, 0.5, 1e-300}) {
            for (const std::string& text : soundPacks()) {
                Json json = Json::parse(text);
                Json* largest = nullptr;  // beside a gap small ones are hidden
                std::size_t owner = 0;
                for (std::size_t k = 0; k < json["fragments"].size(); ++k) {
                    for (Json& neighbour : json["fragments"][k]["neighbours"]) {
                        if (largest && (*largest)["area"] >= neighbour["area"]) continue;
                        largest = &neighbour;
                        owner = k;
                    }
                }
                const double area = factor * (*largest)["area"].get<double>();
                for (Json& back : json["fragments"][(*largest)["fragment"].get<std::size_t>()]["neighbours"]) {
                    if (back["fragment"] == owner) back["area"] = area;
                }
                (*largest)["area"] = area;
                const std::optional<std::string> fault = faultOf(withChecksum(json.dump()));
                const bool isHidden = factor == 2.0 && json["asset"].contains("gap");
                QVERIFY2(fault || isHidden, std::to_string(factor).c_str());
            }
        }
    }
    void foundPacksAreRefused_data() {
        QTest::addColumn<QString>("sentence");
        QTest::newRow("offset-of-9e15") << "the centre of mass of its children is";
        QTest::newRow("offsets-exchanged") << "";
        QTest::newRow("whole-moved") << "the centre of mass of its children is 0.25";
        QTest::newRow("area-of-1e9") << "has a contact area of 1000000000 m²";
        QTest::newRow("area-of-5e-324") << "m² instead of";
        QTest::newRow("zero-hash") << "The hash is zero.";
    }
    void foundPacksAreRefused() {
        QFETCH(QString, sentence);
        const std::string name = std::string("found-") + QTest::currentDataTag() + ".json";
        const std::optional<std::string> fault = faultOf(*readFile(RUBBLE_SOURCE_DIR "/tests/corpus/Pack/" + name));
        QVERIFY2(fault && QString::fromStdString(*fault).contains(sentence), fault.value_or("none").c_str());
    }
    void packsOfEarlierVersionsPass() {
        for (const char* name : {"halves.json", "mortar.json", "bonded.json"}) {
            const std::string text = *readFile(std::string(RUBBLE_SOURCE_DIR "/tests/corpus/Pack/") + name);
            const std::optional<std::string> fault = faultOf(text);
            QVERIFY2(!fault, fault.value_or("").c_str());
        }
    }
};

RUBBLE_TEST(PackMutationTest)
#include "PackMutationTest.moc"
