#include "app/cli/console/FileWatch.h"

#include <chrono>
#include <system_error>
#include <thread>

namespace rubble {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{200};

}  // namespace

bool FileWatch::waitForChange(const CliContext& context) {
    const bool isFirst = m_reported == Stamp();
    Stamp last;
    while (!context.cancel.isCancelled()) {
        const Stamp now = stamp();
        const bool isAtRest = now == last || isFirst;
        last = now;
        if (isAtRest && now != Stamp() && now != m_reported) {
            m_reported = now;
            return true;
        }
        std::this_thread::sleep_for(kBetweenLooks);
    }
    return false;
}

FileWatch::Stamp FileWatch::stamp() const {
    std::error_code timeError, sizeError;
    const Stamp stamp{std::filesystem::last_write_time(m_file, timeError),
                      std::filesystem::file_size(m_file, sizeError)};
    return timeError || sizeError ? Stamp() : stamp;
}

}  // namespace rubble
