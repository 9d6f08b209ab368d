#pragma once

#include "core/base/Result.h"

#include <new>
#include <stdexcept>
#include <type_traits>

namespace rubble {

/// The error of work that ran out of memory while `doing`: "exporting".
inline Error outOfMemory(const std::string& doing) {
    return {ErrorCode::Limit, "Out of memory while " + doing + "; use fewer fragments, or close other programs."};
}

/// The Result of work(), or outOfMemory(): what the standard library throws stays within this call.
template <class Work>
std::invoke_result_t<const Work&> orOutOfMemory(const std::string& doing, const Work& work) {
    try {
        return work();
    } catch (const std::bad_alloc&) {
    } catch (const std::length_error&) {  // a container larger than memory can be
    }
    return outOfMemory(doing);
}

}  // namespace rubble
