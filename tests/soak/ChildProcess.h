#pragma once

#include "tests/soak/PlayedCase.h"

namespace rubble::soak {

/// The names of what a process finds that does not end by itself.
inline constexpr const char* kCrash = "crash";
inline constexpr const char* kHang = "hang";

/// A case that is played in a process of its own, so that a crash is a finding as others are.
class ChildRun {
public:
    /// Starts it; see playedCase().
    ChildRun(const SoakCase& one, const std::string& invariant = {});
    ~ChildRun();
    ChildRun(const ChildRun&) = delete;
    ChildRun& operator=(const ChildRun&) = delete;

    /// What it found, once it has ended.
    std::optional<Outcome> ended();
    /// Waits for it.
    Outcome finished();

private:
    struct Shared;
    Outcome outcomeOf(int status) const;

    int m_process = 0;
    int m_errors = -1;  // a file without a name
    Shared* m_shared = nullptr;
    bool m_hasEnded = false;
};

}  // namespace rubble::soak
