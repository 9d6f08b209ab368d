#pragma once

#include "core/base/Result.h"

#include <memory>

namespace rubble {

/// An OpenGL context that needs no display: pictures are drawn to framebuffers of one's own. Current, in the thread that
/// made it, as long as it lives.
class SurfacelessContext {
public:
    /// Errors: Unsupported, with the reason, where there is no OpenGL 3.3 to be had by EGL.
    static Result<std::unique_ptr<SurfacelessContext>> made();
    ~SurfacelessContext();

private:
    struct State;
    explicit SurfacelessContext(std::unique_ptr<State> state);
    std::unique_ptr<State> m_state;
};

}  // namespace rubble
