#include "core/io/play/StateFile.h"

#include "core/base/MessageText.h"
#include "core/io/play/ReplayFile.h"
#include "core/io/play/StateArchive.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/Compression.h"
#include "core/io/system/FileErrors.h"
#include "core/io/system/FolderReading.h"
#include "core/physics/state/Contacts.h"
#include "core/play/state/SessionFields.h"

namespace rubble {

template <FieldsOf<RestingPose> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [centre, rotation] = self;
    visit("centre", centre);
    visit("rotation", rotation);
}

template <FieldsOf<RestingWorld> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [gravity, sleeping, poses] = self;
    visit("gravity", gravity);
    visit("sleeping", sleeping);
    visit("poses", poses);
}

template <FieldsOf<SavedSession> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [dt, bakes, hash, state, world] = self;
    visit("dt", dt);
    visit("bakes", bakes);
    visit("hash", hash);
    visitFields(state, visit);
    visit("world", world);
}

namespace {

constexpr std::string_view kMagic = "RBLSTATE";

// Fields that files of older versions do not have, the latest first.
constexpr std::string_view kAddedNames[] = {
    "cutHeight",                                                     // version 5: cuts of meshes
    "isBullet",     "predictions", "obstacleSizes",    "gapNormal",  // version 4: gaps along their axis
    "dividedUntil",  // version 3: what is at rest, and the time after a break
    "heldLevel",    "heldUntil",   "restDisplacement", "restRotation", "stayReach",    "stayPath",
    "structures",  // version 2: bonds
    "structure",    "bondedNodes", "isHeld",           "collapseStep", "partialDamage"};
constexpr std::size_t kAddedInVersion5 = 1, kAddedInVersion4 = 4, kAddedInVersion3 = 7;

/// The fields that files of a version do not have.
std::span<const std::string_view> absentIn(std::uint32_t version) {
    const std::span<const std::string_view> added = kAddedNames;
    if (version >= 5) return {};
    if (version == 4) return added.first(kAddedInVersion5);
    if (version == 3) return added.first(kAddedInVersion5 + kAddedInVersion4);
    return version == 2 ? added.first(kAddedInVersion5 + kAddedInVersion4 + kAddedInVersion3) : added;
}

/// The oldest version from 4 on that has all fields of a state that are not zero, so that older programs read it.
std::uint32_t versionOf(const SavedSession& saved) {
    const bool hasHeight = std::ranges::any_of(
        saved.state.damage, [](const auto& one) { return one.second.cut && !one.second.cut->isInPlane(); });
    return hasHeight ? 5 : 4;
}

/// What a file starts with.
struct StateHeader {
    std::uint32_t version = kStateVersion;
    StateKind kind = StateKind::Whole;
    ContentHash scene;
    std::uint64_t size = 0;  // bytes of the fields
};
constexpr std::size_t kHeaderBytes = 8 + 4 + 1 + 16 + 8;
constexpr std::size_t kChecksumBytes = 16;

template <FieldsOf<StateHeader> Self, class Visit>
void visitFields(Self& self, Visit& visit) {
    auto& [version, kind, scene, size] = self;
    visit("version", version);
    visit("kind", kind);
    visit("scene", scene);
    visit("size", size);
}

template <class T>
std::string bytesOf(const T& value) {
    StateWriter writer;
    writer("", value);
    return writer.take();
}

/// The value of bytes of fixed size.
template <class T>
T valueOf(std::string_view bytes) {
    T value;
    StateReader reader(bytes);
    reader("", value);
    return value;
}

Error unreadable(const std::string& what) {
    return {ErrorCode::BadInput, "The state cannot be read: " + what + "; save it again."};
}

Result<std::string> fieldsOf(std::string_view packed, std::uint64_t size) {
    if (size > kMaxStateBytes) {
        return Error{ErrorCode::Limit, "The state takes " + std::to_string(size) + " bytes, but at most " +
                                           std::to_string(kMaxStateBytes) + " are read."};
    }
    Result<std::string> bytes = uncompressed(packed, size);
    if (!bytes) return unreadable(bytes.error().message);
    return bytes;
}

/// Checks everything before the fields.
Result<StateHeader> readHeader(std::string_view bytes, ContentHash scene) {
    if (!bytes.starts_with(kMagic)) return Error{ErrorCode::BadInput, "This is not a Rubble state."};
    if (bytes.size() < kHeaderBytes + kChecksumBytes) return unreadable("it is cut off");
    const auto header = valueOf<StateHeader>(bytes.substr(kMagic.size(), kHeaderBytes - kMagic.size()));
    if (header.version == 0 || header.version > kStateVersion) {
        return Error{ErrorCode::Unsupported, "The state is of version " + std::to_string(header.version) +
                                                 ", but only version " + std::to_string(kStateVersion) +
                                                 " can be read; use a newer version of Rubble."};
    }
    const std::string_view content = bytes.substr(0, bytes.size() - kChecksumBytes);
    if (valueOf<ContentHash>(bytes.substr(content.size())) != contentHash(content)) {
        return unreadable("its checksum does not fit, so bytes were changed or are missing");
    }
    if (header.kind != StateKind::Whole && header.kind != StateKind::Small) return unreadable("its kind is unknown");
    if (header.scene != scene) {
        return Error{ErrorCode::BadInput,
                     "The state was saved from another scene, or from another version of this "
                     "one: its hash is " +
                         header.scene.hex() + ", that of the scene " + scene.hex() +
                         ". With the project as it was, rubble-cli simulate --remap takes its damage."};
    }
    return header;
}

std::uint64_t sizeOfFields(std::string_view bytes) {
    return valueOf<StateHeader>(bytes.substr(kMagic.size(), kHeaderBytes - kMagic.size())).size;
}

}  // namespace

