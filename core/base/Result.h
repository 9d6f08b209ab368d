#pragma once

#include "core/base/Assert.h"

#include <string>
#include <utility>
#include <variant>

namespace rubble {

/// The kind of an Error, for callers and tests to distinguish.
enum class ErrorCode {
    BadInput,     // an invalid value: not finite, negative, empty, malformed
    Degenerate,   // valid numbers without the required extent: zero area, collinear points
    Crossing,     // an outline crosses or touches itself, or its rings each other
    Unsupported,  // well-formed, but of an unknown kind or version
    NotFound,     // no such name, id or file
    Io,           // reading or writing failed
    Limit,        // exceeds a limit of memory, time or count
    Cancelled,    // cancelled by the caller
    Edited,       // would overwrite what a user changed
};

/// An error as one sentence that a user can act on, with the values: "The outline crosses itself between points 4 and
/// 9."
struct Error {
    ErrorCode code = ErrorCode::BadInput;
    std::string message;
};

/// Either a T, or the Error of the function that should have returned it.
template <class T>
class [[nodiscard]] Result {
public:
    Result(const T& value) : m_state(std::in_place_index<0>, value) {}
    Result(T&& value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    bool hasValue() const { return m_state.index() == 0; }
    explicit operator bool() const { return hasValue(); }

    /// The value; requires hasValue().
    T& value() & { return checked(); }
    const T& value() const& { return const_cast<Result&>(*this).checked(); }
    T&& value() && { return std::move(checked()); }
    T& operator*() & { return checked(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(checked()); }
    T* operator->() { return &checked(); }
    const T* operator->() const { return &value(); }

    /// The error; requires !hasValue().
    const Error& error() const {
        RUBBLE_ASSERT(!hasValue());
        return std::get<1>(m_state);
    }

private:
    T& checked() {
        RUBBLE_ASSERT(hasValue());
        return std::get<0>(m_state);
    }

    std::variant<T, Error> m_state;
};

/// The result of a function that returns no value.
using Status = Result<std::monostate>;
inline Status success() { return std::monostate{}; }

}  // namespace rubble
