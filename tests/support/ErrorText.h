#pragma once

#include "core/base/Result.h"

#include <string>

namespace rubble {

/// The message of a result's error; empty if it has a value.
template <class T>
std::string errorText(const Result<T>& result) {
    return result ? std::string() : result.error().message;
}

}  // namespace rubble
