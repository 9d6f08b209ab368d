#pragma once

#include "core/base/Result.h"

#include <new>
#include <stdexcept>
#include <system_error>
#include <type_traits>

namespace rubble {

/// The error of work that ran out of memory while `doing`: "exporting".
inline Error outOfMemory(const std::string& doing) {
    return {ErrorCode::Limit,
            "Out of memory while " + doing + "; use fewer fragments or smaller textures, or close other programs."};
}

/// The error of work that needs a thread while `doing`, where the system allows no more.
inline Error outOfThreads(const std::string& doing) {
    return {ErrorCode::Limit, "The system allows no more threads while " + doing +
                                  "; close other programs, or raise the limit of processes (ulimit -u)."};
}

/// The Result of work(), or outOfMemory() or outOfThreads(): what the standard library throws stays within this call.
template <class Work>
std::invoke_result_t<const Work&> orOutOfMemory(const std::string& doing, const Work& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {  // a container larger than memory can be
    } catch (const std::system_error& error) {
        if (error.code() != std::errc::resource_unavailable_try_again) throw;
        return outOfThreads(doing);
    }
    return outOfMemory(doing);
}

}  // namespace rubble
