#pragma once

#include "editor/background/Derived.h"

#include <new>

namespace rubble::test {

/// What the error of anything derived says for which memory ran out.
inline const QString kOutOfMemory = QStringLiteral("Out of memory while ");

/// Makes a derived result fail: memory runs out in the background.
template <class Value>
void runOutOfMemory(Derived<Value>& derived) {
    using Made = Derived<Value>;
    derived.request([]() -> Result<typename Made::Work> {
        return typename Made::Work(
            [](const TaskContext&, const typename Made::Publish&) -> Result<Value> { throw std::bad_alloc(); });
    });
}

/// The same with an error that says `sentence`.
template <class Value>
void failWith(Derived<Value>& derived, const std::string& sentence) {
    using Made = Derived<Value>;
    derived.request([sentence]() -> Result<typename Made::Work> {
        return typename Made::Work([sentence](const TaskContext&, const typename Made::Publish&) -> Result<Value> {
            return Error{ErrorCode::BadInput, sentence};
        });
    });
}

}  // namespace rubble::test
