#include "core/base/Hash.h"
#include "core/io/pack/PackBinary.h"
#include "core/io/pack/PackExport.h"
#include "core/io/pack/SceneFile.h"
#include "core/io/play/EventStreamFile.h"
#include "core/io/system/AtomicFile.h"
#include "tests/attack/EngineUse.h"
#include "tests/attack/Format.h"
#include "tests/attack/Mutator.h"
#include "tests/support/asset/BondedProject.h"
#include "tests/support/files/FuzzedReaders.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

namespace rubble::attack {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMisfitShare = 8;  // one in so many inputs keeps the checksum that no longer fits

template <class T>
T needed(Result<T> result) {
    if (result) return std::move(*result);
    std::fprintf(stderr, "%s\n", result.error().message.c_str());
    std::exit(2);
}

std::string schemaNamed(const std::string& name) {
    return needed(readFile(RUBBLE_SOURCE_DIR "/resources/schemas/" + name + ".schema.json"));
}

/// Bonded instances of two assets, anchored, joined by mortar or held in the air, at which everything is thrown.
Project sampleProject() {
    Project project = bondedProject();
    project.assets[0].levels[0].pattern.layers[0].parameters = UniformScatter{.count = 2};
    Asset block = boxAsset(12, 13, UniformScatter{.count = 5});
    block.name = "block";
    block.breakAs = BreakAs::Bonded;
    project.assets.push_back(block);
    project.instances.push_back({.id = 14, .name = "upper", .asset = 12, .pose = {.position = {0.0, 1.0, 0.0}}});
    project.instances.push_back({.id = 15, .name = "held", .asset = 12, .pose = {.position = {5.0, 5.0, 0.0}}});
    project.instances.back().isFixed = true;
    const Vec3 middle(1.0, 0.5, 0.25);
    project.shots = {{.id = 40, .name = "blow", .action = Hammer{middle, {0.0, 0.0, -500.0}}},
                     {.id = 41, .name = "bomb", .action = Blast{middle, 5000.0, 1.0}},
                     {.id = 42, .name = "box", .action = Throw{.kind = ProjectileKind::Asset, .asset = 2}}};
    return project;
}

/// The files of an export, and the events of playing it.
struct Sample {
    std::vector<std::string> scene;     // scene.json, then the pack.json of each of its packs
    std::vector<std::string> binaries;  // pack.bin
    std::vector<std::string> events;    // lines
};

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        lines.emplace_back(text.substr(start, end - start));
        start = end + 1;
    }
    return lines;
}

Sample sampleOf(const fs::path& folder) {
    const Project project = sampleProject();
    const auto played = needed(playScene(project, {.threads = 1}));
    const PackOptions options{.meshes = {.formats = {}}, .topology = PackTopology::Loops};
    std::vector<Id> assets;
    for (const Asset& asset : project.assets) assets.push_back(asset.id);
    needed(exportPacks(project, assets, folder / "scene", options, EditedFiles::Kept, {.threads = 1}));
    Sample sample;
    const auto add = [&](const std::string& json) { sample.scene.push_back(textOf(treeOf(json))); };
    add(sceneFileJson(project, options, played.get()));
    rubble_pack::Scene scene;
    std::string fault;
    if (!rubble_pack::parseScene(sample.scene.front(), scene, fault)) needed<int>(Error{ErrorCode::BadInput, fault});
    for (const rubble_pack::ScenePack& pack : scene.packs) {
        add(needed(readFile(folder / "scene" / pack.folder / "pack.json")));
        sample.binaries.push_back(needed(readFile(folder / "scene" / pack.folder / kPackBinaryName)));
    }
    std::vector<TimedInput> inputs;
    for (const Shot& shot : project.shots) inputs.push_back({0, ShotInput{shot.name, shot.action}});
    sample.events = linesOf(needed(eventStream(needed(Session::start(played, {.threads = 1})), inputs, 60)));
    return sample;
}

/// Lines of JSON, of which one to three are changed.
class LinesMutator {
public:
    LinesMutator(std::vector<std::string> lines, std::string_view schema) : m_lines(std::move(lines)) {
        for (const std::string& line : m_lines) m_mutators.emplace_back(std::vector{line}, schema);
    }
    std::string mutated(Random& random) const {
        std::vector<std::string> lines = m_lines;
        for (std::uint64_t changes = 1 + random.below(3); changes > 0; --changes) {
            const std::size_t from = random.below(lines.size());
            const std::size_t to = random.below(4) == 0 ? random.below(lines.size()) : from;
            lines[to] = m_mutators[from].mutated(random);
        }
        std::string text;
        for (const std::string& line : lines) (text += line) += '\n';
        return text;
    }

private:
    std::vector<std::string> m_lines;
    std::vector<JsonMutator> m_mutators;
};

