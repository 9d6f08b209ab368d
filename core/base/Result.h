#pragma once

#include "core/base/Assert.h"

#include <string>
#include <utility>
#include <variant>

namespace rubble {

/// What kind of fault an Error names; tests and callers tell faults apart by it.
enum class ErrorCode {
    BadInput,     // a value that no caller may pass: not finite, negative, empty, malformed
    Degenerate,   // valid numbers without the shape that is needed: zero area, all on one line
    Crossing,     // an outline crosses or touches itself, or two of its rings do
    Unsupported,  // well-formed, but of a kind or version this program does not know
    NotFound,     // a name, an id or a file that is not there
    Io,           // the system refused to read or write
    Limit,        // more memory, time or elements than allowed
    Cancelled,    // the caller asked to stop
};

/// A fault in one sentence that a user can act on, with the values in it:
/// "The outline crosses itself between points 4 and 9."
struct Error {
    ErrorCode code = ErrorCode::BadInput;
    std::string message;
};

/// Either a T or the Error that kept it from being made.
template <class T>
class [[nodiscard]] Result {
public:
    Result(T value) : m_state(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : m_state(std::in_place_index<1>, std::move(error)) {}

    bool hasValue() const { return m_state.index() == 0; }
    explicit operator bool() const { return hasValue(); }

    /// The value; only where hasValue().
    T& value() & { return checked(); }
    const T& value() const& { return const_cast<Result&>(*this).checked(); }
    T&& value() && { return std::move(checked()); }
    T& operator*() & { return checked(); }
    const T& operator*() const& { return value(); }
    T&& operator*() && { return std::move(checked()); }
    T* operator->() { return &checked(); }
    const T* operator->() const { return &value(); }

    /// The fault; only where not hasValue().
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

/// What a function gives that either succeeds or fails and has nothing else to say.
using Status = Result<std::monostate>;
inline Status success() { return std::monostate{}; }

}  // namespace rubble