std::string stateBytes(const SavedSession& saved, ContentHash scene) {
    const std::uint32_t version = versionOf(saved);
    StateWriter writer(absentIn(version));
    visitFields(saved, writer);
    const std::string fields = writer.take();
    std::string bytes(kMagic);
    bytes += bytesOf(StateHeader{.version = version, .kind = saved.kind(), .scene = scene, .size = fields.size()});
    bytes += compressed(fields);
    return bytes + bytesOf(contentHash(bytes));
}

Result<SavedSession> readStateBytes(std::string_view bytes, ContentHash scene) {
    const Result<StateHeader> header = readHeader(bytes, scene);
    if (!header) return header.error();
    const std::size_t packed = bytes.size() - kHeaderBytes - kChecksumBytes;
    const Result<std::string> fields = fieldsOf(bytes.substr(kHeaderBytes, packed), header->size);
    if (!fields) return fields.error();
    SavedSession saved;
    StateReader reader(*fields, absentIn(header->version));
    visitFields(saved, reader);
    reader.finish();
    if (reader.fault()) return unreadable(*reader.fault());
    if (auto* world = std::get_if<WorldState>(&saved.world); world != nullptr && header->version < 4)
        forgetPredictions(*world);
    if (saved.kind() != header->kind) return unreadable("its kind is not that of its world");
    return saved;
}

Status saveState(const std::filesystem::path& path, const SavedSession& saved, ContentHash scene) {
    const std::string bytes = stateBytes(saved, scene);
    if (sizeOfFields(bytes) <= kMaxStateBytes) return writeFileAtomically(path, bytes);
    return withPath(
        "Cannot write", path,
        {ErrorCode::Limit, "The state takes " + std::to_string(sizeOfFields(bytes)) + " bytes, but at most " +
                               std::to_string(kMaxStateBytes) + " are read back; save a small state."});
}

Status saveState(const std::filesystem::path& path, const Session& session, StateKind kind) {
    return saveState(path, savedSession(session, kind), sceneHash(session.scene().project));
}

Result<SavedSession> loadSavedSession(const std::filesystem::path& path, ContentHash scene) {
    const Result<std::string> bytes = readFile(path);
    if (!bytes) return bytes.error();
    Result<SavedSession> saved = readStateBytes(*bytes, scene);
    if (!saved) return withPath("Cannot read", path, saved.error());
    return saved;
}

Result<std::shared_ptr<const SavedSession>> loadStart(const PlayTest& test, const std::filesystem::path& folder,
                                                      ContentHash scene) {
    if (test.state.empty()) return std::shared_ptr<const SavedSession>();
    const std::filesystem::path path = folder / test.state;
    if (isLink(path)) {
        return Error{ErrorCode::BadInput,
                     "Test " + quotedName(test.name) + ": " + quotedPath(path) +
                         " is a link, which may lead to any file; replace it by the state itself."};
    }
    Result<SavedSession> saved = loadSavedSession(path, scene);
    if (!saved) return Error{saved.error().code, "Test " + quotedName(test.name) + ": " + saved.error().message};
    return std::make_shared<const SavedSession>(std::move(*saved));
}

Result<Session> loadState(const std::filesystem::path& path, std::shared_ptr<const PlayScene> scene,
                          const SessionSettings& settings) {
    Result<SavedSession> saved = loadSavedSession(path, sceneHash(scene->project));
    if (!saved) return saved.error();
    Result<Session> session = resumedSession(std::move(scene), std::move(*saved), settings);
    if (!session) return withPath("Cannot read", path, session.error());
    return session;
}

}  // namespace rubble
