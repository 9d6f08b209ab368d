#include "core/io/json/FormatVersion.h"

#include "core/base/MessageText.h"

#include <array>

namespace rubble {

Result<std::uint32_t> versionOf(JsonDocument& document, const FileFormat& format) {
    const JsonValue root = document.root();
    if (!root.isObject()) root.requireObject({});
    for (const std::string_view key : {"format", "version"}) {
        if (!document.firstError() && !root[key].isPresent()) root.fail("the key " + quotedName(key) + " is missing");
    }
    root["format"].oneOf(std::array{format.name});
    const std::uint64_t version = root["version"].wholeNumber(1);
    if (document.firstError()) return *document.firstError();
    if (version <= format.version) return static_cast<std::uint32_t>(version);
    return Error{ErrorCode::Unsupported, "The " + std::string(format.noun) + " has version " + std::to_string(version) +
                                             ", but this program reads versions up to " +
                                             std::to_string(format.version) + "; open it with a newer one."};
}

}  // namespace rubble
