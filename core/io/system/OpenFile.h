#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <filesystem>

namespace rubble {

/// Owns a file descriptor.
class OpenFile {
public:
    explicit OpenFile(int descriptor = -1) : m_descriptor(descriptor) {}
    OpenFile(const std::filesystem::path& path, int flags, mode_t permissions = 0)
        : m_descriptor(::open(path.c_str(), flags | O_CLOEXEC | O_NOCTTY, permissions)) {}
    ~OpenFile() { static_cast<void>(close()); }
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;
    OpenFile(OpenFile&& other) noexcept : m_descriptor(other.m_descriptor) { other.m_descriptor = -1; }
    OpenFile& operator=(OpenFile&&) = delete;

    bool isOpen() const { return m_descriptor >= 0; }
    int descriptor() const { return m_descriptor; }
    /// Closes the file, if it is open, and returns 0 or -1 with errno.
    int close() {
        const int closed = m_descriptor < 0 ? 0 : ::close(m_descriptor);
        m_descriptor = -1;
        return closed;
    }

private:
    int m_descriptor;
};

}  // namespace rubble