/// Changes bytes, or sets aligned numbers of four bytes to others of the file; gives the result its size and checksum.
std::string mutatedBinary(const std::string& sample, Random& random) {
    constexpr std::size_t kSize = 16, kChecksum = 8, kWord = 4;
    std::string bytes = sample.substr(0, sample.size() - kChecksum);
    if (random.below(2) == 0) {
        bytes = mutatedBytes(bytes, random);
    } else {
        const auto randomWord = [&] { return kWord * random.below(bytes.size() / kWord); };
        for (std::uint64_t changes = 1 + random.below(4); changes > 0; --changes)
            bytes.replace(randomWord(), kWord, bytes.substr(randomWord(), kWord));
    }
    if (random.below(kMisfitShare) == 0 || bytes.size() < kSize + kChecksum) return bytes;
    const std::uint64_t size = bytes.size() + kChecksum;
    std::memcpy(bytes.data() + kSize, &size, sizeof(size));
    const std::uint64_t checksum = contentHash(bytes).low;
    return bytes.append(reinterpret_cast<const char*>(&checksum), sizeof(checksum));
}

/// A scene and its packs as rubble_pack.hpp reads them, a line each.
Verdict checkScene(std::string_view bytes, Random& random) {
    Verdict verdict;
    const std::vector<std::string> lines = linesOf(bytes);
    rubble_pack::Scene scene;
    verdict.isAccepted = !lines.empty() && isReadBy(rubble_pack::parseScene, lines.front(), scene, verdict.fault);
    std::vector<rubble_pack::Pack> packs(lines.empty() ? 0 : lines.size() - 1);
    for (std::size_t k = 0; k < packs.size(); ++k) {
        if (!isReadBy(rubble_pack::parse, lines[k + 1], packs[k], verdict.fault)) verdict.isAccepted = false;
    }
    for (const rubble_pack::Pack& pack : packs) {
        if (!verdict.fault && !pack.whole.hulls.empty()) verdict.fault = packUseFault(pack, random);
    }
    if (verdict.isAccepted && !verdict.fault) verdict.fault = sceneUseFault(scene, packs, random, verdict.isPlayed);
    return verdict;
}

/// A pack.bin is read by the program and by the header.
Verdict checkBinary(std::string_view bytes, Random& random) {
    Verdict verdict;
    const Result<Pack> pack = readPackBinary(bytes);
    if (!pack) verdict.fault = test::errorFault(pack.error());
    rubble_pack::BinaryPack views;
    rubble_pack::Pack read;
    const bool isOpened = isReadBy(rubble_pack::openBinary, bytes, views, verdict.fault);
    verdict.isAccepted = isReadBy(rubble_pack::parseBinary, bytes, read, verdict.fault);
    if (verdict.isAccepted && !isOpened) verdict.fault = "The header reads a pack that it does not open.";
    if (!verdict.isAccepted && pack && !verifyPack(*pack)) verdict.fault = "The header refuses a right pack.";
    if (!verdict.fault && verdict.isAccepted) verdict.fault = packUseFault(read, random);
    verdict.isPlayed = verdict.isAccepted && read.bonding;
    return verdict;
}

/// Events are read at once, and in two parts as they come over a network.
Verdict checkEvents(std::string_view bytes, Random& random) {
    Verdict verdict;
    rubble_pack::EventLog log, parts;
    verdict.isAccepted = isReadBy(rubble_pack::parseEvents, bytes, log, verdict.fault);
    const std::size_t middle = bytes.find('\n', random.below(bytes.size() + 1));
    const std::size_t first = middle < bytes.size() ? middle + 1 : bytes.size();
    const bool isAppended = isReadBy(rubble_pack::appendEvents, bytes.substr(0, first), parts, verdict.fault) &&
                            isReadBy(rubble_pack::appendEvents, bytes.substr(first), parts, verdict.fault);
    if (verdict.fault || !verdict.isAccepted) return verdict;
    if (!isAppended || parts.events.size() != log.events.size()) verdict.fault = "Two parts are not read as one text.";
    verdict.isPlayed = true;
    if (!verdict.fault) verdict.fault = eventsUseFault(log, random);
    return verdict;
}

Format linesFormat(const char* name, std::vector<std::string> lines, const std::string& schema,
                   Verdict (*check)(std::string_view, Random&)) {
    const auto mutator = std::make_shared<const LinesMutator>(std::move(lines), schema);
    return {name, ".jsonl", [mutator](Random& random) { return mutator->mutated(random); }, check};
}

}  // namespace

std::vector<Format> engineFormats(const fs::path& folder) {
    const Sample sample = sampleOf(folder);
    std::vector<Format> formats;
    formats.push_back(linesFormat("Scene", sample.scene, schemaNamed("scene"), checkScene));
    formats.push_back({"PackBinary", ".bin",
                       [binaries = sample.binaries](Random& random) {
                           return mutatedBinary(binaries[random.below(binaries.size())], random);
                       },
                       checkBinary});
    formats.push_back(linesFormat("Events", sample.events, schemaNamed("event-stream"), checkEvents));
    return formats;
}

}  // namespace rubble::attack
