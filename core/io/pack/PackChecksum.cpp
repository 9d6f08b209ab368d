#include "core/base/Hash.h"
#include "core/io/pack/PackFile.h"
#include "core/io/pack/PackFormat.h"

namespace rubble {
namespace {

constexpr std::string_view kKey = "\"checksum\"";  // in a string, its quotes are escaped

/// Returns where the digits of the checksum begin; npos: there are none.
std::size_t checksumAt(std::string_view json) {
    const std::size_t key = json.find(kKey);
    if (key == std::string_view::npos) return key;
    const std::size_t quote = json.find('"', key + kKey.size());
    return quote == std::string_view::npos || json.size() - quote <= kNoChecksum.size() ? std::string_view::npos
                                                                                        : quote + 1;
}

std::string checksumOf(std::string_view json, std::size_t at) {
    Hasher hasher;
    hasher.add(json.substr(0, at));
    hasher.add(kNoChecksum);
    hasher.add(json.substr(at + kNoChecksum.size()));
    return hasher.digest().hex();
}

}  // namespace

std::string withChecksum(std::string json) {
    const std::size_t at = checksumAt(json);
    if (at != std::string::npos) json.replace(at, kNoChecksum.size(), checksumOf(json, at));
    return json;
}

std::optional<std::string> verifyPackText(std::string_view json, const Pack& pack) {
    if (pack.checksum.empty()) return std::nullopt;
    const std::size_t at = checksumAt(json);
    if (at != std::string_view::npos && pack.checksum == checksumOf(json, at)) return std::nullopt;
    return "The checksum is not that of the text: the pack was changed after it was written.";
}

}  // namespace rubble
