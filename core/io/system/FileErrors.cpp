#include "core/io/system/FileErrors.h"

#include "core/base/MessageText.h"

#include <cerrno>
#include <string>
#include <system_error>

namespace rubble {

Error cannotDo(const char* verb, const std::filesystem::path& path, int code) {
    return {ErrorCode::Io, std::string("Cannot ") + verb + " " + quotedPath(path) + ": " +
                               std::generic_category().message(code) + "."};
}

Error cannotWrite(const std::filesystem::path& path, int code) { return cannotDo("write", path, code); }

Error cannotRead(const std::filesystem::path& path, int code) {
    Error error = cannotDo("read", path, code);
    if (code == ENOENT || code == ENOTDIR) error.code = ErrorCode::NotFound;
    return error;
}

Error withPath(const char* what, const std::filesystem::path& path, const Error& error) {
    return {error.code, std::string(what) + " " + quotedPath(path) + ": " + error.message};
}

Error namedAs(const std::filesystem::path& shown, const std::filesystem::path& path, Error error) {
    const std::string hidden = quotedPath(path);
    if (const std::size_t at = error.message.find(hidden); at != std::string::npos)
        error.message.replace(at, hidden.size(), quotedPath(shown));
    return error;
}

}  // namespace rubble
