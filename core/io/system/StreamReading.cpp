#include "core/io/system/StreamReading.h"

#include "core/base/MessageText.h"
#include "core/io/system/FileErrors.h"
#include "core/io/system/OpenFile.h"

#include <poll.h>

#include <array>
#include <cerrno>

namespace rubble {
namespace {

constexpr std::size_t kMaxSize = std::size_t{1} << 30;  // bytes, as of files
constexpr int kReadPollMilliseconds = 50;               // latency of a cancellation

}  // namespace

Result<std::string> readStream(int descriptor, const std::filesystem::path& name, const CancelToken& cancel) {
    std::string bytes;
    std::array<char, 65536> buffer;
    while (!cancel.isCancelled()) {
        // A pipe that no program has opened for writing yet is not at its end: read() would not wait for one.
        pollfd polled{descriptor, POLLIN, 0};
        if (::poll(&polled, 1, kReadPollMilliseconds) <= 0) continue;
        const ssize_t count = ::read(descriptor, buffer.data(), buffer.size());
        if (count < 0 && (errno == EINTR || errno == EAGAIN)) continue;
        if (count < 0) return cannotRead(name, errno);
        if (count == 0) return bytes;
        bytes.append(buffer.data(), static_cast<std::size_t>(count));
        if (bytes.size() > kMaxSize)
            return Error{ErrorCode::Limit, "Cannot read " + quotedPath(name) + ": it is larger than 1 GiB."};
    }
    return TaskContext::cancelled();
}

Result<std::string> readFileOrStream(const std::filesystem::path& path, const CancelToken& cancel) {
    const OpenFile file(path, O_RDONLY | O_NONBLOCK);
    if (!file.isOpen()) return cannotRead(path, errno);
    return readStream(file.descriptor(), path, cancel);
}

}  // namespace rubble
