#include "core/io/FormatVersion.h"

#include <array>

namespace rubble {

Result<std::uint32_t> versionOf(JsonDocument& document, const FileFormat& format) {
    const JsonValue root = document.root();
    if (!root.isObject()) root.requireObject({});
    for (const std::string_view key : {"format", "version"}) {
        if (!document.fault() && !root[key].isPresent()) root.refuse("the key \"" + std::string(key) + "\" is missing");
    }
    root["format"].oneOf(std::array{format.name});
    const std::uint64_t version = root["version"].wholeNumber(1);
    if (document.fault()) return *document.fault();
    if (version <= format.version) return static_cast<std::uint32_t>(version);
    return Error{ErrorCode::Unsupported, "The " + std::string(format.noun) + " is of version " +
                                             std::to_string(version) + ", but this program knows none above " +
                                             std::to_string(format.version) + "; open it with a newer one."};
}

}  // namespace rubble
