#pragma once

#include "app/cli/console/CliContext.h"

#include <cstdint>
#include <filesystem>
#include <utility>

namespace rubble {

/// Waits for changes of a file: of its time or size, also where it is replaced by another one. A change of neither is
/// not noticed.
class FileWatch {
public:
    explicit FileWatch(std::filesystem::path file) : m_file(std::move(file)) {}

    /// Waits until the file is there, differs from how it was when this returned last, and was not changed for 0.2 s,
    /// so that a file which is being written is not read. The first time it returns as soon as the file is there. False
    /// once the program is interrupted.
    bool waitForChange(const CliContext& context);

private:
    /// When a file was changed; the default: there is none.
    struct Stamp {
        std::filesystem::file_time_type time = std::filesystem::file_time_type::min();
        std::uintmax_t size = 0;
        bool operator==(const Stamp&) const = default;
    };
    Stamp stamp() const;

    std::filesystem::path m_file;
    Stamp m_reported;
};

}  // namespace rubble
